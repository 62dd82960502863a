#include "app/gui/window/jobs_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSplitter>
#include <QTime>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>

#include "app/gui/window/theme.h"

namespace goniolux::gui {
namespace {

QString stateText(const Job& job) {
  switch (job.state()) {
    case Job::State::waiting:
      return JobsPanel::tr("waiting");
    case Job::State::running:
      return QString("%1 %").arg(100 * job.fraction(), 0, 'f', 0);
    case Job::State::paused:
      return JobsPanel::tr("paused at %1 %").arg(100 * job.fraction(), 0, 'f', 0);
    case Job::State::done:
      return JobsPanel::tr("done");
    case Job::State::stopped:
      return JobsPanel::tr("stopped");
    case Job::State::failed:
      return JobsPanel::tr("failed");
  }
  return {};
}

}  // namespace

QString secondsText(double seconds) {
  if (seconds < 0 || !std::isfinite(seconds)) return {};
  if (seconds < 10) return QString("%1 s").arg(seconds, 0, 'f', 1);
  if (seconds < 90) return QString("%1 s").arg(seconds, 0, 'f', 0);
  if (seconds < 5400) return QString("%1 min").arg(seconds / 60, 0, 'f', 0);
  return QString("%1 h").arg(seconds / 3600, 0, 'f', 1);
}

JobsPanel::JobsPanel(JobQueue& jobs, QWidget* parent) : QWidget(parent), jobs_(jobs) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* split = new QSplitter(Qt::Horizontal, this);
  layout->addWidget(split);
  list_ = new QTreeWidget(split);
  list_->setObjectName("jobs");
  list_->setHeaderLabels({tr("Job"), tr("State"), tr("Time"), tr("Left"), tr("What is reached")});
  list_->setRootIsDecorated(false);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->header()->resizeSection(0, 200);
  log_ = new QPlainTextEdit(split);
  log_->setObjectName("log");
  log_->setReadOnly(true);
  log_->setMaximumBlockCount(2000);
  log_->setFrameShape(QFrame::NoFrame);
  log_->setPlaceholderText(tr("Messages of the engine appear here."));
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 2);
  connect(&jobs_, &JobQueue::added, this, &JobsPanel::add);
  connect(&jobs_, &JobQueue::progressed, this, &JobsPanel::refresh);
  connect(list_, &QTreeWidget::customContextMenuRequested, this, &JobsPanel::showMenu);
}

void JobsPanel::log(const QString& message) {
  log_->appendPlainText(QTime::currentTime().toString("HH:mm:ss  ") + message.trimmed());
}

void JobsPanel::add(Job* job) {
  auto* item = new QTreeWidgetItem;
  item->setText(0, job->title());
  item->setData(0, Qt::UserRole, QVariant::fromValue(static_cast<QObject*>(job)));
  list_->insertTopLevelItem(0, item);
  connect(job, &Job::noted, this, &JobsPanel::log);
  connect(job, &Job::over, this, [this, job] {
    log(job->failure().isEmpty() ? tr("%1: %2 (%3)").arg(job->title(), stateText(*job), secondsText(job->seconds()))
                                 : tr("%1 failed: %2").arg(job->title(), job->failure()));
  });
  refresh(job);
}

void JobsPanel::refresh(Job* job) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(i);
    if (item->data(0, Qt::UserRole).value<QObject*>() != job) continue;
    item->setText(1, stateText(*job));
    item->setText(2, secondsText(job->seconds()));
    item->setText(3, job->isOver() ? QString() : secondsText(job->secondsLeft()));
    item->setText(4, job->failure().isEmpty() ? job->reached() : job->failure());
    item->setToolTip(4, item->text(4));
    item->setForeground(1, job->state() == Job::State::failed ? theme().fail : theme().text);
  }
}

void JobsPanel::showMenu(const QPoint& at) {
  const QTreeWidgetItem* item = list_->itemAt(at);
  if (item == nullptr) return;
  auto* job = qobject_cast<Job*>(item->data(0, Qt::UserRole).value<QObject*>());
  QMenu menu(this);
  if (!job->isOver()) menu.addAction(tr("Stop"), job, &Job::stop);
  if (!job->commandLine().isEmpty())
    menu.addAction(tr("Copy as command line"), job, [job] { QApplication::clipboard()->setText(job->commandLine()); });
  if (!menu.isEmpty()) menu.exec(list_->viewport()->mapToGlobal(at));
}

}  // namespace goniolux::gui
