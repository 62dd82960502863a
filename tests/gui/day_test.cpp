// A designer's day, driven by mouse and keyboard; the screenshots of its steps illustrate docs/studio.
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableView>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/gui/document/json_pointer.h"
#include "app/gui/forms/property_panel.h"
#include "app/gui/plots/paper.h"
#include "app/gui/window/jobs_panel.h"
#include "app/gui/window/luminaire_page.h"
#include "app/gui/window/new_room_dialog.h"
#include "app/gui/window/picture_page.h"
#include "app/gui/window/plan_page.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/results_panel.h"
#include "app/gui/window/room_page.h"
#include "app/gui/window/spectrum_page.h"
#include "gui/studio_fixture.h"
#include "gui/watchdog.h"
#include "image/image_file.h"
#include "image/patch.h"
#include "support/shared_folder.h"

namespace goniolux::test {
namespace {

using core::Value;

class DesignersDay : public StudioFixture {
 protected:
  double number(const std::string& pointer) {
    const Value* value = window_->document().find(pointer);
    return value != nullptr && value->isNumber() ? value->number() : std::nan("");
  }

  void makeRoom() {
    gui::NewRoomDialog dialog(window_.get());
    dialog.findChild<QLineEdit*>("folder")->setText(folder_.filePath("day"));
    dialog.findChild<QComboBox*>("luminaire")->setCurrentText("panel-600.ies");
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    QTest::qWait(100);
    {
      const Watchdog::Blindfold blindfold(watchdog_.get());
      saveScreenshot(dialog.grab(), "day-1-new-room");
    }
    window_->newRoom(dialog.request());
    dialog.close();
    ASSERT_TRUE(wait([this] { return window_->document().isOpen(); }));
    ASSERT_TRUE(waitForCheck());
    ASSERT_TRUE(waitForJobs());
  }

  /// A manufacturer's file of a rectangular luminaire from the corpus, else one that Goniolux brings along.
  QString importARealFile() {
    const auto shared = sharedFolder();
    const std::filesystem::path real =
        shared ? *shared / "corpus/photometry/ldt/Plukers+real-time-photometric-area-lights/LINETIK-S_42184482.LDT"
               : "";
    std::error_code ignored;
    return window_->importPhotometry(shared && std::filesystem::exists(real, ignored)
                                         ? QString::fromStdString(real.string())
                                         : QString(GONIOLUX_SOURCE_DIR) + "/luminaires/batten-t8.ldt");
  }

  void enter(const QString& key, const QString& part, const QString& words) {
    gui::Field* field = window_->properties().field(key);
    ASSERT_NE(field, nullptr) << key.toStdString();
    auto* line = field->findChild<QLineEdit*>(part.isEmpty() ? QString() : part);
    ASSERT_NE(line, nullptr) << key.toStdString();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, words);
    QTest::keyClick(line, Qt::Key_Return);
  }

  /// What the interface's thread did since the last step: its longest pause by the clock, taken apart, and the most
  /// that it computed in one go. The worst of the day are kept.
  void step(const char* name) {
    const Pause longest = watchdog_->longest(), busiest = watchdog_->busiest();
    std::printf(
        "  %-24s longest pause %4.0f ms (computing %3.0f, without a processor %3.0f, waiting %3.0f); most computed in "
        "one go %3.0f ms\n",
        name, longest.clock, longest.cpu, longest.starved, longest.asleep(), busiest.cpu);
    std::fflush(stdout);
    worstClock_ = std::max(worstClock_, longest.clock);
    if (busiest.cpu > worstCpu_ && name != std::string("new room") && name != std::string("dark theme"))
      worstCpu_ = busiest.cpu, worstStep_ = name;
    watchdog_->forget();
  }
  double worstClock_ = 0, worstCpu_ = 0;
  std::string worstStep_;

  /// An edit as one of the interface: it answers before the next.
  void set(const std::string& pointer, const Value& value, const QString& words) {
    window_->document().set(pointer, value, words);
    QTest::qWait(1);
  }

  void calculate() {
    ASSERT_TRUE(wait([this] { return !window_->jobs().isBusy(); }));
    ASSERT_NE(window_->calculate(), nullptr);
    ASSERT_TRUE(waitForJobs(240000));
    ASSERT_TRUE(wait([this] { return window_->currentResults() != nullptr; }));
    ASSERT_TRUE(waitForJobs());
  }

  /// Drags with the left button, in steps as a hand does.
  void dragMouse(QWidget* widget, const QPoint& from, const QPoint& to) {
    QTest::mousePress(widget, Qt::LeftButton, Qt::NoModifier, from);
    for (int k = 1; k <= 8; ++k) {
      const QPoint at = from + (to - from) * k / 8;
      QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(widget, &move);
      QTest::qWait(10);
    }
    QTest::mouseRelease(widget, Qt::LeftButton, Qt::NoModifier, to);
  }
};

TEST_F(DesignersDay, FromANewRoomToASavedAndReopenedProject) {
  if (!sharedFolder()) GTEST_SKIP() << sharedFolderIsAbsent;
  watchdog_ = std::make_unique<Watchdog>();
  makeRoom();
  gui::Document& document = window_->document();
  ASSERT_TRUE(window_->checker().latest()->project);
  screenshot("day-2-room");
  step("new room");

  // A real photometric file comes in, where the corpus is at hand; else one of the program's own.
  const QString photometry = importARealFile();
  ASSERT_FALSE(photometry.isEmpty());
  window_->luminairePage().showFile(photometry);
  window_->pages().setCurrentIndex(3);
  ASSERT_TRUE(wait([this] { return !window_->luminairePage().sheetText().isEmpty(); }));
  QTest::qWait(600);
  screenshot("day-3-luminaire");
  step("luminaire imported");

  // The array takes it, in another layout and with a lamp spectrum, by the form.
  window_->tree().select("/luminaires/0");
  window_->replacePhotometry(photometry, false);
  EXPECT_EQ(document.find("/luminaires/0/photometry")->string(), photometry.toStdString());
  const double across = number("/luminaires/0/array/counts/1");
  enter("array/counts", "counts 0", "2");
  enter("array/u", "u 0", "3");
  enter("position", "position 0", "1.5");
  EXPECT_EQ(number("/luminaires/0/array/counts/0"), 2);
  EXPECT_EQ(number("/luminaires/0/array/counts/1"), across);
  enter("spectrum", "", "CIE LED-B3");
  EXPECT_EQ(document.find("/luminaires/0/spectrum")->string(), "CIE LED-B3");
  // A wall gets another finish.
  window_->tree().select("/materials/walls");
  enter("diffuse", "", "beech.spd");
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(window_->checker().latest()->project) << "the engine accepts what was entered";
  window_->pages().setCurrentIndex(4);
  window_->spectrumPage().choose("walls");
  EXPECT_TRUE(wait([this] { return window_->spectrumPage().hasPreview(); })) << "a ball of the finish is rendered";
  QTest::qWait(300);
  screenshot("day-4-materials");
  step("materials and spectra");

  // Calculated to 2 %, with verdicts on uniformity and glare.
  set("/settings/accuracy/grid", "2 %", "accuracy");
  document.append("/observers",
                  Value::Object{{"name", "desk"},
                                {"eye", Value::Array{0.6, 2, 1.2}},
                                {"direction", Value::Array{1, 0, 0}},
                                {"quantity", "ugr"}},
                  "observer");
  set("/requirements/0",
      Value::Object{
          {"grid", "work plane"}, {"mean_lx", Value::Object{{"min", 300}}}, {"u0", Value::Object{{"min", 0.4}}}},
      "requirement");
  set("/requirements/1", Value::Object{{"observer", "desk"}, {"ugr", Value::Object{{"max", 19}}}}, "requirement");
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(window_->checker().latest()->project);
  window_->pages().setCurrentIndex(0);
  calculate();
  const double before = window_->currentResults()->grids[0].mean.value;
  EXPECT_GT(before, 100);
  EXPECT_FALSE(window_->results().verdict(0).isEmpty()) << "illuminance and uniformity";
  EXPECT_FALSE(window_->results().verdict(1).isEmpty());
  const auto& observers = window_->currentResults()->observers;
  const auto desk = std::find_if(observers.begin(), observers.end(), [](const auto& o) { return o.name == "desk"; });
  ASSERT_NE(desk, observers.end());
  EXPECT_GT(desk->value.value, 5) << "UGR of a bare batten or louvre";
  EXPECT_LT(desk->value.value, 40);
  EXPECT_NE(window_->results().cell("work plane", "U₀"), QString());
  QTest::qWait(500);
  screenshot("day-5-calculated");
  step("calculated to 2 %");
  window_->pages().setCurrentIndex(1);
  ASSERT_TRUE(wait([this] { return window_->planPage().view().isDrawn(); }));
  // A section along a line drawn by mouse.
  gui::PlanView& plan = window_->planPage().view();
  dragMouse(&plan, plan.toWidget({0.5, 1}), plan.toWidget({5.5, 3}));
  ASSERT_TRUE(plan.section().has_value());
  EXPECT_NEAR(plan.section()->from.x, 0.5, 0.05);
  EXPECT_NEAR(plan.section()->to.y, 3, 0.05);
  ASSERT_TRUE(wait([this] { return window_->planPage().section().isDrawn(); }));
  QTest::qWait(300);
  screenshot("day-6-illuminance");
  auto* charts = window_->planPage().findChild<QTabWidget*>("charts");
  charts->setCurrentIndex(2);
  EXPECT_EQ(window_->planPage().findChild<QTableView*>("values")->model()->rowCount(),
            static_cast<int>(window_->currentResults()->grids[0].points.size()));
  charts->setCurrentIndex(1);
  ASSERT_TRUE(wait([this] { return window_->planPage().histogram().isDrawn(); }));
  screenshot("day-6-histogram");
  step("plots");

  // A luminaire is moved by the mouse, in plan; the results are known to be stale, and come again.
  window_->pages().setCurrentIndex(0);
  gui::RoomView& view = window_->roomPage().view();
  QTest::qWait(200);
  const QImage perspective = view.grabFramebuffer();
  view.setPreset(gui::OrbitCamera::Preset::plan);
  QTest::qWait(300);
  EXPECT_NE(view.grabFramebuffer(), perspective) << "what is seen follows the camera";
  const auto& mark = window_->checker().latest()->scene->luminaires.front();
  const QPoint at = view.toWidget(mark.position);
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, at);
  ASSERT_EQ(view.selection(), std::vector<std::string>{"/luminaires/0"}) << "a click on a luminaire selects it";
  const double x = number("/luminaires/0/position/0"), y = number("/luminaires/0/position/1");
  dragMouse(&view, at, view.toWidget(mark.position + core::Vec3(0.4, 0.2, 0)));
  EXPECT_NEAR(number("/luminaires/0/position/0"), x + 0.4, 0.11);
  EXPECT_NEAR(number("/luminaires/0/position/1"), y + 0.2, 0.11);
  EXPECT_NEAR(std::remainder(number("/luminaires/0/position/0"), 0.1), 0, 1e-9) << "snapped to 0.1 m";
  EXPECT_EQ(window_->currentResults(), nullptr) << "results of another state of the project are not current";
  ASSERT_TRUE(waitForCheck());
  screenshot("day-7-moved");
  set("/settings/accuracy/grid", "10 %", "accuracy");  // the tests' time is not the designer's
  step("moved by mouse");
  calculate();
  EXPECT_NE(window_->currentResults()->grids[0].mean.value, before);
  for (int k = 0; k < 2; ++k) {
    document.undoStack().undo();
    QTest::qWait(1);
  }
  EXPECT_EQ(number("/luminaires/0/position/0"), x);
  EXPECT_EQ(number("/luminaires/0/position/1"), y);
  step("calculated again, undone");

  // A picture, and a pixel of it.
  set("/settings/accuracy/grid", "10 %", "accuracy");
  set("/views/0/width", 200, "size");
  set("/views/0/height", 150, "size");
  set("/settings/accuracy/image", "30 %", "accuracy");
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(waitForJobs());
  ASSERT_NE(window_->render("corner"), nullptr);
  gui::PicturePage& page = window_->picturePage();
  ASSERT_TRUE(wait([&] { return page.outcome().isFinal; }, 240000));
  ASSERT_TRUE(wait([&] { return !page.canvas().picture().isNull(); }));
  QTest::qWait(300);
  QTest::mouseClick(&page.canvas(), Qt::LeftButton, Qt::NoModifier, page.canvas().toWidget({100, 100}));
  {
    const Watchdog::Blindfold blindfold(watchdog_.get());
    const image::XyzImage written = image::readImage(page.outcome().file);
    const auto reading = image::readPatch(written, 100, 100, 0);
    EXPECT_GT(reading.luminance.value, 0);
    EXPECT_EQ(page.outcome().image->y, written.y) << "what is shown is what is written";
  }
  EXPECT_TRUE(page.findChild<QLabel*>("meter")->text().contains("cd/m²"));
  screenshot("day-8-picture");
  step("rendered, probed");

  // Everything goes out; saved and opened again it gives the same numbers.
  calculate();
  const auto last = window_->currentResults();
  EXPECT_TRUE(window_->exportTo("plan", folder_.filePath("plan.png")));
  EXPECT_TRUE(window_->exportTo("plan", folder_.filePath("plan.pdf")));
  EXPECT_TRUE(window_->exportTo("results", folder_.filePath("results.csv")));
  EXPECT_TRUE(window_->exportTo("picture", folder_.filePath("picture.png")));
  ASSERT_TRUE(window_->save());
  const QString report = QStandardPaths::findExecutable("weasyprint").isEmpty() ? "report.html" : "report.pdf";
  EXPECT_TRUE(window_->exportTo("report", folder_.filePath(report)));
  ASSERT_TRUE(waitForJobs(240000));
  for (const char* name : {"plan.png", "plan.pdf", "results.csv", "picture.png", "day/results/grids.json"})
    EXPECT_GT(QFileInfo(folder_.filePath(name)).size(), 100) << name;
  EXPECT_GT(QFileInfo(folder_.filePath(report)).size(), 20000) << "the report, as `goniolux report` makes it";
  step("exported, saved");
  document.close();
  ASSERT_TRUE(window_->openProject(folder_.filePath("day")));
  ASSERT_TRUE(wait([this] { return window_->currentResults() != nullptr; }));
  EXPECT_EQ(window_->currentResults()->grids[0].mean.value, last->grids[0].mean.value);
  ASSERT_TRUE(waitForCheck());
  calculate();
  EXPECT_EQ(window_->currentResults()->grids[0].values, last->grids[0].values) << "the same numbers to the last digit";
  step("opened again");
  window_->setTheme("dark");
  QTest::qWait(600);
  screenshot("day-9-dark");
  step("dark theme");
  watchdog_.reset();
  window_->setTheme("light");
  std::printf("the whole day: longest pause by the clock %.0f ms, most computed in one go %.0f ms (%s)\n", worstClock_,
              worstCpu_, worstStep_.c_str());
  // 100 ms hold for what the interface's thread computes itself, but for the very first picture of the 3-D view, which
  // loads the graphics driver, and for another theme, which styles every widget anew: 169 and 168 ms were measured. By
  // the clock a machine that is shared lets it wait for its turn: pauses of seconds were seen where ten programs wanted
  // two processors; what hangs takes longer.
  EXPECT_LE(worstCpu_, 100);
  EXPECT_LT(worstClock_, 15000);
}

}  // namespace
}  // namespace goniolux::test
