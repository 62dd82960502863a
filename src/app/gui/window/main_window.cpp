#include "app/gui/window/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>

#include "app/gui/forms/property_panel.h"
#include "app/gui/window/icons.h"
#include "app/gui/window/jobs_panel.h"
#include "app/gui/window/plan_page.h"
#include "app/gui/window/problems_panel.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/results_panel.h"
#include "app/gui/window/room_page.h"
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
  pages_->addTab(roomPage_, icon("perspective"), tr("Room"));
  pages_->addTab(planPage_, icon("grid"), tr("Illuminance"));
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
  tabifyDockWidget(results, problems);
  tabifyDockWidget(problems, jobs);
  tabifyDockWidget(jobs, text);
  for (QDockWidget* panel : {results, problems, jobs, text})
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
          [this](const QString& pointer) { tree_->select(pointer.toStdString()); });
  connect(&roomPage_->view(), &RoomView::moved, this, [this](const QString& pointer, double x, double y, double z) {
    moveEntry(pointer, {x, y, z});
  });
  connect(&roomPage_->view(), &RoomView::pointed, pointed_, &QLabel::setText);
  connect(&planPage_->view(), &PlanView::pointed, pointed_, &QLabel::setText);
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
  const std::pair<int, const char*> tabs[] = {{0, "perspective"}, {1, "grid"}};
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
