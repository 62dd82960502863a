// A designer's day, driven by mouse and keyboard; the screenshots of its steps illustrate docs/studio.
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QTabWidget>

#include <cmath>

#include "app/gui/document/json_pointer.h"
#include "app/gui/forms/property_panel.h"
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
    saveScreenshot(dialog.grab(), "day-1-new-room");
    window_->newRoom(dialog.request());
    dialog.close();
    ASSERT_TRUE(wait([this] { return window_->document().isOpen(); }));
    ASSERT_TRUE(waitForCheck());
    ASSERT_TRUE(waitForJobs());
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
  makeRoom();
  gui::Document& document = window_->document();
  ASSERT_TRUE(window_->checker().latest()->project);
  screenshot("day-2-room");

  // A real photometric file comes in, where the corpus is at hand; else one of the program's own stays.
  QString photometry = "panel-600.ies";
  if (const auto shared = sharedFolder()) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*shared / "corpus"))
      if (entry.path().extension() == ".ies" || entry.path().extension() == ".IES") {
        photometry = window_->importPhotometry(QString::fromStdString(entry.path().string()));
        break;
      }
    ASSERT_FALSE(photometry.isEmpty());
  }
  window_->luminairePage().showFile(photometry);
  window_->pages().setCurrentIndex(3);
  ASSERT_TRUE(wait([this] { return !window_->luminairePage().sheetText().isEmpty(); }));
  QTest::qWait(600);
  screenshot("day-3-luminaire");

  // The array takes it, with a lamp spectrum, by the form.
  window_->luminairePage().showFile("panel-600.ies");
  window_->tree().select("/luminaires/0");
  gui::Field* spectrum = window_->properties().field("spectrum");
  ASSERT_NE(spectrum, nullptr);
  auto* line = spectrum->findChild<QLineEdit*>();
  line->setFocus();
  QTest::keyClicks(line, "CIE LED-B3");
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(document.find("/luminaires/0/spectrum")->string(), "CIE LED-B3");
  // A wall gets another finish.
  window_->tree().select("/materials/walls");
  line = window_->properties().field("diffuse")->findChild<QLineEdit*>();
  line->selectAll();
  QTest::keyClicks(line, "beech.spd");
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(window_->checker().latest()->project) << "the engine accepts what was entered";
  window_->pages().setCurrentIndex(4);
  window_->spectrumPage().choose("walls");
  QTest::qWait(400);
  screenshot("day-4-materials");

  // Calculated to 5 % (the guide's room is small; the accuracy is the designer's choice), with its verdict.
  document.set("/settings/accuracy/grid", "5 %", "accuracy");
  document.set(
      "/requirements/0",
      Value::Object{
          {"grid", "work plane"}, {"mean_lx", Value::Object{{"min", 300}}}, {"u0", Value::Object{{"min", 0.4}}}},
      "requirement");
  ASSERT_TRUE(waitForCheck());
  window_->pages().setCurrentIndex(0);
  calculate();
  const double before = window_->currentResults()->grids[0].mean.value;
  EXPECT_GT(before, 100);
  EXPECT_FALSE(window_->results().verdict(0).isEmpty());
  EXPECT_NE(window_->results().cell("work plane", "U₀"), QString());
  QTest::qWait(500);
  screenshot("day-5-calculated");
  window_->pages().setCurrentIndex(1);
  ASSERT_TRUE(wait([this] { return window_->planPage().view().isDrawn(); }));
  QTest::qWait(600);
  screenshot("day-6-illuminance");

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
  ASSERT_EQ(view.selection(), "/luminaires/0") << "a click on a luminaire selects it";
  const double x = number("/luminaires/0/position/0"), y = number("/luminaires/0/position/1");
  dragMouse(&view, at, view.toWidget(mark.position + core::Vec3(0.4, 0.2, 0)));
  EXPECT_NEAR(number("/luminaires/0/position/0"), x + 0.4, 0.11);
  EXPECT_NEAR(number("/luminaires/0/position/1"), y + 0.2, 0.11);
  EXPECT_NEAR(std::remainder(number("/luminaires/0/position/0"), 0.1), 0, 1e-9) << "snapped to 0.1 m";
  EXPECT_EQ(window_->currentResults(), nullptr) << "results of another state of the project are not current";
  ASSERT_TRUE(waitForCheck());
  screenshot("day-7-moved");
  calculate();
  EXPECT_NE(window_->currentResults()->grids[0].mean.value, before);
  document.undoStack().undo();
  EXPECT_EQ(number("/luminaires/0/position/0"), x);
  EXPECT_EQ(number("/luminaires/0/position/1"), y);

  // A picture, and a pixel of it.
  document.set("/views/0/width", 200, "size");
  document.set("/views/0/height", 150, "size");
  document.set("/settings/accuracy/image", "30 %", "accuracy");
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(waitForJobs());
  ASSERT_NE(window_->render("corner"), nullptr);
  gui::PicturePage& page = window_->picturePage();
  ASSERT_TRUE(wait([&] { return page.outcome().isFinal; }, 240000));
  ASSERT_TRUE(wait([&] { return !page.canvas().picture().isNull(); }));
  QTest::qWait(300);
  QTest::mouseClick(&page.canvas(), Qt::LeftButton, Qt::NoModifier, page.canvas().toWidget({100, 100}));
  const image::XyzImage written = image::readImage(page.outcome().file);
  const auto reading = image::readPatch(written, 100, 100, 0);
  EXPECT_GT(reading.luminance.value, 0);
  EXPECT_EQ(page.outcome().image->y, written.y) << "what is shown is what is written";
  EXPECT_TRUE(page.findChild<QLabel*>("meter")->text().contains("cd/m²"));
  screenshot("day-8-picture");

  // Everything goes out; saved and opened again it gives the same numbers.
  calculate();
  const auto last = window_->currentResults();
  EXPECT_TRUE(window_->exportTo("plan", folder_.filePath("plan.png")));
  EXPECT_TRUE(window_->exportTo("plan", folder_.filePath("plan.pdf")));
  EXPECT_TRUE(window_->exportTo("results", folder_.filePath("results.csv")));
  EXPECT_TRUE(window_->exportTo("picture", folder_.filePath("picture.png")));
  ASSERT_TRUE(window_->save());
  ASSERT_TRUE(waitForJobs());
  for (const char* name : {"plan.png", "plan.pdf", "results.csv", "picture.png", "day/results/grids.json"})
    EXPECT_GT(QFileInfo(folder_.filePath(name)).size(), 100) << name;
  document.close();
  ASSERT_TRUE(window_->openProject(folder_.filePath("day")));
  ASSERT_TRUE(wait([this] { return window_->currentResults() != nullptr; }));
  EXPECT_EQ(window_->currentResults()->grids[0].mean.value, last->grids[0].mean.value);
  ASSERT_TRUE(waitForCheck());
  calculate();
  EXPECT_EQ(window_->currentResults()->grids[0].values, last->grids[0].values) << "the same numbers to the last digit";
  window_->setTheme("dark");
  QTest::qWait(600);
  screenshot("day-9-dark");
  window_->setTheme("light");
}

}  // namespace
}  // namespace goniolux::test
