// The main window's menus and toolbar.
#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>

#include "app/gui/jobs/job_queue.h"
#include "app/gui/window/accuracy_panel.h"
#include "app/gui/window/icons.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/picture_page.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/room_page.h"
#include "app/gui/window/theme.h"

namespace goniolux::gui {

void MainWindow::buildActions() {
  const auto make = [this](QMenu* menu, const char* picture, const QString& title, const QKeySequence& keys) {
    QAction* action = menu->addAction(icon(picture), title);
    action->setProperty("picture", picture);
    action->setShortcut(keys);
    return action;
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QAction* create = make(file, "new", tr("&New room …"), QKeySequence::New);
  connect(create, &QAction::triggered, this, &MainWindow::newRoomDialog);
  QAction* open = make(file, "open", tr("&Open …"), QKeySequence::Open);
  connect(open, &QAction::triggered, this, &MainWindow::openDialog);
  save_ = make(file, "save", tr("&Save"), QKeySequence::Save);
  connect(save_, &QAction::triggered, this, &MainWindow::save);
  saveAs_ = make(file, "", tr("Save &as …"), QKeySequence("Ctrl+Shift+S"));
  connect(saveAs_, &QAction::triggered, this, [this] { saveAs(QString()); });
  file->addSeparator();
  importing_ = file->addMenu(tr("&Import"));
  connect(importing_->addAction(icon("luminaire"), tr("Photometric file …")), &QAction::triggered, this,
          &MainWindow::importDialog);
  connect(importing_->addAction(icon("object"), tr("Model (OBJ, PLY, STL, glTF) …")), &QAction::triggered, this,
          &MainWindow::importModelDialog);
  exporting_ = file->addMenu(tr("&Export"));
  const std::pair<const char*, QString> exports[] = {{"report", tr("Report as PDF or HTML …")},
                                                     {"results", tr("Results as CSV …")},
                                                     {"plan", tr("Illuminance plot as PNG or PDF …")},
                                                     {"picture", tr("Picture as PNG or OpenEXR …")},
                                                     {"room", tr("3-D view as PNG …")}};
  for (const auto& [what, title] : exports)
    connect(exporting_->addAction(title), &QAction::triggered, this,
            [this, name = QString(what)] { exportDialog(name); });
  file->addSeparator();
  QAction* close = make(file, "", tr("&Close project"), QKeySequence::Close);
  connect(close, &QAction::triggered, this, [this] {
    if (mayClose()) document_.close();
  });
  QAction* quit = make(file, "", tr("&Quit"), QKeySequence::Quit);
  connect(quit, &QAction::triggered, this, &QWidget::close);

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = document_.undoStack().createUndoAction(this, tr("&Undo"));
  QAction* redo = document_.undoStack().createRedoAction(this, tr("&Redo"));
  undo->setShortcut(QKeySequence::Undo);
  redo->setShortcut(QKeySequence::Redo);
  undo->setIcon(icon("undo"));
  redo->setIcon(icon("redo"));
  undo->setProperty("picture", "undo");
  redo->setProperty("picture", "redo");
  edit->addActions({undo, redo});
  edit->addSeparator();
  connect(make(edit, "", tr("Cu&t"), QKeySequence::Cut), &QAction::triggered, tree_, &ProjectTree::cutSelection);
  connect(make(edit, "", tr("&Copy"), QKeySequence::Copy), &QAction::triggered, tree_, &ProjectTree::copySelection);
  connect(make(edit, "", tr("&Paste"), QKeySequence::Paste), &QAction::triggered, tree_, &ProjectTree::paste);
  connect(make(edit, "", tr("&Duplicate"), QKeySequence("Ctrl+D")), &QAction::triggered, tree_,
          &ProjectTree::duplicateSelection);
  connect(make(edit, "", tr("&Remove"), QKeySequence::Delete), &QAction::triggered, tree_,
          &ProjectTree::removeSelection);
  QMenu* add = edit->addMenu(tr("&Add"));
  const std::pair<const char*, QString> lists[] = {{"luminaires", tr("Luminaire")},    {"objects", tr("Object")},
                                                   {"materials", tr("Material")},      {"grids", tr("Grid")},
                                                   {"observers", tr("Observer")},      {"views", tr("View")},
                                                   {"requirements", tr("Requirement")}};
  for (const auto& [list, title] : lists)
    connect(add->addAction(title), &QAction::triggered, this,
            [this, place = std::string("/") + list] { tree_->addEntry(place); });

  QMenu* calculation = menuBar()->addMenu(tr("&Calculation"));
  calculate_ = make(calculation, "run", tr("&Calculate"), QKeySequence("F5"));
  connect(calculate_, &QAction::triggered, this, &MainWindow::calculate);
  pause_ = make(calculation, "pause", tr("&Pause"), QKeySequence("F6"));
  pause_->setCheckable(true);
  connect(pause_, &QAction::toggled, this, [this](bool on) {
    if (Job* job = jobs_->current()) job->setPaused(on);
  });
  render_ = make(calculation, "render", tr("&Render the chosen view"), QKeySequence("F7"));
  connect(render_, &QAction::triggered, this, [this] { render(picturePage_->chosenView()); });
  QAction* copy = make(calculation, "", tr("&Copy as command line"), QKeySequence("Ctrl+Shift+C"));
  copy->setToolTip(tr("The last job as a command of goniolux that does the same"));
  connect(copy, &QAction::triggered, this, &MainWindow::copyCommandLine);
  calculation->addSeparator();
  stop_ = make(calculation, "stop", tr("&Stop"), QKeySequence("Shift+F5"));
  connect(stop_, &QAction::triggered, jobs_.get(), &JobQueue::stopAll);

  QMenu* view = menuBar()->addMenu(tr("&View"));
  QMenu* panels = view->addMenu(tr("&Panels"));
  for (QDockWidget* dock : findChildren<QDockWidget*>()) panels->addAction(dock->toggleViewAction());
  QMenu* themes = view->addMenu(tr("&Theme"));
  auto* group = new QActionGroup(this);
  const std::pair<const char*, QString> choices[] = {{"light", tr("Light")}, {"dark", tr("Dark")}};
  for (const auto& [name, title] : choices) {
    QAction* action = themes->addAction(title);
    action->setCheckable(true);
    action->setChecked(theme().isDark == (QString(name) == "dark"));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, chosen = QString(name)] {
      setTheme(chosen);
      QSettings().setValue("theme", chosen);
    });
  }

  QMenu* languages = view->addMenu(tr("&Language"));
  const std::pair<const char*, const char*> tongues[] = {{"en", "English"}, {"de", "Deutsch"}};
  for (const auto& [code, title] : tongues)
    connect(languages->addAction(title), &QAction::triggered, this, [this, chosen = QString(code)] {
      QSettings().setValue("language", chosen);
      statusBar()->showMessage(tr("The language changes when the program is started again."), 6000);
    });

  auto* bar = new QToolBar(tr("Main toolbar"), this);
  bar->setObjectName("mainToolBar");
  bar->setIconSize({20, 20});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->setMovable(false);
  addToolBar(bar);
  bar->addAction(create);
  bar->addAction(open);
  bar->addAction(save_);
  bar->addSeparator();
  bar->addAction(undo);
  bar->addAction(redo);
  bar->addSeparator();
  buildAccuracy(*bar);
  bar->addAction(calculate_);
  bar->addAction(pause_);
  bar->addAction(stop_);
  for (QAction* wordless : {undo, redo, pause_, stop_}) wordless->setPriority(QAction::LowPriority);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  QAction* guide = help->addAction(tr("&Documentation"));
  guide->setShortcut(QKeySequence::HelpContents);
  connect(guide, &QAction::triggered, this, &MainWindow::showDocumentation);
  connect(help->addAction(tr("&About Goniolux Studio")), &QAction::triggered, this, [this] {
    QMessageBox::about(this, tr("About Goniolux Studio"),
                       tr("<b>Goniolux Studio %1</b><p>Calculates the light in a room. Every number comes with an "
                          "interval that holds the exact answer at the stated confidence.</p>")
                           .arg(GONIOLUX_VERSION));
  });
}

void MainWindow::buildAccuracy(QToolBar& bar) {
  bar.addWidget(new QLabel(tr(" Accuracy  "), &bar));
  accuracy_ = new QComboBox(&bar);
  accuracy_->setObjectName("accuracy");
  accuracy_->setAccessibleName(tr("Accuracy of illuminances"));
  accuracy_->setToolTip(
      tr("The half-width that you are content with: at 95 % confidence the mean, the minimum and 95 % "
         "of the points of every grid are known to this share of their value."));
  for (const QString& accuracy : AccuracyPanel::choices()) accuracy_->addItem("± " + accuracy, accuracy);
  accuracy_->insertSeparator(accuracy_->count());
  accuracy_->addItem(tr("Predict the times …"));
  accuracy_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  bar.addWidget(accuracy_);
  connect(accuracyPanel_, &AccuracyPanel::predicted, this, [this](const QString& accuracy, const QString& time) {
    const int index = accuracy_->findData(accuracy);
    if (index >= 0) accuracy_->setItemText(index, "± " + accuracy + (time.isEmpty() ? QString() : "  ·  " + time));
  });
  connect(accuracy_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    if (accuracy_->currentData().toString().isEmpty()) {
      auto* dock = findChild<QDockWidget*>("accuracyDock");
      dock->show();
      dock->raise();
      accuracyPanel_->estimate();
      return updateActions();
    }
    document_.set("/settings/accuracy/grid", core::Value(accuracy_->currentData().toString().toStdString()),
                  tr("Change the accuracy"));
  });
}

void MainWindow::updateActions() {
  const bool isOpen = document_.isOpen();
  const Job* job = jobs_->current();
  save_->setEnabled(isOpen && document_.isModified());
  saveAs_->setEnabled(isOpen);
  calculate_->setEnabled(isOpen && job == nullptr);
  pause_->setEnabled(job != nullptr);
  if (job == nullptr && pause_->isChecked()) {
    const QSignalBlocker quiet(pause_);
    pause_->setChecked(false);
  }
  stop_->setEnabled(job != nullptr);
  render_->setEnabled(isOpen && job == nullptr);
  picturePage_->setRendering(job != nullptr);
  importing_->setEnabled(isOpen);
  exporting_->setEnabled(isOpen);
  accuracy_->setEnabled(isOpen);
  if (!isOpen) return;
  const core::Value* asked = document_.find("/settings/accuracy/grid");
  QString shown = "2 %";
  if (asked != nullptr && asked->isString()) shown = QString::fromStdString(asked->string());
  if (asked != nullptr && asked->isNumber()) shown = QString("%1 %").arg(100 * asked->number());
  int index = accuracy_->findData(shown);
  if (index < 0) accuracy_->insertItem(index = 0, "± " + shown, shown);
  accuracy_->setCurrentIndex(index);
}

}  // namespace goniolux::gui
