// PlanView: a grid's illuminance in plan, in false colour with labelled isolux lines; what `goniolux plot` draws, sharp
// at every size, with the value under the mouse. A line drawn with the mouse is where a section is wanted. Drawn on a
// thread of its own.
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "app/gui/jobs/calculations.h"
#include "app/gui/jobs/worker.h"
#include "app/gui/plots/false_colour.h"
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
  /// Values of the isolux lines; empty: chosen from the results.
  void setLevels(const std::vector<double>& levels);
  /// What is chosen of the colours.
  [[nodiscard]] const FalseColour& scale() const { return scale_; }
  [[nodiscard]] const QString& grid() const { return grid_; }
  [[nodiscard]] bool isDrawn() const { return !picture_.isNull(); }

  /// What is drawn, for charts beside it: the map with the half-widths of its points; null when there is none.
  struct Content {
    plot::PlanMap map;
    std::vector<double> halfWidths;
  };
  [[nodiscard]] std::shared_ptr<const Content> content() const;
  /// The line that was drawn, in the map's metres.
  struct Line {
    core::Vec2 from{0}, to{0};
  };
  [[nodiscard]] const std::optional<Line>& section() const { return section_; }
  /// Where a place of the map is in the widget.
  [[nodiscard]] QPoint toWidget(const core::Vec2& place) const;

  /// Writes the page as it is now as a PNG or PDF file, on any thread; throws core::RunError. Null: there is none yet.
  [[nodiscard]] std::function<void()> exportOf(const QString& file) const;

 Q_SIGNALS:
  void pointed(const QString& words);
  void drawn();
  void sectionDrawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  struct Drawn {
    QImage picture;
    Content content;
    plot::MapLayout layout;
  };
  [[nodiscard]] core::Vec2 toMap(const QPoint& at) const;
  void draw();
  void take(const std::shared_ptr<const Drawn>& drawn);
  [[nodiscard]] const project::GridResult* result() const;

  GridsOutcome outcome_;
  QString grid_;
  FalseColour scale_;
  bool isBusy_ = false, isStale_ = false;
  QImage picture_;
  std::shared_ptr<const Drawn> drawn_;
  std::optional<Line> section_;
  bool isDrawingSection_ = false;
  QTimer wait_;
  Worker worker_;
};

}  // namespace goniolux::gui
