// Paper: a page of the plots' painters (polar diagram, photometric solid, curves), drawn to fit.
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "app/gui/jobs/latest.h"
#include "plot/line_chart.h"
#include "plot/photometric_solid.h"
#include "plot/polar.h"
#include "plot/vtk/ink.h"

namespace goniolux::gui {

/// Something that paints itself on a page of a size of its own, pixels.
struct Sheet {
  int width = 0, height = 0;
  std::function<void(plot::Ink&)> paint;
};
Sheet sheetOf(const plot::PolarDiagram& diagram);
Sheet sheetOf(const plot::PhotometricSolid& solid);
Sheet sheetOf(const plot::LineChart& chart);
/// For a narrow place: its words are larger beside the curves.
Sheet smallSheetOf(const plot::LineChart& chart);

class Paper final : public QWidget {
  Q_OBJECT
 public:
  explicit Paper(const QString& hint, QWidget* parent = nullptr);
  /// `make` runs on the drawing thread; what it throws becomes the hint.
  void show(std::function<Sheet()> make);
  void clear();
  [[nodiscard]] bool isDrawn() const { return !picture_.isNull(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Drawn {
    QImage picture;
    QString failure;
  };
  void draw();

  QString hint_, failure_;
  std::function<Sheet()> make_;
  QImage picture_;
  QTimer wait_;
  Latest<Drawn> drawing_;
};

}  // namespace goniolux::gui
