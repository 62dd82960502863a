// PlanPage: the plan view with the choice of its grid and colours; beside it the section along a line drawn in it, the
// histogram, and the points with their half-widths.
#pragma once

#include <QWidget>

#include "app/gui/plots/plan_view.h"

class QComboBox;
class QTabWidget;
class QLineEdit;
class QTableView;

namespace goniolux::gui {

class Paper;
class ValuesModel;

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
  /// Colours or levels were chosen.
  void scaleChanged();

 private:
  void showCharts();
  void showSection();
  void takeLevels();

  QComboBox* grids_;
  PlanView* view_;
  QTabWidget* charts_;
  Paper *section_, *histogram_;
  QTableView* values_;
  ValuesModel* model_;
  QLineEdit* levels_;
};

}  // namespace goniolux::gui
