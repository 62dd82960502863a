// PlanPage: the plan view with the choice of its grid and colours; beside it the section along a line drawn in it, the
// histogram, and the points with their half-widths.
#pragma once

#include <QWidget>

#include "app/gui/plots/plan_view.h"

class QComboBox;
class QTabWidget;
class QTreeWidget;

namespace goniolux::gui {

class Paper;

class PlanPage final : public QWidget {
  Q_OBJECT
 public:
  explicit PlanPage(QWidget* parent = nullptr);
  void show(const GridsOutcome& outcome);
  void clear();
  void setGrid(const QString& name);
  [[nodiscard]] PlanView& view() { return *view_; }
  [[nodiscard]] Paper& section() { return *section_; }
  [[nodiscard]] Paper& histogram() { return *histogram_; }

 Q_SIGNALS:
  void exportRequested();

 private:
  void showCharts();
  void showSection();
  void showValues();

  QComboBox* grids_;
  PlanView* view_;
  QTabWidget* charts_;
  Paper *section_, *histogram_;
  QTreeWidget* values_;
};

}  // namespace goniolux::gui
