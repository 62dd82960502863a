#include "app/gui/window/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>

#include "app/gui/document/recovery.h"
#include "app/gui/forms/property_panel.h"
#include "app/gui/window/accuracy_panel.h"
#include "app/gui/window/icons.h"
#include "app/gui/window/jobs_panel.h"
#include "app/gui/window/luminaire_page.h"
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

MainWindow::MainWindow()
    : checker_(document_), jobs_(std::make_unique<JobQueue>()), overlays_(std::make_unique<Worker>("overlays")) {
  setObjectName("mainWindow");
  setWindowIcon(programIcon());
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setAcceptDrops(true);
  resize(1440, 900);
  buildPages();
  buildPanels();
  buildStatusBar();
  buildActions();
  connectPanels();
  const QSettings settings;
  start_->setRecent(settings.value("recent").toStringList());
  showOpened();
}

MainWindow::~MainWindow() {
  // What is destroyed tells nobody any more.
  document_.undoStack().disconnect();
  document_.disconnect();
  checker_.disconnect();
  disconnect(jobs_.get(), nullptr, this, nullptr);
  overlays_.reset();
  jobs_.reset();
}

void MainWindow::buildPages() {
  stack_ = new QStackedWidget(this);
  setCentralWidget(stack_);
  start_ = new StartPage(stack_);
  pages_ = new QTabWidget(stack_);
  pages_->setObjectName("pages");
  pages_->setDocumentMode(true);
  roomPage_ = new RoomPage(pages_);
  planPage_ = new PlanPage(pages_);
  picturePage_ = new PicturePage(pages_);
  luminairePage_ = new LuminairePage(pages_);
  spectrumPage_ = new SpectrumPage(pages_);
  pages_->addTab(roomPage_, icon("perspective"), tr("Room"));
  pages_->addTab(planPage_, icon("grid"), tr("Illuminance"));
  pages_->addTab(picturePage_, icon("render"), tr("Picture"));
  pages_->addTab(luminairePage_, icon("luminaire"), tr("Luminaire"));
  pages_->addTab(spectrumPage_, icon("material"), tr("Spectra"));
  stack_->addWidget(start_);
  stack_->addWidget(pages_);
}

void MainWindow::buildPanels() {
  tree_ = new ProjectTree(document_, checker_, this);
  properties_ = new PropertyPanel(document_, checker_, this);
  resultsPanel_ = new ResultsPanel(this);
  problems_ = new ProblemsPanel(this);
  jobsPanel_ = new JobsPanel(*jobs_, this);
  text_ = new TextPanel(document_, this);
  accuracyPanel_ = new AccuracyPanel(*jobs_, this);
  recovery_ = new Recovery(document_, this);
  const auto dock = [this](const QString& title, const char* name, QWidget* widget, Qt::DockWidgetArea area) {
    auto* panel = new QDockWidget(title, this);
    panel->setObjectName(name);
    panel->setWidget(widget);
    addDockWidget(area, panel);
    return panel;
  };
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  auto* project = dock(tr("Project"), "projectDock", tree_, Qt::LeftDockWidgetArea);
  auto* properties = dock(tr("Properties"), "propertiesDock", properties_, Qt::RightDockWidgetArea);
  auto* results = dock(tr("Results"), "resultsDock", resultsPanel_, Qt::BottomDockWidgetArea);
  auto* problems = dock(tr("Problems"), "problemsDock", problems_, Qt::BottomDockWidgetArea);
  auto* jobs = dock(tr("Jobs and log"), "jobsDock", jobsPanel_, Qt::BottomDockWidgetArea);
  auto* text = dock(tr("Project text"), "textDock", text_, Qt::BottomDockWidgetArea);
  auto* accuracy = dock(tr("Accuracy"), "accuracyDock", accuracyPanel_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(results, accuracy);
  tabifyDockWidget(accuracy, problems);
  tabifyDockWidget(problems, jobs);
  tabifyDockWidget(jobs, text);
  for (QDockWidget* panel : {results, accuracy, problems, jobs, text})
    panel->setTitleBarWidget(new QWidget);  // the tabs name them
  results->raise();
  setTabPosition(Qt::BottomDockWidgetArea, QTabWidget::North);
  resizeDocks({project, properties}, {280, 330}, Qt::Horizontal);
  resizeDocks({results}, {210}, Qt::Vertical);
}

void MainWindow::buildStatusBar() {
  pointed_ = new QLabel(this);
  health_ = new QLabel(this);
  progressText_ = new QLabel(this);
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setMaximumWidth(220);
  progress_->setTextVisible(false);
  progress_->setVisible(false);
  statusBar()->addWidget(pointed_, 1);
  statusBar()->addPermanentWidget(progressText_);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(health_);
  statusBar()->setContentsMargins(8, 2, 8, 2);
}

void MainWindow::connectPanels() {
  connect(start_, &StartPage::projectChosen, this, [this](const QString& path) {
    if (mayClose()) openProject(path);
  });
  connect(start_, &StartPage::openRequested, this, &MainWindow::openDialog);
  connect(&document_, &Document::opened, this, &MainWindow::showOpened);
  connect(&document_, &Document::changed, this, [this] {
    if (outcome_.results && outcomeRevision_ != document_.revision()) resultsPanel_->setStale(true);
    updateActions();
  });
  connect(&document_, &Document::modifiedChanged, this, &MainWindow::updateTitle);
  connect(&document_, &Document::refused, this, [this](const QString& why) { statusBar()->showMessage(why, 8000); });
  connect(&checker_, &ProjectChecker::checked, this, &MainWindow::showChecked);
  connect(tree_, &ProjectTree::chosen, this, &MainWindow::choose);
  connect(&roomPage_->view(), &RoomView::selected, this,
          [this](const QString& pointer, bool together) { tree_->select(pointer.toStdString(), together); });
  connect(&roomPage_->view(), &RoomView::moved, this, [this](double x, double y, double z) {
    moveSelection({x, y, z});
  });
  connect(&roomPage_->view(), &RoomView::turned, this, &MainWindow::turnSelection);
  connect(&roomPage_->view(), &RoomView::pointed, pointed_, &QLabel::setText);
  connect(&planPage_->view(), &PlanView::pointed, pointed_, &QLabel::setText);
  connect(picturePage_, &PicturePage::renderRequested, this, &MainWindow::render);
  connect(picturePage_, &PicturePage::exportRequested, this, [this] { exportDialog("picture"); });
  connect(picturePage_, &PicturePage::accuracyChosen, this, [this](const QString& accuracy) {
    document_.set("/settings/accuracy/image", core::Value(accuracy.toStdString()),
                  tr("Change the accuracy of pictures"));
  });
  connect(planPage_, &PlanPage::scaleChanged, this, &MainWindow::showOverlay);
  connect(planPage_, &PlanPage::exportRequested, this, [this] { exportDialog("plan"); });
  connect(luminairePage_, &LuminairePage::importRequested, this, &MainWindow::importDialog);
  connect(luminairePage_, &LuminairePage::useRequested, this,
          [this](const QString& n) { replacePhotometry(n, false); });
  connect(luminairePage_, &LuminairePage::replaceRequested, this,
          [this](const QString& n) { replacePhotometry(n, true); });
  connect(accuracyPanel_, &AccuracyPanel::accuracyChosen, this, [this](const QString& accuracy) {
    document_.set("/settings/accuracy/grid", core::Value(accuracy.toStdString()), tr("Change the accuracy"));
  });
  connect(start_, &StartPage::newRequested, this, &MainWindow::newRoomDialog);
  connect(resultsPanel_, &ResultsPanel::gridChosen, planPage_, &PlanPage::setGrid);
  connect(problems_, &ProblemsPanel::placeChosen, this, [this](int line, int column) {
    auto* dock = findChild<QDockWidget*>("textDock");
    dock->show();
    dock->raise();
    text_->goTo(line, column);
  });
  connect(jobs_.get(), &JobQueue::progressed, this, &MainWindow::showProgress);
  connect(jobs_.get(), &JobQueue::added, this, &MainWindow::showProgress);
  connect(jobs_.get(), &JobQueue::over, this, [this](Job* job) {
    showProgress();
    if (job->state() == Job::State::failed) showFailure(tr("%1 failed").arg(job->title()), job->failure());
  });
}

void MainWindow::setTheme(const QString& name) {
  applyTheme(name);
  roomPage_->applyColours();
  tree_->rebuild();
  resultsPanel_->show(outcome_.results, outcome_.isFinal);
  if (outcome_.results && outcomeRevision_ != document_.revision()) resultsPanel_->setStale(true);
  if (document_.isOpen()) showHealth();
  const std::pair<int, const char*> tabs[] = {
      {0, "perspective"}, {1, "grid"}, {2, "render"}, {3, "luminaire"}, {4, "material"}};
  for (const auto& [index, picture] : tabs) pages_->setTabIcon(index, icon(picture));
  for (QAction* action : findChildren<QAction*>())
    if (const QString picture = action->property("picture").toString(); !picture.isEmpty())
      action->setIcon(icon(picture));
}

void MainWindow::closeWithoutAsking() {
  asksBeforeClosing_ = false;
  close();
}

}  // namespace goniolux::gui
