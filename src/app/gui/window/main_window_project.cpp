// The main window's project: opening, saving, and what the engine's reader says while one edits.
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>

#include "app/gui/document/json_pointer.h"
#include "app/gui/document/placement.h"
#include "app/gui/forms/property_panel.h"
#include "app/gui/window/accuracy_panel.h"
#include "app/gui/window/jobs_panel.h"
#include "app/gui/window/luminaire_page.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/picture_page.h"
#include "app/gui/window/plan_page.h"
#include "app/gui/window/problems_panel.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/results_panel.h"
#include "app/gui/window/room_page.h"
#include "app/gui/window/spectrum_page.h"
#include "app/gui/window/start_page.h"
#include "app/gui/window/text_panel.h"
#include "app/gui/window/theme.h"

namespace goniolux::gui {

using core::Value;

bool MainWindow::openProject(const QString& path) {
  try {
    document_.open(path);
    rememberRecent(document_.folder());
    return true;
  } catch (const std::exception& error) {
    showFailure(tr("The project cannot be opened"), QString::fromUtf8(error.what()));
    return false;
  }
}

void MainWindow::openDialog() {
  if (!mayClose()) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a project"), QSettings().value("folder").toString(),
                                                    tr("Goniolux projects (project.json *.json);;All files (*)"));
  if (!file.isEmpty()) openProject(file);
}

void MainWindow::rememberRecent(const QString& path) {
  QSettings settings;
  QStringList recent = settings.value("recent").toStringList();
  recent.removeAll(path);
  recent.prepend(path);
  while (recent.size() > 12) recent.removeLast();
  settings.setValue("recent", recent);
  settings.setValue("folder", QFileInfo(path).path());
  start_->setRecent(recent);
}

void MainWindow::showOpened() {
  const bool isOpen = document_.isOpen();
  stack_->setCurrentIndex(isOpen ? 1 : 0);
  for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->setVisible(isOpen);
  if (isOpen) findChild<QDockWidget*>("resultsDock")->raise();
  jobs_->stopAll();
  outcome_ = {};
  outcomeRevision_ = 0;
  needsFraming_ = true;
  resultsPanel_->show(nullptr, true);
  planPage_->clear();
  picturePage_->clear();
  picturePage_->setViews({});
  spectrumPage_->showProject(nullptr);
  roomPage_->showOverlay(nullptr);
  if (!isOpen) {
    problems_->show({});
    health_->clear();
  }
  updateTitle();
  if (isOpen) loadEarlierResults();
}

void MainWindow::showChecked() {
  const CheckedProject& checked = *checker_.latest();
  showHealth();
  if (checked.scene) {
    roomPage_->showProject(checked, needsFraming_);
    picturePage_->setViews(checked.project->views);
    spectrumPage_->showProject(checked.project, checked.text);
    luminairePage_->setFiles(photometryOfProject(), document_.folder());
    accuracyPanel_->setSource(source());
    needsFraming_ = false;
  } else if (needsFraming_) {
    // Nothing can be drawn yet: what is wrong comes first.
    auto* dock = findChild<QDockWidget*>("problemsDock");
    dock->show();
    dock->raise();
  }
  updateTitle();
}

void MainWindow::showHealth() {
  const CheckedProject& checked = *checker_.latest();
  problems_->show(checked.diagnostics);
  QString words;
  if (problems_->errors() > 0) {
    words = tr("%n error(s)", nullptr, problems_->errors());
  } else if (problems_->warnings() > 0) {
    words = tr("%n warning(s)", nullptr, problems_->warnings());
  } else {
    words = tr("no problems");
  }
  const QColor colour = problems_->errors() > 0     ? theme().fail
                        : problems_->warnings() > 0 ? theme().undecided
                                                    : theme().pass;
  health_->setText(QString("<span style='color:%1'>● </span>%2").arg(colour.name(), words));
}

void MainWindow::updateTitle() {
  setWindowTitle(document_.isOpen() ? document_.title() + (document_.isModified() ? " *" : "") + " – Goniolux Studio"
                                    : QString("Goniolux Studio"));
  updateActions();
}

void MainWindow::choose(const std::vector<std::string>& pointers) {
  properties_->showEntries(pointers);
  roomPage_->view().select(pointers);
  if (pointers.empty()) return;
  const std::string& first = pointers.front();
  if (first.starts_with("/materials/")) spectrumPage_->choose(QString::fromStdString(lastStep(first)));
  if (const Value* file = document_.find(under(first, "photometry")); first.starts_with("/luminaires/") &&
                                                                      file != nullptr && file->isString() &&
                                                                      file->string().find('.') != std::string::npos)
    luminairePage_->showFile(QString::fromStdString(file->string()));
}

void MainWindow::moveSelection(const core::Vec3& metres) {
  document_.edit(tr("Move"), [&](project::ProjectText& text) {
    for (const std::string& pointer : tree_->selection()) moveIn(text, pointer, metres);
  });
}

void MainWindow::turnSelection(double degrees) {
  const auto scene = checker_.latestGood()->scene;
  document_.edit(tr("Turn"), [&](project::ProjectText& text) {
    for (const std::string& pointer : tree_->selection()) {
      core::Vec3 center(0);
      if (scene)
        if (const auto entry = scene->entries.find(pointer); entry != scene->entries.end())
          center = entry->second.center;
      turnIn(text, pointer, degrees, center);
    }
  });
}

bool MainWindow::save() {
  if (!document_.isOpen()) return false;
  text_->commit();
  try {
    document_.save();
    saveResults();
    statusBar()->showMessage(tr("Saved."), 3000);
    return true;
  } catch (const std::exception& error) {
    showFailure(tr("The project cannot be saved"), QString::fromUtf8(error.what()));
    return false;
  }
}

bool MainWindow::saveAs(const QString& given) {
  QString folder = given;
  if (folder.isEmpty())
    folder = QFileDialog::getExistingDirectory(this, tr("Folder for the project"), document_.folder());
  if (folder.isEmpty()) return false;
  try {
    document_.saveAs(folder);
    rememberRecent(document_.folder());
    return true;
  } catch (const std::exception& error) {
    showFailure(tr("The project cannot be saved"), QString::fromUtf8(error.what()));
    return false;
  }
}

bool MainWindow::mayClose() {
  if (!document_.isOpen() || !document_.isModified() || !asksBeforeClosing_) return true;
  const auto answer = QMessageBox::question(
      this, tr("Unsaved changes"), tr("“%1” has changes that are not saved. Save them?").arg(document_.title()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  restoreGeometry(settings.value("geometry").toByteArray());
  restoreState(settings.value("panels").toByteArray());
  if (!document_.isOpen())
    for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->setVisible(false);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayClose()) return event->ignore();
  jobs_->stopAll();
  if (asksBeforeClosing_) {
    QSettings settings;
    settings.setValue("geometry", saveGeometry());
    if (document_.isOpen()) settings.setValue("panels", saveState());
  }
  event->accept();
}

void MainWindow::showFailure(const QString& title, const QString& message) {
  jobsPanel_->log(title + ": " + message);
  statusBar()->showMessage(title + ": " + message.section('\n', 0, 0), 15000);
  if (!asksBeforeClosing_) return;
  auto* box = new QMessageBox(QMessageBox::Warning, title, message, QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  box->open();
}

}  // namespace goniolux::gui
