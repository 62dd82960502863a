// MainWindow: the one window of the studio: start page, or a project with its views and panels.
#pragma once

#include <QMainWindow>
#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "app/gui/document/checked_project.h"
#include "app/gui/document/document.h"
#include "app/gui/jobs/calculations.h"
#include "app/gui/jobs/job_queue.h"
#include "app/gui/jobs/rendering.h"

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QProgressBar;
class QStackedWidget;
class QTabWidget;
class QToolBar;

namespace goniolux::gui {

class AccuracyPanel;
class HelpWindow;
class JobsPanel;
class LuminairePage;
class PicturePage;
class Recovery;
class SpectrumPage;
class PlanPage;
class ProblemsPanel;
class ProjectTree;
class PropertyPanel;
class ResultsPanel;
class RoomPage;
class StartPage;
class TextPanel;

class MainWindow final : public QMainWindow {
  Q_OBJECT
 public:
  MainWindow();
  ~MainWindow() override;

  /// Opens a project; what is wrong with the path is shown, and the window stays as it is.
  bool openProject(const QString& path);
  [[nodiscard]] Document& document() { return document_; }
  [[nodiscard]] JobQueue& jobs() { return *jobs_; }
  [[nodiscard]] const ProjectChecker& checker() const { return checker_; }
  [[nodiscard]] RoomPage& roomPage() { return *roomPage_; }
  [[nodiscard]] PlanPage& planPage() { return *planPage_; }
  [[nodiscard]] PicturePage& picturePage() { return *picturePage_; }
  [[nodiscard]] LuminairePage& luminairePage() { return *luminairePage_; }
  [[nodiscard]] SpectrumPage& spectrumPage() { return *spectrumPage_; }
  [[nodiscard]] AccuracyPanel& accuracyPanel() { return *accuracyPanel_; }
  [[nodiscard]] Recovery& recovery() { return *recovery_; }
  [[nodiscard]] ResultsPanel& results() { return *resultsPanel_; }
  [[nodiscard]] ProjectTree& tree() { return *tree_; }
  [[nodiscard]] PropertyPanel& properties() { return *properties_; }
  [[nodiscard]] ProblemsPanel& problems() { return *problems_; }
  [[nodiscard]] QTabWidget& pages() { return *pages_; }
  /// The results that are shown; null when there are none, or not of the project as it is now.
  [[nodiscard]] std::shared_ptr<const project::Results> currentResults() const;

  Job* calculate();
  Job* render(const QString& view);
  /// Makes a room as the stage `new` is asked to, and opens it.
  void newRoom(const pipeline::StageRequest& request);
  /// Copies a photometric file into the project's folder and shows it; its name there, "" when it cannot be.
  QString importPhotometry(const QString& file);
  void replacePhotometry(const QString& name, bool everywhere);
  /// Writes what is shown: .csv results, .pdf or .html report, .png or .pdf of the plan, .png or .exr of the picture.
  bool exportTo(const QString& what, const QString& file);
  /// Offers what an earlier process that was killed left; opens the newest. False when there is nothing.
  bool offerRecovery();
  /// The documentation in a window of its own.
  void showDocumentation();
  [[nodiscard]] HelpWindow* help() const { return help_; }
  /// Size and panels as they were when the program was last closed.
  void restoreLayout();
  bool save();
  bool saveAs(const QString& folder);
  void setTheme(const QString& name);
  /// Asks nothing when it is closed: for tests.
  void closeWithoutAsking();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  // main_window.cpp: what there is
  void buildPages();
  void buildPanels();
  void buildStatusBar();
  void connectPanels();
  // main_window_actions.cpp: menus and toolbar
  void buildActions();
  void buildAccuracy(QToolBar& bar);
  void updateActions();
  // main_window_project.cpp: opening, saving, what was checked
  void showOpened();
  void showChecked();
  void showHealth();
  void updateTitle();
  void choose(const std::vector<std::string>& pointers);
  void moveSelection(const core::Vec3& metres);
  void turnSelection(double degrees);
  void openDialog();
  bool mayClose();
  void rememberRecent(const QString& path);
  void showFailure(const QString& title, const QString& message);
  // main_window_files.cpp: what comes in and goes out
  void newRoomDialog();
  void importDialog();
  void importModelDialog();
  void importModel(const QString& file);
  void exportDialog(const QString& what);
  /// Writes a file by a job; what `write` throws is shown.
  void startExport(const QString& file, const std::function<void()>& write);
  [[nodiscard]] QStringList photometryOfProject() const;
  // main_window_jobs.cpp: calculating
  void showGrids(quint64 revision, const GridsOutcome& outcome);
  void showOverlay();
  void loadEarlierResults();
  void saveResults();
  void copyCommandLine();
  void showRendering(const RenderOutcome& outcome);
  void showProgress();
  [[nodiscard]] Source source() const;

  Document document_;
  ProjectChecker checker_;
  std::unique_ptr<JobQueue> jobs_;
  std::unique_ptr<Worker> overlays_;

  QStackedWidget* stack_ = nullptr;
  StartPage* start_ = nullptr;
  QTabWidget* pages_ = nullptr;
  RoomPage* roomPage_ = nullptr;
  PlanPage* planPage_ = nullptr;
  PicturePage* picturePage_ = nullptr;
  LuminairePage* luminairePage_ = nullptr;
  SpectrumPage* spectrumPage_ = nullptr;
  AccuracyPanel* accuracyPanel_ = nullptr;
  Recovery* recovery_ = nullptr;
  ProjectTree* tree_ = nullptr;
  PropertyPanel* properties_ = nullptr;
  ResultsPanel* resultsPanel_ = nullptr;
  ProblemsPanel* problems_ = nullptr;
  JobsPanel* jobsPanel_ = nullptr;
  TextPanel* text_ = nullptr;
  HelpWindow* help_ = nullptr;
  QLabel* pointed_ = nullptr;
  QLabel* health_ = nullptr;
  QLabel* progressText_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QComboBox* accuracy_ = nullptr;
  QMenu *importing_ = nullptr, *exporting_ = nullptr;
  QAction *render_ = nullptr, *save_ = nullptr, *saveAs_ = nullptr, *calculate_ = nullptr, *pause_ = nullptr,
          *stop_ = nullptr;

  QTemporaryDir drafts_;  // images of projects that are not saved as they are
  GridsOutcome outcome_;
  quint64 outcomeRevision_ = 0;
  bool needsFraming_ = false, asksBeforeClosing_ = true;
};

}  // namespace goniolux::gui
