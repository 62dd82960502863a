// Editing: undo, broken projects, missing files, recovery after a kill, and an interface that never freezes.
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLineEdit>
#include <QProcess>
#include <cmath>

#include "app/gui/document/json_pointer.h"
#include "app/gui/document/recovery.h"
#include "app/gui/forms/property_panel.h"
#include "app/gui/window/problems_panel.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/room_page.h"
#include "gui/studio_fixture.h"

namespace goniolux::test {
namespace {

class Editing : public StudioFixture {};

TEST_F(Editing, UndoRestoresTheTextToTheLetter) {
  ASSERT_TRUE(window_->openProject(copyOf("small-office")));
  gui::Document& document = window_->document();
  const std::string before = document.text();
  ASSERT_NE(before.find("// A small office at night"), std::string::npos);
  document.set("/luminaires/0/flux", 3500, "flux");
  document.set("/settings/tree/cutoff", 0.01, "a part that is not there yet");
  document.append("/grids", core::Value::Object{{"name", "floor"}}, "grid");
  document.remove("/views/1", "view");
  EXPECT_NE(document.text().find("// A small office at night"), std::string::npos) << "comments stay";
  EXPECT_EQ(document.find("/settings/tree/cutoff")->number(), 0.01);
  EXPECT_EQ(document.find("/views")->array().size(), 1u);
  const std::string after = document.text();
  for (int k = 0; k < 4; ++k) document.undoStack().undo();
  EXPECT_EQ(document.text(), before);
  EXPECT_FALSE(document.isModified());
  for (int k = 0; k < 4; ++k) document.undoStack().redo();
  EXPECT_EQ(document.text(), after);
}

TEST_F(Editing, SeveralEntriesAreChangedInOneStep) {
  ASSERT_TRUE(window_->openProject(copyOf("small-office")));
  window_->properties().showEntries({"/grids/1", "/grids/2"});
  auto* line = window_->properties().field("counts")->findChild<QLineEdit*>("counts 0");
  ASSERT_NE(line, nullptr);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, "7");
  QTest::keyClick(line, Qt::Key_Return);
  for (const char* grid : {"/grids/1/counts/0", "/grids/2/counts/0"})
    EXPECT_EQ(window_->document().find(grid)->number(), 7) << grid;
  window_->document().undoStack().undo();
  EXPECT_FALSE(window_->document().isModified());
}

TEST_F(Editing, EntriesAreCopiedUnderFreeNamesAndPastedInOneStep) {
  ASSERT_TRUE(window_->openProject(copyOf("small-office")));
  gui::Document& document = window_->document();
  const std::size_t grids = document.find("/grids")->array().size();
  window_->tree().select("/grids/0");
  window_->tree().select("/grids/1", true);
  EXPECT_EQ(window_->tree().selection().size(), 2u);
  window_->tree().copySelection();
  window_->tree().paste();
  ASSERT_EQ(document.find("/grids")->array().size(), grids + 2);
  EXPECT_EQ(document.find(gui::under(gui::under("/grids", grids), "name"))->string(),
            document.find("/grids/0/name")->string() + " 2");
  EXPECT_EQ(window_->tree().selection().size(), 2u) << "what was pasted is selected";
  document.undoStack().undo();
  EXPECT_FALSE(document.isModified());
  QApplication::clipboard()->setText("no entries");
  window_->tree().paste();
  EXPECT_FALSE(document.isModified());
}

TEST_F(Editing, ObjectsAndLuminairesAreMovedAndTurnedByMouse) {
  const QString folder = folder_.filePath("mouse");
  QDir().mkpath(folder);
  QFile file(folder + "/project.json");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(
      R"({ "format": "goniolux-project", "version": 1, "materials": { "m": { "model": "lambert", "diffuse": 0.5 } },
  "objects": [
    { "name": "room", "shape": "box", "min": [0,0,0], "max": [6,4,3], "facing": "inward", "material": "m" },
    { "name": "desk", "shape": "box", "min": [2,1,0], "max": [3.6,1.8,0.75], "material": "m" },
    { "name": "shelf", "shape": "box", "min": [0.3,3.2,0], "max": [0.9,3.8,1], "material": "m" } ],
  "luminaires": [ { "name": "L", "photometry": "cosine", "flux": 3000, "position": [4.5,3,2.9],
                    "shape": { "rectangle": { "length": 1.2, "width": 0.3 } } } ],
  "grids": [ { "name": "g", "origin": [0,0,0.8], "u": [6,0,0], "v": [0,4,0], "counts": [6,4] } ] })");
  file.close();
  ASSERT_TRUE(window_->openProject(folder));
  ASSERT_TRUE(waitForCheck());
  gui::RoomView& view = window_->roomPage().view();
  view.setPreset(gui::OrbitCamera::Preset::plan);
  QTest::qWait(200);
  const auto pull = [&](const core::Vec3& from, const core::Vec3& to, Qt::KeyboardModifiers keys) {
    const QPoint a = view.toWidget(from), b = view.toWidget(to);
    QTest::mousePress(&view, Qt::LeftButton, keys, a);
    for (int k = 1; k <= 4; ++k) {
      const QPoint at = a + (b - a) * k / 4;
      QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, keys);
      QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, keys, b);
  };
  const auto number = [&](const char* pointer) {
    const core::Value* value = window_->document().find(pointer);
    return value != nullptr && value->isNumber() ? value->number() : std::nan("");
  };
  // A click selects; what is selected is pulled, by steps of 0.1 m.
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget({2.8, 1.4, 0.75}));
  ASSERT_EQ(view.selection(), std::vector<std::string>{"/objects/1"});
  pull({2.8, 1.4, 0.75}, {3.3, 1.6, 0.75}, Qt::NoModifier);
  EXPECT_NEAR(number("/objects/1/min/0"), 2.5, 0.05);
  EXPECT_NEAR(number("/objects/1/max/1"), 2.0, 0.05);
  EXPECT_NEAR(std::remainder(number("/objects/1/min/0"), 0.1), 0, 1e-9);
  EXPECT_EQ(number("/objects/1/max/2"), 0.75) << "it stays at its height";
  ASSERT_TRUE(waitForCheck());
  // With Alt it turns about its centre, by steps of 15 degrees.
  const core::Vec3 center = window_->checker().latest()->scene->entries.at("/objects/1").center;
  pull(center + core::Vec3(0.6, 0, 0.375), center + core::Vec3(0.35, 0.35, 0.375), Qt::AltModifier);
  EXPECT_NEAR(number("/objects/1/transform/0/rotate/degrees"), 45, 1e-9);
  EXPECT_NEAR(number("/objects/1/transform/0/rotate/center/0"), center.x, 1e-6);
  ASSERT_TRUE(waitForCheck());
  EXPECT_TRUE(window_->checker().latest()->project) << "the engine accepts what was written";
  // Ctrl-click takes the shelf along; both move in one step of undo.
  QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, view.toWidget({0.6, 3.5, 1}));
  ASSERT_EQ(view.selection().size(), 2u);
  pull({0.6, 3.5, 1}, {0.9, 3.3, 1}, Qt::NoModifier);
  EXPECT_NEAR(number("/objects/2/min/0"), 0.6, 0.05);
  EXPECT_NEAR(number("/objects/2/min/1"), 3.0, 0.05);
  EXPECT_NEAR(number("/objects/1/transform/1/translate/0"), number("/objects/2/min/0") - 0.3, 1e-6);
  ASSERT_TRUE(waitForCheck());
  screenshot("moved-and-turned");
  for (int k = 0; k < 3; ++k) window_->document().undoStack().undo();
  EXPECT_FALSE(window_->document().isModified()) << "three pulls are three steps";
  // The room is not pulled about: a drag on it turns the view.
  window_->tree().select("/objects/0");
  pull({1, 3, 0}, {2, 3, 0}, Qt::NoModifier);
  EXPECT_FALSE(window_->document().isModified());
}

TEST_F(Editing, AValueOutOfItsRangeIsMarkedAndNotTaken) {
  ASSERT_TRUE(window_->openProject(copyOf("small-office")));
  window_->tree().select("/luminaires/0");
  gui::Field* field = window_->properties().field("maintenance");
  auto* line = field->findChild<QLineEdit*>();
  line->selectAll();
  QTest::keyClicks(line, "1.5");
  EXPECT_TRUE(field->isWrong());
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(window_->document().find("/luminaires/0/maintenance")->number(), 0.8);
}

TEST_F(Editing, ABrokenProjectStaysEditableAndSaysWhatToDo) {
  const QString folder = copyOf("small-office");
  QFile file(folder + "/project.json");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QByteArray text = file.readAll();
  file.close();
  text.replace("\"panel-600.ies\"", "\"no-such-panel.ies\"");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
  file.close();
  ASSERT_TRUE(window_->openProject(folder));
  ASSERT_TRUE(waitForCheck());
  EXPECT_GE(window_->problems().errors(), 1);
  EXPECT_TRUE(window_->problems().topLevelItem(0)->text(0).contains("no-such-panel.ies"));
  screenshot("broken-project");
  ASSERT_NE(window_->calculate(), nullptr);
  ASSERT_TRUE(waitForJobs());
  EXPECT_EQ(window_->jobs().jobs().back()->state(), gui::Job::State::failed);
  window_->document().set("/luminaires/0/photometry", "panel-600.ies", "mend");
  ASSERT_TRUE(waitForCheck());
  EXPECT_EQ(window_->problems().errors(), 0);
  EXPECT_TRUE(window_->checker().latest()->project);
}

TEST_F(Editing, ATextThatIsNoJsonIsMendedAsText) {
  ASSERT_TRUE(window_->openProject(copyOf("small-office")));
  gui::Document& document = window_->document();
  std::string broken = document.text();
  broken.erase(broken.rfind('}'));
  document.setText(broken, "break");
  ASSERT_TRUE(waitForCheck());
  EXPECT_GE(window_->problems().errors(), 1);
  document.set("/name", "x", "must be refused");
  EXPECT_EQ(document.text(), broken);
  document.setText(broken + "}\n", "mend");
  ASSERT_TRUE(waitForCheck());
  EXPECT_EQ(window_->problems().errors(), 0);
}

TEST_F(Editing, WhatAKilledProgramHadIsOfferedAgain) {
  ASSERT_TRUE(window_->openProject(copyOf("small-office")));
  QElapsedTimer clock;
  clock.start();
  window_->document().set("/name", "edited and never saved", "name");
  QSignalSpy kept(&window_->recovery(), &gui::Recovery::kept);
  ASSERT_TRUE(kept.wait(5000));
  EXPECT_LT(clock.elapsed(), 3000) << "no more than the last few seconds may be lost";
  // The same file as a process that is gone would have left it: only the number of the process differs.
  QFile file(window_->recovery().keptIn());
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QByteArray text = file.readAll();
  QProcess gone;
  gone.start("true", QStringList());
  ASSERT_TRUE(gone.waitForStarted());
  const QByteArray dead = QByteArray::number(gone.processId());
  gone.waitForFinished();
  text.replace(QByteArray::number(QCoreApplication::applicationPid()), dead);
  EXPECT_TRUE(gui::Recovery::found().empty()) << "what a running program keeps is not offered";
  QFile left(gui::Recovery::folder() + "/left.json");
  ASSERT_TRUE(left.open(QIODevice::WriteOnly));
  left.write(text);
  left.close();
  window_->closeWithoutAsking();
  window_ = std::make_unique<gui::MainWindow>();
  window_->closeWithoutAsking();  // from here on nothing is asked
  window_->show();
  ASSERT_TRUE(window_->offerRecovery());
  EXPECT_EQ(window_->document().title(), "edited and never saved");
  EXPECT_TRUE(window_->document().isModified());
  EXPECT_TRUE(gui::Recovery::found().empty());
}

TEST_F(Editing, TheInterfaceAnswersWhileItCalculates) {
  const QString folder = copyOf("small-office");
  setAccuracy(folder, "2 %", "5 %");
  ASSERT_TRUE(window_->openProject(folder));
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(waitForJobs());
  QTest::qWait(300);
  Watchdog watchdog;
  ASSERT_NE(window_->calculate(), nullptr);
  ASSERT_TRUE(waitForJobs(100000));
  const Pause calculating = watchdog.longest();
  const double calculatingCpu = watchdog.busiest().cpu;
  watchdog.forget();
  for (int k = 0; k < 10; ++k) {
    window_->document().set("/luminaires/0/flux", 3000 + k, "flux");
    QTest::qWait(60);
  }
  ASSERT_TRUE(waitForCheck());
  const Pause editing = watchdog.longest();
  const double editingCpu = watchdog.busiest().cpu;
  std::printf(
      "longest pause of the interface: %.0f ms calculating, %.0f ms editing; most computed in one go %.0f and "
      "%.0f ms\n",
      calculating.clock, editing.clock, calculatingCpu, editingCpu);
  // By the clock other programs count, too: a busy machine gives no process its turn for longer.
  EXPECT_LE(calculatingCpu, 100);
  EXPECT_LE(editingCpu, 100);
  EXPECT_LT(calculating.clock, 3000);
  EXPECT_LT(editing.clock, 3000);
}

}  // namespace
}  // namespace goniolux::test
