// What a designer does besides: files dropped on the window, a luminaire replaced everywhere, several kinds of entries
// selected together, regions measured in a picture, cuts, levels, predictions, the documentation, the program without a
// display.
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QProcess>
#include <QTabWidget>
#include <QTableView>

#include <algorithm>
#include <cmath>

#include "app/gui/document/json_pointer.h"
#include "app/gui/plots/paper.h"
#include "app/gui/window/accuracy_panel.h"
#include "app/gui/window/help_window.h"
#include "app/gui/window/luminaire_page.h"
#include "app/gui/window/picture_page.h"
#include "app/gui/window/plan_page.h"
#include "app/gui/window/project_tree.h"
#include "app/gui/window/room_page.h"
#include "gui/studio_fixture.h"
#include "image/patch.h"

namespace goniolux::test {
namespace {

using core::Value;

class Habits : public StudioFixture {
 protected:
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent dropped(QPointF(400, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &dropped);
  }
  static QProcess& withoutDisplay(QProcess& process, const QStringList& words) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) environment.remove(name);
    process.setProcessEnvironment(environment);
    process.start(GONIOLUX_STUDIO, words);
    EXPECT_TRUE(process.waitForFinished(30000));
    return process;
  }
  QString write(const char* text) {
    const QString folder = folder_.filePath("written");
    QDir().mkpath(folder);
    QFile file(folder + "/project.json");
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return folder;
  }
  double number(const std::string& pointer) {
    const Value* value = window_->document().find(pointer);
    return value != nullptr && value->isNumber() ? value->number() : std::nan("");
  }
};

constexpr const char* smallRoom =
    R"({ "format": "goniolux-project", "version": 1, "materials": { "m": { "model": "lambert", "diffuse": 0.5 } },
  "objects": [
    { "name": "room", "shape": "box", "min": [0,0,0], "max": [6,4,3], "facing": "inward", "material": "m" },
    { "name": "desk", "shape": "box", "min": [2,1,0], "max": [3.6,1.8,0.75], "material": "m" } ],
  "luminaires": [ { "name": "L", "photometry": "cosine", "flux": 3000, "position": [4.5,3,2.9] } ],
  "grids": [ { "name": "g", "origin": [0,0,0.8], "u": [6,0,0], "v": [0,4,0], "counts": [60,50] } ],
  "settings": { "accuracy": { "grid": "10 %" } } })";

TEST_F(Habits, ALuminaireDroppedOnTheWindowReplacesAnotherEverywhere) {
  ASSERT_TRUE(window_->openProject(copyOf("small-office")));
  ASSERT_TRUE(waitForCheck());
  gui::Document& document = window_->document();
  const std::string old = document.find("/luminaires/0/photometry")->string();
  drop(QString(GONIOLUX_SOURCE_DIR) + "/luminaires/batten-t8.ldt");
  ASSERT_TRUE(QFileInfo::exists(document.folder() + "/batten-t8.ldt")) << "it is part of the project now";
  EXPECT_EQ(window_->luminairePage().shownName(), "batten-t8.ldt");
  ASSERT_TRUE(wait([this] { return window_->luminairePage().sheetText().contains("lm"); }));
  // A second entry with the same photometry, and one with another.
  Value copy = *document.find("/luminaires/0");
  copy.set("name", "second");
  document.append("/luminaires", copy, "copy");
  Value other = copy;
  other.set("name", "third");
  other.set("photometry", "cosine");
  other.set("flux", 1000);
  document.append("/luminaires", other, "other");
  const std::size_t count = document.find("/luminaires")->array().size();
  window_->tree().select("/luminaires/0");
  window_->replacePhotometry("batten-t8.ldt", true);
  std::size_t replaced = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string now = document.find(gui::under(gui::under("/luminaires", i), "photometry"))->string();
    EXPECT_NE(now, old);
    if (now == "batten-t8.ldt") ++replaced;
  }
  EXPECT_EQ(replaced, count - 1) << "all that had the old photometry, and no other";
  document.undoStack().undo();
  EXPECT_EQ(document.find("/luminaires/0/photometry")->string(), old) << "in one step";
  ASSERT_TRUE(waitForCheck());
}

TEST_F(Habits, LuminairesAndObjectsAreMovedCopiedAndRemovedTogether) {
  ASSERT_TRUE(window_->openProject(write(smallRoom)));
  ASSERT_TRUE(waitForCheck());
  gui::Document& document = window_->document();
  gui::RoomView& view = window_->roomPage().view();
  view.setPreset(gui::OrbitCamera::Preset::plan);
  QTest::qWait(200);
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget({2.8, 1.4, 0.75}));
  QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, view.toWidget({4.5, 3, 2.9}));
  ASSERT_EQ(window_->tree().selection(), (std::vector<std::string>{"/luminaires/0", "/objects/1"}));
  screenshot("several-kinds");
  const QPoint from = view.toWidget({2.8, 1.4, 0.75}), to = view.toWidget({2.3, 1.4, 0.75});
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
  for (int k = 1; k <= 4; ++k) {
    const QPoint at = from + (to - from) * k / 4;
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
  }
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
  EXPECT_NEAR(number("/objects/1/min/0"), 1.5, 0.05);
  EXPECT_NEAR(number("/luminaires/0/position/0"), 4, 0.05);
  document.undoStack().undo();
  EXPECT_FALSE(document.isModified()) << "one step of undo";
  window_->tree().select("/luminaires/0");
  window_->tree().select("/objects/1", true);
  window_->tree().copySelection();
  window_->tree().paste();
  EXPECT_EQ(document.find("/luminaires")->array().size(), 2u);
  EXPECT_EQ(document.find("/objects")->array().size(), 3u);
  EXPECT_EQ(window_->tree().selection(), (std::vector<std::string>{"/luminaires/1", "/objects/2"}));
  ASSERT_TRUE(waitForCheck());
  EXPECT_TRUE(window_->checker().latest()->project) << "the engine accepts the copies";
  window_->tree().removeSelection();
  EXPECT_EQ(document.find("/luminaires")->array().size(), 1u);
  EXPECT_EQ(document.find("/objects")->array().size(), 2u);
  document.undoStack().undo();
  document.undoStack().undo();
  EXPECT_FALSE(document.isModified()) << "pasted in one step, removed in one step";
}

TEST_F(Habits, ACutOpensTheRoomFromAnySideAndWhatIsCutAwayIsNotClicked) {
  using gui::Cut;
  const gui::Ray down{{1, 1, 5}, {0, 0, -1}};
  EXPECT_NEAR((Cut{2, 2, true}).of(down).least, 3, 1e-12) << "above 2 m nothing counts";
  EXPECT_TRUE(std::isinf((Cut{2, 2, true}).of(down).most));
  EXPECT_NEAR((Cut{2, 2, false}).of(down).most, 3, 1e-12);
  const Cut beside{0, 0.5, true};
  EXPECT_LE(beside.of(down).most, beside.of(down).least) << "beyond a plane that it runs along nothing is left";
  ASSERT_TRUE(window_->openProject(write(smallRoom)));
  ASSERT_TRUE(waitForCheck());
  gui::RoomView& view = window_->roomPage().view();
  view.setPreset(gui::OrbitCamera::Preset::plan);
  QTest::qWait(200);
  const QImage whole = view.grabFramebuffer();
  view.setCut(Cut{0, 1.5, true});
  QTest::qWait(200);
  EXPECT_NE(view.grabFramebuffer(), whole);
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget({2.8, 1.4, 0.75}));
  EXPECT_TRUE(view.selection().empty()) << "the desk is cut away";
  view.setCut(Cut{0, 1.5, false});
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget({2.8, 1.4, 0.75}));
  EXPECT_EQ(view.selection(), std::vector<std::string>{"/objects/1"});
}

TEST_F(Habits, ValuesOfALargeGridAreATableAndLevelsAreChosen) {
  ASSERT_TRUE(window_->openProject(write(smallRoom)));
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(waitForJobs());
  ASSERT_NE(window_->calculate(), nullptr);
  ASSERT_TRUE(waitForJobs());
  ASSERT_TRUE(wait([this] { return window_->currentResults() != nullptr; }));
  window_->pages().setCurrentIndex(1);
  ASSERT_TRUE(wait([this] { return window_->planPage().view().isDrawn(); }));
  window_->planPage().findChild<QTabWidget*>("charts")->setCurrentIndex(2);
  auto* values = window_->planPage().findChild<QTableView*>("values");
  ASSERT_TRUE(wait([&] { return values->model()->rowCount() == 3000; })) << "every point has its row";
  values->sortByColumn(2, Qt::DescendingOrder);
  const auto& grid = window_->currentResults()->grids[0];
  const double most = values->model()->index(0, 2).data().toString().section(' ', 0, 0).toDouble();
  EXPECT_NEAR(most, *std::max_element(grid.values.begin(), grid.values.end()), 0.006 * most) << "as it is rounded";
  auto* levels = window_->planPage().findChild<QLineEdit*>("levels");
  levels->setText("40, 20 80");
  Q_EMIT levels->editingFinished();
  EXPECT_EQ(window_->planPage().view().scale().levels, (std::vector<double>{20, 40, 80}));
  ASSERT_TRUE(wait([this] {
    const auto content = window_->planPage().view().content();
    return content && content->map.levels == std::vector<double>{20, 40, 80};
  }));
  levels->setText("much");
  Q_EMIT levels->editingFinished();
  EXPECT_TRUE(levels->property("wrong").toBool());
  EXPECT_EQ(window_->planPage().view().scale().levels, (std::vector<double>{20, 40, 80})) << "the old ones stay";
  screenshot("values-and-levels");
}

TEST_F(Habits, RegionsOfAPictureAreMeasured) {
  ASSERT_TRUE(window_->openProject(write(smallRoom)));
  ASSERT_TRUE(waitForCheck());
  // A picture whose luminance is the number of its column.
  auto image = std::make_shared<image::XyzImage>();
  image->width = 40;
  image->height = 30;
  for (auto* channel : {&image->x, &image->y, &image->z}) channel->resize(1200);
  for (std::size_t i = 0; i < image->y.size(); ++i) {
    image->y[i] = static_cast<float>(i % 40);
    image->x[i] = 0.95F * image->y[i];
    image->z[i] = 1.09F * image->y[i];
  }
  gui::PicturePage& page = window_->picturePage();
  window_->pages().setCurrentIndex(2);
  page.show({image, "view", {}, 1, 0.05, true});
  ASSERT_TRUE(wait([&] { return !page.canvas().picture().isNull(); }));
  QTest::qWait(100);
  auto* meter = page.findChild<QLabel*>("meter");
  gui::ImageCanvas& canvas = page.canvas();
  // A rectangle over the columns 10 to 19.
  page.setTool(gui::ImageCanvas::Tool::rectangle);
  const QPoint corner = (canvas.toWidget({9, 5}) + canvas.toWidget({10, 6})) / 2;
  const QPoint opposite = (canvas.toWidget({19, 15}) + canvas.toWidget({20, 16})) / 2;
  QTest::mousePress(&canvas, Qt::LeftButton, Qt::NoModifier, corner);
  QMouseEvent move(QEvent::MouseMove, opposite, canvas.mapToGlobal(opposite), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QApplication::sendEvent(&canvas, &move);
  QTest::mouseRelease(&canvas, Qt::LeftButton, Qt::NoModifier, opposite);
  EXPECT_TRUE(meter->text().contains("<b>14.5 cd/m²</b>")) << meter->text().toStdString();
  EXPECT_TRUE(meter->text().contains("10, 19 cd/m²")) << meter->text().toStdString();
  EXPECT_TRUE(meter->text().contains("<b>100</b>")) << "10 x 10 pixels: " << meter->text().toStdString();
  screenshot("region");
  // A polygon, closed at its first corner; Escape takes it back.
  page.setTool(gui::ImageCanvas::Tool::polygon);
  for (const QPoint& pixel : {QPoint(5, 5), QPoint(35, 5), QPoint(35, 25), QPoint(5, 5)})
    QTest::mouseClick(&canvas, Qt::LeftButton, Qt::NoModifier, canvas.toWidget(pixel));
  EXPECT_EQ(canvas.region().size(), 3);
  const double mean = meter->text().section("<b>", 1, 1).section(' ', 0, 0).toDouble();
  EXPECT_NEAR(mean, (5.5 + 2 * 35.5) / 3 - 0.5, 0.3) << "the mean column of a triangle is its centroid's";
  QTest::keyClick(&canvas, Qt::Key_Escape);
  EXPECT_TRUE(canvas.region().isEmpty());
}

TEST_F(Habits, TimesArePredictedForEveryAccuracyAndShownBesideIt) {
  ASSERT_TRUE(window_->openProject(write(smallRoom)));
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(waitForJobs());
  window_->accuracyPanel().estimate();
  ASSERT_TRUE(waitForJobs(240000));
  ASSERT_TRUE(wait([this] { return window_->accuracyPanel().estimates() == gui::AccuracyPanel::choices().size(); }));
  auto* control = window_->findChild<QComboBox*>("accuracy");
  EXPECT_TRUE(control->itemText(control->findData("1 %")).contains("about")) << control->itemText(4).toStdString();
  window_->document().set("/settings/accuracy/grid", "2 %", "accuracy");
  ASSERT_TRUE(waitForCheck());
  QTest::qWait(100);
  EXPECT_TRUE(control->currentText().contains("about")) << "another accuracy leaves the predictions standing";
  screenshot("accuracy");
  window_->document().set("/luminaires/0/flux", 1, "flux");
  ASSERT_TRUE(waitForCheck());
  EXPECT_TRUE(wait([&] { return !control->itemText(control->findData("1 %")).contains("about"); }))
      << "of another project nothing is known";
}

TEST_F(Habits, TheWorkPrecisionChartOfTheOpenProjectIsDrawn) {
  ASSERT_TRUE(window_->openProject(write(smallRoom)));
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(waitForJobs());
  window_->document().set("/grids/0/counts/0", 6, "fewer");
  window_->document().set("/grids/0/counts/1", 4, "fewer");
  ASSERT_TRUE(waitForCheck());
  QTest::qWait(100);
  window_->findChild<QDockWidget*>("accuracyDock")->raise();
  window_->accuracyPanel().study(8);
  ASSERT_TRUE(waitForJobs(240000));
  EXPECT_EQ(window_->jobs().jobs().back()->state(), gui::Job::State::done)
      << window_->jobs().jobs().back()->failure().toStdString();
  ASSERT_TRUE(wait([this] { return window_->accuracyPanel().chart().isDrawn(); }));
  screenshot("work-precision");
}

TEST_F(Habits, HelpOpensTheDocumentationAndItsLinks) {
  window_->showDocumentation();
  ASSERT_NE(window_->help(), nullptr);
  EXPECT_TRUE(window_->help()->shown().endsWith("docs/studio/README.md"));
  QTest::qWait(200);
  saveScreenshot(window_->help()->grab(), "help");
  for (const char* page : {"studio/README.md", "getting-started.md", "project-format.md"})
    EXPECT_FALSE(gui::HelpWindow::fileOf(page).isEmpty()) << page;
  EXPECT_FALSE(window_->help()->open("no-such-page.md"));
}

TEST_F(Habits, HelpAndVersionNeedNoDisplay) {
  QProcess help, version, wrong, none;
  EXPECT_TRUE(withoutDisplay(help, {"--help"}).readAllStandardOutput().contains("Usage: goniolux-studio"));
  EXPECT_EQ(help.exitCode(), 0);
  EXPECT_EQ(withoutDisplay(version, {"--version"}).readAllStandardOutput().trimmed(),
            QByteArray("goniolux-studio " GONIOLUX_VERSION));
  EXPECT_TRUE(withoutDisplay(wrong, {"--no-such"}).readAllStandardError().contains("--help"));
  EXPECT_EQ(wrong.exitCode(), 2);
  EXPECT_TRUE(withoutDisplay(none, {}).readAllStandardError().contains("no display"));
  EXPECT_EQ(none.exitCode(), 2);
}

}  // namespace
}  // namespace goniolux::test
