// How fast the interface is: its start, and the 3-D view of a large project with software OpenGL. The goals (window
// within 1 s, 20 pictures a second, no pause above 100 ms) hold on a machine of its own; tests share theirs, so that
// they fail only far beyond, and print the figures.
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <QElapsedTimer>
#include <QProcess>

#include <cstdio>

#include "app/gui/room/room_view.h"
#include "core/parallel.h"
#include "gui/studio_fixture.h"

namespace goniolux::test {
namespace {

class Performance : public StudioFixture {
 protected:
  /// A hall with 500 luminaires and 16 770 crates: 201 240 triangles.
  QString largeProject() {
    const QString folder = folder_.filePath("large");
    QDir().mkpath(folder);
    QFile file(folder + "/project.json");
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({
  "format": "goniolux-project", "version": 1, "name": "Large hall",
  "materials": { "grey": { "model": "lambert", "diffuse": 0.5 }, "wood": { "model": "lambert", "diffuse": 0.35 } },
  "objects": [
    { "name": "hall", "shape": "box", "min": [0,0,0], "max": [80,60,10], "facing": "inward", "material": "grey" },
    { "name": "crates", "shape": "box", "min": [1,1,0.01], "max": [1.4,1.3,0.5], "material": "wood",
      "array": { "counts": [130, 129], "u": [0.6,0,0], "v": [0,0.45,0] } }
  ],
  "luminaires": [ { "name": "L", "photometry": "cosine", "flux": 20000, "position": [1.6,1.5,9.5],
    "shape": { "rectangle": { "length": 1.2, "width": 0.3 } },
    "array": { "counts": [25, 20], "u": [3.2,0,0], "v": [0,3,0] } } ],
  "grids": [ { "name": "floor", "origin": [0,0,2], "u": [80,0,0], "v": [0,60,0], "counts": [20,15] } ]
})");
    return folder;
  }
};

TEST_F(Performance, TheWindowAppearsSoon) {
  std::vector<double> times;
  for (int k = 0; k < 3; ++k) {
    QProcess studio;
    studio.start(GONIOLUX_STUDIO, {"--time-start"});
    ASSERT_TRUE(studio.waitForFinished(30000));
    const QByteArray said = studio.readAllStandardOutput();
    ASSERT_TRUE(said.contains(" ms from the start")) << said.constData();
    times.push_back(said.left(said.indexOf(' ')).toDouble());
  }
  std::sort(times.begin(), times.end());
  std::printf("window after %.0f ms (best %.0f ms of 3)\n", times[1], times[0]);
  EXPECT_LT(times[0], 3000);
}

// Not part of the tests: takes the picture apart, for docs/studio/drawing.md.
// test_gui --gtest_also_run_disabled_tests --gtest_filter='Performance.DISABLED_*'
TEST_F(Performance, DISABLED_WhereTheTimeOfAPictureGoes) {
  ASSERT_TRUE(window_->openProject(largeProject()));
  ASSERT_TRUE(waitForCheck());
  const auto scene = window_->checker().latest()->scene;
  ASSERT_NE(scene, nullptr);
  gui::RoomView view;
  view.resize(1280, 800);
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  view.showScene(scene, true);
  ASSERT_TRUE(wait([&] { return view.isDrawn(); }));
  const auto mouse = [&](QEvent::Type type, const QPoint& at) {
    QMouseEvent event(type, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  };
  mouse(QEvent::MouseButtonPress, QPoint(600, 790));
  const auto measure = [&](const char* what, bool composed) {
    const auto turn = [&](int count) {
      for (int k = 0; k < count; ++k) {
        mouse(QEvent::MouseMove, QPoint(600 + 4 * k, 790));
        view.drawNow();
        if (composed) view.repaint();
      }
      view.renderWindow()->WaitForCompletion();
    };
    turn(3);
    const double before = core::processCpuSeconds();
    turn(30);
    std::printf("  %-52s %5.1f ms of CPU time a picture\n", what, 1e3 * (core::processCpuSeconds() - before) / 30);
    std::fflush(stdout);
  };
  measure("everything, in the window", true);
  measure("everything, without the window's composition", false);
  auto* actors = view.renderWindow()->GetRenderers()->GetFirstRenderer()->GetActors();
  // In the order of RoomView::plainActors(), then what is drawn in pieces.
  const std::pair<int, const char*> parts[] = {
      {3, "and without aiming lines"}, {2, "and without frames of luminaires"}, {1, "and without their openings"}};
  const auto empty = [&](int index) {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(index));
    vtkNew<vtkPolyData> nothing;
    vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(nothing);
  };
  for (const auto& [index, what] : parts) {
    empty(index);
    measure(what, false);
  }
  for (int k = actors->GetNumberOfItems() - 1; k > 8; --k) {
    auto* data =
        vtkPolyDataMapper::SafeDownCast(vtkActor::SafeDownCast(actors->GetItemAsObject(k))->GetMapper())->GetInput();
    const bool isLines = data->GetNumberOfPolys() == 0;
    if (isLines) empty(k);
  }
  measure("and without edges", false);
  for (int k = actors->GetNumberOfItems() - 1; k > 8; --k) empty(k);
  measure("and without objects", false);
  empty(0);
  measure("and without the room", false);
  view.renderWindow()->GetRenderers()->GetFirstRenderer()->GradientBackgroundOff();
  measure("and with one colour behind", false);
  measure("the same in the window", true);
}

TEST_F(Performance, ALargeProjectTurnsSmoothly) {
  ASSERT_TRUE(window_->openProject(largeProject()));
  ASSERT_TRUE(waitForCheck());
  const auto scene = window_->checker().latest()->scene;
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(scene->luminaires.size(), 500u);
  vtkIdType triangles = scene->room->GetNumberOfCells();
  for (const gui::SurfacePiece& piece : scene->objects) triangles += piece.data->GetNumberOfCells();
  EXPECT_GE(triangles, 200000);
  gui::RoomView view;
  view.resize(1280, 800);
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  view.showScene(scene, true);
  ASSERT_TRUE(wait([&] { return view.isDrawn(); }));
  saveScreenshot(QPixmap::fromImage(view.picture()), "large-hall");
  const auto mouse = [&](QEvent::Type type, const QPoint& at) {
    QMouseEvent event(type, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  };
  // Each move of the mouse is drawn, brought into the window and waited for.
  const auto turn = [&](int count) {
    QElapsedTimer clock;
    clock.start();
    for (int k = 0; k < count; ++k) {
      mouse(QEvent::MouseMove, QPoint(600 + 4 * k, 790));
      view.drawNow();
      view.repaint();
    }
    view.renderWindow()->WaitForCompletion();
    return 1e-9 * static_cast<double>(clock.nsecsElapsed()) / count;
  };
  mouse(QEvent::MouseButtonPress, QPoint(600, 790));
  turn(5);  // shaders are compiled, data go to the card
  const double before = core::processCpuSeconds();
  const double wall = turn(30);
  const double cpu = (core::processCpuSeconds() - before) / 30;
  saveScreenshot(QPixmap::fromImage(view.grabFramebuffer()), "large-hall-turning");
  Watchdog watchdog;
  for (int k = 0; k < 20; ++k) {
    mouse(QEvent::MouseMove, QPoint(500 + 5 * k, 600));
    QTest::qWait(20);
  }
  const Pause turning = watchdog.longest();
  const double turningCpu = watchdog.busiest().cpu;
  watchdog.forget();
  QElapsedTimer clock;
  clock.start();
  mouse(QEvent::MouseButtonRelease, QPoint(600, 600));
  ASSERT_TRUE(wait([&] { return view.isDrawn(); }));
  std::printf(
      "turning at 1280 x 800: %.1f pictures a second; %.1f ms of CPU time each (all threads), %.1f a second if "
      "that were all\n",
      1 / wall, 1e3 * cpu, 1 / cpu);
  const auto say = [](const char* when, const Pause& pause, double busiest) {
    std::printf(
        "longest pause %s: %.0f ms (computing %.0f, without a processor %.0f, waiting %.0f); most computed in "
        "one go %.0f ms\n",
        when, pause.clock, pause.cpu, pause.starved, pause.asleep(), busiest);
  };
  say("turning", turning, turningCpu);
  say("while the details come in", watchdog.longest(), watchdog.busiest().cpu);
  std::printf("all details are there after %.0f ms\n", static_cast<double>(clock.elapsed()));
  EXPECT_GT(1 / cpu, 8) << "CPU time counts, so that other programs do not; 20 is the goal, and tests may share caches";
  EXPECT_LE(turningCpu, 100);
  EXPECT_LE(watchdog.busiest().cpu, 100);
  EXPECT_LT(turning.clock, 3000) << "by the clock, on a machine that is shared";
  EXPECT_LT(watchdog.longest().clock, 3000);
}

}  // namespace
}  // namespace goniolux::test
