// How fast the interface is: its start, and the 3-D view of a large project with software OpenGL. The goals (window
// within 1 s, 20 pictures a second, no pause above 100 ms) hold on a machine of its own; tests share theirs, so that
// they fail only far beyond, and print the figures.
#include <vtkRenderWindow.h>
#include <QElapsedTimer>
#include <QProcess>

#include <cstdio>

#include "app/gui/room/room_view.h"
#include "gui/studio_fixture.h"
#include "gui/watchdog.h"

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

TEST_F(Performance, ALargeProjectTurnsSmoothly) {
  ASSERT_TRUE(window_->openProject(largeProject()));
  ASSERT_TRUE(waitForCheck());
  const auto scene = window_->checker().latest()->scene;
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(scene->luminaires.size(), 500u);
  EXPECT_GE(scene->room->GetNumberOfCells() + scene->objects->GetNumberOfCells(), 200000);
  gui::RoomView view;
  view.resize(1280, 800);
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  view.showScene(scene, true);
  QTest::qWait(500);
  const auto pictures = [&](int count) {
    QElapsedTimer clock;
    clock.start();
    for (int k = 0; k < count; ++k) {
      QMouseEvent press(QEvent::MouseButtonPress, QPoint(600, 790), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
      if (k == 0) QApplication::sendEvent(&view, &press);
      QMouseEvent move(QEvent::MouseMove, QPoint(600 + 4 * k, 790), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(&view, &move);
      view.drawNow();
      view.renderWindow()->WaitForCompletion();
    }
    return 1000.0 * count / static_cast<double>(std::max<qint64>(clock.elapsed(), 1));
  };
  pictures(5);  // shaders are compiled, data go to the card
  const double rate = pictures(30);
  Watchdog watchdog;
  for (int k = 0; k < 20; ++k) {
    QMouseEvent move(QEvent::MouseMove, QPoint(500 + 5 * k, 600), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
    QTest::qWait(20);
  }
  std::printf("%.1f pictures a second at 1280 x 800; longest pause while turning %.0f ms\n", rate, watchdog.longest());
  EXPECT_GT(rate, 2);  // the machine may be busy with other tests
  EXPECT_LT(watchdog.longest(), 600);
}

}  // namespace
}  // namespace goniolux::test
