// Editing: undo, broken projects, missing files, recovery after a kill, and an interface that never freezes.
#include <QFile>
#include <QLineEdit>
#include <QProcess>

#include "app/gui/document/recovery.h"
#include "app/gui/forms/property_panel.h"
#include "app/gui/window/problems_panel.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/room_page.h"
#include "gui/studio_fixture.h"
#include "gui/watchdog.h"

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
  const double calculating = watchdog.longest();
  watchdog.forget();
  for (int k = 0; k < 10; ++k) {
    window_->document().set("/luminaires/0/flux", 3000 + k, "flux");
    QTest::qWait(60);
  }
  ASSERT_TRUE(waitForCheck());
  const double editing = watchdog.longest();
  RecordProperty("longest_ms_calculating", std::to_string(calculating));
  RecordProperty("longest_ms_editing", std::to_string(editing));
  std::printf("longest pause of the interface: %.0f ms calculating, %.0f ms editing\n", calculating, editing);
  // The goal is 100 ms on a machine of its own; tests share theirs, and a busy one gives no process its turn for
  // longer.
  EXPECT_LT(calculating, 400);
  EXPECT_LT(editing, 400);
}

}  // namespace
}  // namespace goniolux::test
