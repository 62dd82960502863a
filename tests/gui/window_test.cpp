// The window with a sample project: what is shown, calculated, undone and saved.
#include <QTreeWidget>

#include "app/gui/document/json_pointer.h"
#include "app/gui/forms/property_panel.h"
#include "app/gui/window/problems_panel.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/results_panel.h"
#include "app/gui/window/room_page.h"
#include "core/parallel.h"
#include "gui/studio_fixture.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"

namespace goniolux::test {
namespace {

class Studio : public StudioFixture {};

TEST_F(Studio, ShowsStartPageWithSampleProjects) {
  auto* samples = window_->findChild<QWidget*>("samples");
  ASSERT_NE(samples, nullptr);
  EXPECT_TRUE(samples->isVisible());
  screenshot("start-page");
}

TEST_F(Studio, CalculatesWhatTheCommandLineCalculates) {
  const QString folder = copyOf("small-office");
  setAccuracy(folder, "2 %", "10 %");
  ASSERT_TRUE(window_->openProject(folder));
  ASSERT_TRUE(waitForCheck());
  ASSERT_NE(window_->checker().latest()->project, nullptr);
  ASSERT_TRUE(waitForJobs());
  screenshot("small-office");
  ASSERT_NE(window_->calculate(), nullptr);
  ASSERT_TRUE(waitForJobs());
  ASSERT_TRUE(wait([this] { return window_->currentResults() != nullptr; }));
  QTest::qWait(500);
  screenshot("small-office-calculated");

  const project::Project project = project::readProject(folder.toStdString());
  core::SilentProgress silent;
  const project::Results expected = pipeline::calculateGrids(project, pipeline::Engine(project, false), silent);
  const auto shown = window_->currentResults();
  ASSERT_EQ(shown->grids.size(), expected.grids.size());
  for (std::size_t g = 0; g < expected.grids.size(); ++g) {
    EXPECT_EQ(shown->grids[g].mean.value, expected.grids[g].mean.value) << "not a digit may differ";
    EXPECT_EQ(shown->grids[g].values.size(), expected.grids[g].values.size());
  }
  EXPECT_EQ(window_->results().cell("work plane", "Mean"), gui::withHalfWidth(expected.grids[0].mean) + " lx");
  window_->pages().setCurrentIndex(1);
  QTest::qWait(700);
  screenshot("small-office-plan");
}

}  // namespace
}  // namespace goniolux::test
