// PlanView: a grid's illuminance in plan, in false colour with labelled isolux lines; what `goniolux plot` draws, sharp
// at every size, with the value under the mouse. Drawn on a thread of its own.
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "app/gui/jobs/calculations.h"
#include "app/gui/jobs/worker.h"
#include "plot/figure.h"
#include "plot/map_layout.h"

namespace goniolux::gui {

class PlanView final : public QWidget {
  Q_OBJECT
 public:
  explicit PlanView(QWidget* parent = nullptr);

  void show(const GridsOutcome& outcome);
  void clear();
  void setGrid(const QString& name);
  void setPalette(const std::string& palette);
  void setBanded(bool banded);
  [[nodiscard]] const QString& grid() const { return grid_; }
  [[nodiscard]] bool isDrawn() const { return !picture_.isNull(); }

  /// The page as it is, as a PNG or PDF file. A sentence why not, "" when it is written.
  [[nodiscard]] QString exportTo(const QString& file) const;

 Q_SIGNALS:
  void pointed(const QString& words);
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  struct Drawn {
    QImage picture;
    plot::PlanMap map;
    plot::MapLayout layout;
    std::vector<double> halfWidths;
  };
  void draw();
  void take(const std::shared_ptr<const Drawn>& drawn);
  [[nodiscard]] const project::GridResult* result() const;

  GridsOutcome outcome_;
  QString grid_;
  std::string palette_ = "viridis";
  bool banded_ = true, isBusy_ = false, isStale_ = false;
  QImage picture_;
  std::shared_ptr<const Drawn> drawn_;
  QTimer wait_;
  Worker worker_;
};

}  // namespace goniolux::gui
