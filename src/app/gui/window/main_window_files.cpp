// The main window's files: new rooms, imports, exports, drag and drop, recovery.
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QTabWidget>
#include <QUrl>
#include <set>

#include "app/gui/document/json_pointer.h"
#include "app/gui/document/recovery.h"
#include "app/gui/window/help_window.h"
#include "app/gui/window/luminaire_page.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/new_room_dialog.h"
#include "app/gui/window/picture_page.h"
#include "app/gui/window/plan_page.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/results_panel.h"
#include "app/gui/window/room_page.h"
#include "project/reading.h"

namespace goniolux::gui {

using core::Value;

namespace {

bool isPhotometry(const QString& file) {
  return QStringList{"ies", "ldt", "xml"}.contains(QFileInfo(file).suffix().toLower());
}

bool isModel(const QString& file) {
  return QStringList{"obj", "ply", "stl", "gltf", "glb", "rad"}.contains(QFileInfo(file).suffix().toLower());
}

}  // namespace

void MainWindow::newRoomDialog() {
  if (!mayClose()) return;
  auto* dialog = new NewRoomDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { newRoom(dialog->request()); });
  dialog->open();
}

void MainWindow::newRoom(const pipeline::StageRequest& request) {
  Job* job =
      jobs_->start(tr("New room"), stageWork("new", request, [this, request](const pipeline::StageReport& report) {
                     if (!openProject(QString::fromStdString(*request.common.output))) return;
                     statusBar()->showMessage(QString::fromStdString(report.text).section('\n', 1, 1), 10000);
                   }));
  job->setCommandLine(commandLine("new", request));
}

QStringList MainWindow::photometryOfProject() const {
  QStringList names;
  const Value* luminaires = document_.find("/luminaires");
  if (luminaires == nullptr || !luminaires->isArray()) return names;
  for (const Value& luminaire : luminaires->array()) {
    const Value* photometry = luminaire.find("photometry");
    if (photometry == nullptr || !photometry->isString()) continue;
    const QString name = QString::fromStdString(photometry->string());
    if (isPhotometry(name) && !names.contains(name)) names << name;
  }
  for (const QString& file : QDir(document_.folder()).entryList({"*.ies", "*.IES", "*.ldt", "*.LDT"}, QDir::Files))
    if (!names.contains(file)) names << file;
  return names;
}

QString MainWindow::importPhotometry(const QString& file) {
  if (!document_.isOpen()) return {};
  const QString name = QFileInfo(file).fileName();
  const QString to = QDir(document_.folder()).filePath(name);
  try {
    if (QFileInfo(file).absoluteFilePath() != to) core::writeFile(to.toStdString(), core::readFile(file.toStdString()));
  } catch (const std::exception& error) {
    showFailure(tr("The file cannot be imported"), QString::fromUtf8(error.what()));
    return {};
  }
  luminairePage_->setFiles(photometryOfProject(), document_.folder());
  luminairePage_->showFile(name);
  pages_->setCurrentWidget(luminairePage_);
  statusBar()->showMessage(
      tr("%1 is in the project's folder; select luminaires and press “Use for selection”.").arg(name), 8000);
  return name;
}

void MainWindow::replacePhotometry(const QString& name, bool everywhere) {
  std::vector<std::string> pointers = tree_->selection();
  std::erase_if(pointers, [](const std::string& p) { return !p.starts_with("/luminaires/"); });
  if (pointers.empty()) {
    statusBar()->showMessage(tr("Select luminaires in the project first."), 6000);
    return;
  }
  std::set<std::string> places;
  for (const std::string& pointer : pointers) places.insert(pointer);
  if (everywhere) {
    const Value* before = document_.find(under(pointers.front(), "photometry"));
    const std::string old = before != nullptr ? core::toJson(*before) : std::string();
    const auto& all = document_.find("/luminaires")->array();
    for (std::size_t i = 0; i < all.size(); ++i)
      if (const Value* photometry = all[i].find("photometry");
          photometry != nullptr && core::toJson(*photometry) == old)
        places.insert(under("/luminaires", i));
  }
  document_.edit(tr("Replace the photometry"), [&](project::ProjectText& text) {
    for (const std::string& place : places) setIn(text, under(place, "photometry"), Value(name.toStdString()));
  });
}

void MainWindow::importDialog() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Import a photometric file"), QString(),
                                   tr("Photometric files (*.ies *.IES *.ldt *.LDT *.xml);;All files (*)"));
  if (!file.isEmpty()) importPhotometry(file);
}

void MainWindow::importModelDialog() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Import a model"), QString(),
                                                    tr("Models (*.obj *.ply *.stl *.gltf *.glb *.rad);;All files (*)"));
  if (!file.isEmpty()) importModel(file);
}

void MainWindow::importModel(const QString& file) {
  if (!save()) return;  // the stage works on the file
  pipeline::StageRequest request;
  request.inputs = {file.toStdString()};
  request.options["into"] = document_.folder().toStdString();
  Job* job = jobs_->start(tr("Import %1").arg(QFileInfo(file).fileName()),
                          stageWork("import", request, [this](const auto&) { openProject(document_.folder()); }));
  job->setCommandLine(commandLine("import", request));
}

void MainWindow::exportDialog(const QString& what) {
  const QString filter = what == "results"   ? tr("Comma-separated values (*.csv)")
                         : what == "report"  ? tr("PDF document (*.pdf);;Web page (*.html)")
                         : what == "plan"    ? tr("PNG picture (*.png);;PDF page (*.pdf)")
                         : what == "picture" ? tr("PNG picture (*.png);;OpenEXR, calibrated (*.exr)")
                                             : tr("PNG picture (*.png)");
  const QString ending = what == "results" ? "csv" : what == "report" ? "pdf" : "png";
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Export"), document_.folder() + "/" + what + "." + ending, filter);
  if (!file.isEmpty()) exportTo(what, file);
}

void MainWindow::startExport(const QString& file, const std::function<void()>& write) {
  jobs_->start(tr("Export %1").arg(QFileInfo(file).fileName()), [this, file, write](JobProgress& progress) {
    write();
    progress.publish([this, file] { statusBar()->showMessage(tr("Written: %1").arg(file), 5000); });
  });
}

bool MainWindow::exportTo(const QString& what, const QString& file) {
  QString failure;
  try {
    if (what == "results") {
      if (!currentResults()) throw core::RunError(tr("There are no results; calculate first.").toStdString());
      core::writeFile(file.toStdString(), resultsPanel_->csv().toStdString());
    } else if (what == "report") {
      if (!currentResults()) throw core::RunError(tr("There are no results; calculate first.").toStdString());
      if (document_.isModified() && !save()) return false;  // a report names the file that it is about
      const std::string language = QLocale().language() == QLocale::German ? "de" : "en";
      Job* job = jobs_->start(
          tr("Report"), reportWork(source(), currentResults(), file.toStdString(), language,
                                   [this, file] { statusBar()->showMessage(tr("Written: %1").arg(file), 5000); }));
      pipeline::StageRequest request;
      request.inputs = {(document_.folder() + "/results").toStdString()};
      request.options["language"] = language;
      job->setCommandLine(commandLine("report", request));
      return true;
    } else if (what == "plan") {
      const auto write = planPage_->view().exportOf(file);
      if (!write) throw core::RunError(tr("There is no plot yet; calculate first.").toStdString());
      startExport(file, write);
      return true;
    } else if (what == "room") {
      startExport(file, [picture = roomPage_->view().picture(), file,
                         cannot = tr("%1 cannot be written; choose another folder or ending.").arg(file)] {
        if (!picture.save(file)) throw core::RunError(cannot.toStdString());
      });
      return true;
    } else if (picturePage_->outcome().file.empty()) {
      failure = tr("There is no finished picture; render first.");
    } else if (file.endsWith(".exr", Qt::CaseInsensitive)) {
      core::writeFile(file.toStdString(), core::readFile(picturePage_->outcome().file));
    } else {
      const DisplayChoice choice = picturePage_->choice();
      pipeline::StageRequest request;
      request.inputs = {picturePage_->outcome().file};
      request.common.output = file.toStdString();
      request.options["device"] = choice.device;
      request.options["mapping"] = mappingText(choice);
      request.options["adapt"] = choice.adapts ? "auto" : "none";
      Job* job = jobs_->start(tr("Export %1").arg(QFileInfo(file).fileName()),
                              stageWork("display", request, [](const auto&) {}));
      job->setCommandLine(commandLine("display", request));
    }
  } catch (const std::exception& error) {
    failure = QString::fromUtf8(error.what());
  }
  if (!failure.isEmpty()) {
    showFailure(tr("Nothing was exported"), failure);
    return false;
  }
  statusBar()->showMessage(tr("Written: %1").arg(file), 5000);
  return true;
}

void MainWindow::showDocumentation() {
  if (help_ == nullptr) help_ = new HelpWindow(this);
  if (!help_->open("studio/README.md"))
    showFailure(tr("The documentation cannot be opened"),
                tr("It is not installed; it is the folder docs of Goniolux."));
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) {
    const QString file = url.toLocalFile();
    if (isPhotometry(file)) {
      if (document_.isOpen()) {
        importPhotometry(file);
      } else {
        statusBar()->showMessage(tr("Open a project or make a room first; then drop the luminaire again."), 8000);
      }
    } else if (isModel(file) && document_.isOpen()) {
      importModel(file);
    } else if (QFileInfo(file).isDir() || file.endsWith(".json")) {
      if (mayClose()) openProject(file);
    }
  }
  event->acceptProposedAction();
}

bool MainWindow::offerRecovery() {
  const std::vector<Recovered> found = Recovery::found();
  if (found.empty()) return false;
  const Recovered& newest = found.front();
  if (asksBeforeClosing_) {
    const auto answer =
        QMessageBox::question(this, tr("Unsaved changes were kept"),
                              tr("Goniolux Studio was ended while “%1” had unsaved changes. Go on with them?")
                                  .arg(QFileInfo(newest.file).dir().dirName()),
                              QMessageBox::Yes | QMessageBox::No);
    if (answer == QMessageBox::No) {
      Recovery::discard(newest);
      return false;
    }
  }
  document_.openText(newest.text, newest.file);
  Recovery::discard(newest);
  return true;
}

}  // namespace goniolux::gui
