// AccuracyPanel: what each accuracy would take, as the planner predicts it, and what it would leave out.
#pragma once

#include <QWidget>

#include "app/gui/jobs/calculations.h"
#include "app/gui/jobs/job_queue.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace goniolux::gui {

class AccuracyPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit AccuracyPanel(JobQueue& jobs, QWidget* parent = nullptr);
  /// The project that is asked about.
  void setSource(const Source& source);
  void estimate();
  [[nodiscard]] int estimates() const { return known_; }

 Q_SIGNALS:
  void accuracyChosen(const QString& accuracy);

 private:
  void take(int row, const pipeline::StageReport& report);

  JobQueue& jobs_;
  Source source_;
  QTreeWidget* table_;
  QLabel* words_;
  QPushButton* ask_;
  int known_ = 0;
};

}  // namespace goniolux::gui
