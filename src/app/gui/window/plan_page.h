// PlanPage: the plan view with the choice of its grid and colours.
#pragma once

#include <QWidget>

#include "app/gui/plots/plan_view.h"

class QComboBox;

namespace goniolux::gui {

class PlanPage final : public QWidget {
  Q_OBJECT
 public:
  explicit PlanPage(QWidget* parent = nullptr);
  void show(const GridsOutcome& outcome);
  void clear();
  void setGrid(const QString& name);
  [[nodiscard]] PlanView& view() { return *view_; }

 Q_SIGNALS:
  void exportRequested();

 private:
  QComboBox* grids_;
  PlanView* view_;
};

}  // namespace goniolux::gui
