// The main window's jobs: calculating the grids, and showing what comes of it.
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>

#include "app/gui/plots/drawing_lock.h"
#include "app/gui/room/grid_overlay.h"
#include "app/gui/window/jobs_panel.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/picture_page.h"
#include "app/gui/window/plan_page.h"
#include "app/gui/window/results_panel.h"
#include "app/gui/window/room_page.h"
#include "app/gui/window/text_panel.h"

namespace goniolux::gui {

Source MainWindow::source() const {
  return {document_.text(), document_.file().toStdString()};
}

Job* MainWindow::calculate() {
  if (!document_.isOpen()) return nullptr;
  text_->commit();
  const quint64 revision = document_.revision();
  Job* job = jobs_->start(tr("Calculate the grids"), gridsWork(source(), [this, revision](const GridsOutcome& outcome) {
                            showGrids(revision, outcome);
                          }));
  pipeline::StageRequest request;
  request.inputs = {document_.folder().toStdString()};
  job->setCommandLine(commandLine("illuminate", request));
  updateActions();
  return job;
}

Job* MainWindow::render(const QString& view) {
  if (!document_.isOpen() || view.isEmpty()) return nullptr;
  text_->commit();
  const QString folder = document_.isModified() ? drafts_.path() : document_.folder() + "/results";
  Job* job = jobs_->start(tr("Render “%1”").arg(view),
                          renderWork(source(), view.toStdString(), folder.toStdString(), picturePage_->wantsSpectra(),
                                     [this](const RenderOutcome& outcome) { showRendering(outcome); }));
  pipeline::StageRequest request;
  request.inputs = {document_.folder().toStdString()};
  request.options["view"] = view.toStdString();
  if (picturePage_->wantsSpectra()) request.options["channels"] = spectralChannels;
  job->setCommandLine(commandLine("render", request));
  pages_->setCurrentWidget(picturePage_);
  updateActions();
  return job;
}

void MainWindow::copyCommandLine() {
  // The last job that a command does as well.
  for (auto job = jobs_->jobs().rbegin(); job != jobs_->jobs().rend(); ++job) {
    if ((*job)->commandLine().isEmpty()) continue;
    QApplication::clipboard()->setText((*job)->commandLine());
    statusBar()->showMessage(tr("Copied: %1").arg((*job)->commandLine()), 6000);
    return;
  }
  statusBar()->showMessage(tr("Nothing has been calculated yet."), 4000);
}

void MainWindow::showRendering(const RenderOutcome& outcome) {
  if (document_.isOpen()) picturePage_->show(outcome);
}

void MainWindow::loadEarlierResults() {
  const quint64 revision = document_.revision();
  jobs_->start(tr("Look for earlier results"),
               earlierResultsWork(source(), [this, revision](const GridsOutcome& outcome) {
                 if (!outcome_.results) showGrids(revision, outcome);
               }));
}

void MainWindow::showGrids(quint64 revision, const GridsOutcome& outcome) {
  if (!document_.isOpen()) return;
  outcome_ = outcome;
  outcomeRevision_ = revision;
  resultsPanel_->show(outcome.results, outcome.isFinal);
  if (revision != document_.revision()) resultsPanel_->setStale(true);
  planPage_->show(outcome);
  showOverlay();
  if (outcome.isFinal && !document_.isModified() && revision == document_.revision()) saveResults();
}

void MainWindow::showOverlay() {
  if (!outcome_.results) return;
  overlays_->run([this, results = outcome_.results, look = planPage_->view().scale()] {
    const QMutexLocker lock(&drawingLock());
    auto overlay = std::make_shared<const GridOverlay>(overlayOf(results->grids, look));
    post(this, [this, overlay, results] {
      if (outcome_.results == results) roomPage_->showOverlay(overlay);
    });
  });
}

void MainWindow::saveResults() {
  // Only results of what is in the file: others would be stale there.
  if (!currentResults() || document_.isModified()) return;
  const std::string folder = (document_.folder() + "/results").toStdString();
  jobs_->start(tr("Write the results"), writeResultsWork(source(), outcome_.results, folder, [](const auto&) {}));
}

std::shared_ptr<const project::Results> MainWindow::currentResults() const {
  return outcome_.results && outcome_.isFinal && outcomeRevision_ == document_.revision() ? outcome_.results : nullptr;
}

void MainWindow::showProgress() {
  const Job* job = jobs_->current();
  progress_->setVisible(job != nullptr);
  progressText_->setVisible(job != nullptr);
  if (job != nullptr) {
    progress_->setValue(static_cast<int>(1000 * job->fraction()));
    QString words = job->task().isEmpty() ? job->title() : job->title() + ": " + job->task();
    if (!job->reached().isEmpty()) words += ", " + job->reached();
    const QString left = secondsText(job->secondsLeft());
    if (!left.isEmpty()) words += tr("  (about %1 left)").arg(left);
    progressText_->setText(words);
  }
  updateActions();
}

}  // namespace goniolux::gui
