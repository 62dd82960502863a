// JobsPanel: what was asked of the engine, how far it is, and the log.
#pragma once

#include <QWidget>

#include "app/gui/jobs/job_queue.h"

class QPlainTextEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace goniolux::gui {

class JobsPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit JobsPanel(JobQueue& jobs, QWidget* parent = nullptr);
  void log(const QString& message);

 private:
  void add(Job* job);
  void refresh(Job* job);
  void showMenu(const QPoint& at);

  JobQueue& jobs_;
  QTreeWidget* list_;
  QPlainTextEdit* log_;
};

/// "3 s", "2 min 5 s"; "" for a time that is not known.
QString secondsText(double seconds);

}  // namespace goniolux::gui
