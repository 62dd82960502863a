// AccuracyPanel: what each accuracy would take, as the planner predicts it, and what it would leave out; the
// work-precision chart of the open project, by the stage `study`.
#pragma once

#include <QStringList>
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
  /// The accuracies that are offered: "10 %" …
  static const QStringList& choices();
  /// The project that is asked about. Predictions hold whatever accuracy it asks for itself.
  void setSource(const Source& source);
  void estimate();
  /// Draws the work-precision chart, in about so many seconds; it goes on where an earlier one ended.
  void study(int seconds);
  [[nodiscard]] Paper& chart() { return *chart_; }
  [[nodiscard]] int estimates() const { return known_; }

 Q_SIGNALS:
  void accuracyChosen(const QString& accuracy);
  /// What one of the choices would take, in words; "": not known any more.
  void predicted(const QString& accuracy, const QString& time);

 private:
  void take(int row, const pipeline::StageReport& report);
  void showWords();

  JobQueue& jobs_;
  Source source_;
  std::string asked_;  ///< the project's text without its accuracy
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
