// AccuracyPanel: what each accuracy would take, as the planner predicts it, and what it would leave out; the
// work-precision chart of the open project, by the stage `study`.
#pragma once

#include <QTemporaryDir>
#include <QWidget>

#include "app/gui/jobs/calculations.h"
#include "app/gui/jobs/job_queue.h"

class QLabel;
class QPushButton;
class QSpinBox;
class QTabWidget;
class QTreeWidget;

namespace goniolux::gui {

class Paper;

class AccuracyPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit AccuracyPanel(JobQueue& jobs, QWidget* parent = nullptr);
  /// The project that is asked about.
  void setSource(const Source& source);
  void estimate();
  /// Draws the work-precision chart, in about so many seconds; it goes on where an earlier one ended.
  void study(int seconds);
  [[nodiscard]] Paper& chart() { return *chart_; }
  [[nodiscard]] int estimates() const { return known_; }

 Q_SIGNALS:
  void accuracyChosen(const QString& accuracy);

 private:
  void take(int row, const pipeline::StageReport& report);

  JobQueue& jobs_;
  Source source_;
  QTreeWidget* table_;
  QLabel* words_;
  QPushButton *ask_, *draw_;
  QSpinBox* seconds_;
  QTabWidget* tabs_;
  Paper* chart_;
  QTemporaryDir studies_;
  int known_ = 0;
};

}  // namespace goniolux::gui
