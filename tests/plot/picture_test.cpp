// The helper program and the stage that starts it, on a synthetic results folder.
#include <gtest/gtest.h>
#include <png.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>

#include "core/document.h"
#include "pipeline/helper_process.h"
#include "pipeline/plot.h"
#include "pipeline/result_files.h"
#include "pipeline/stages.h"
#include "plot/figure.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using core::Vec3;
using test::contentOf;
using test::TemporaryFolder;

const std::string helper = std::string(GONIOLUX_BINARY_DIR) + "/libexec/goniolux-plot";

/// Sets an environment variable for one scope.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
  ~Environment() { unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
};

/// A 6 x 4 m room: two bright spots, one excluded point.
project::Results sampleResults() {
  project::Results results;
  results.project = "Sample <office> & more";
  results.projectHash = "0123456789abcdef0123";
  results.programVersion = "0.1.0";
  project::GridResult grid;
  grid.name = "work plane";
  grid.counts = {30, 20};
  grid.plane = project::GridPlane{{0, 0, 0.8}, {6, 0, 0}, {0, 4, 0}};
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 30; ++i) {
      const double x = 0.1 + 0.2 * i, y = 0.1 + 0.2 * j;
      grid.points.emplace_back(x, y, 0.8);
      const double left = std::hypot(x - 1.5, y - 2), right = std::hypot(x - 4.5, y - 2);
      grid.values.push_back(250 + 400 * std::exp(-left * left) + 300 * std::exp(-right * right));
      grid.halfWidths.push_back(0.01 * grid.values.back());
    }
  }
  grid.parts["statistical"] = grid.halfWidths;
  grid.excluded = {31};
  grid.values[31] = grid.halfWidths[31] = grid.parts["statistical"][31] = std::numeric_limits<double>::quiet_NaN();
  grid.mean = {380, 2, {}};
  grid.min = {250, 3, {}};
  grid.max = {650, 5, {}};
  grid.u0 = {0.66, 0.01, {}};
  grid.ud = {0.38, 0.01, {}};
  results.grids.push_back(grid);
  return results;
}

Outline sampleOutline() {
  Outline outline;
  outline.projectHash = "0123456789abcdef0123";
  outline.high = {6, 4, 3};
  const auto rectangle = [](const Vec3& a, const Vec3& b) {
    const Vec3 c(b.x, a.y, a.z), d(a.x, b.y, a.z);
    return std::vector<Segment>{{a, c}, {c, b}, {b, d}, {d, a}};
  };
  outline.objects.push_back({"room", true, rectangle({0, 0, 0}, {6, 4, 0}), rectangle({0, 0, 0}, {6, 4, 0})});
  outline.objects.push_back(
      {"desk", false, rectangle({3, 1, 0.7}, {4.6, 1.8, 0.7}), rectangle({3, 1, 0.7}, {4.6, 1.8, 0.7})});
  outline.luminaires.push_back(
      {"L[0]", "L", {1.5, 2, 3}, {0, 0, -1}, {{1.2, 1.7, 3}, {1.8, 1.7, 3}, {1.8, 2.3, 3}, {1.2, 2.3, 3}}});
  outline.luminaires.push_back({"spot", "spot", {4.5, 2, 3}, {0, 0, -1}, {}});
  return outline;
}

struct Pixels {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
  [[nodiscard]] int at(int x, int y) const {
    const auto i = static_cast<std::size_t>(3 * (y * width + x));
    return rgb[i] << 16 | rgb[i + 1] << 8 | rgb[i + 2];
  }
};

Pixels readPng(const fs::path& file) {
  Pixels pixels;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) throw std::runtime_error(image.message);
  image.format = PNG_FORMAT_RGB;
  pixels.width = static_cast<int>(image.width);
  pixels.height = static_cast<int>(image.height);
  pixels.rgb.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(image.message);
  return pixels;
}

StageReport runPlot(const fs::path& folder, const std::map<std::string, std::string>& options) {
  StageRequest request;
  request.inputs = {folder.string()};
  request.options = options;
  core::SilentProgress progress;
  return plotStage().run(request, progress);
}

/// How many colours cover at least a thousandth of the map's area.
std::size_t largeColours(const Pixels& pixels) {
  std::map<int, int> areas;
  for (int y = pixels.height / 4; y < pixels.height * 3 / 4; ++y) {
    for (int x = pixels.width / 8; x < pixels.width * 3 / 4; ++x) ++areas[pixels.at(x, y)];
  }
  std::size_t count = 0;
  for (const auto& [colour, area] : areas) count += area > pixels.width * pixels.height / 1000 ? 1U : 0U;
  return count;
}

TEST(PlotStage, DrawsAPngOfTheSizeAskedWithOneColourPerBand) {
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), sampleResults(), sampleOutline());
  const StageReport report = runPlot(folder.path(), {{"size", "1200x800"}, {"levels", "300,400,500,600"}});
  ASSERT_TRUE(report.warnings.all().empty()) << core::toString(report.warnings.all().front());
  const Pixels pixels = readPng(folder.path() / "work-plane.png");
  EXPECT_EQ(pixels.width, 1200);
  EXPECT_EQ(pixels.height, 800);
  EXPECT_EQ(pixels.at(2, 2), 0xffffff);
  EXPECT_EQ(pixels.at(1197, 797), 0xffffff);
  EXPECT_GE(largeColours(pixels), 5U) << "five bands between and beside four levels";
}

TEST(PlotStage, WritesAnSvgWithItsWordsAsWords) {
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), sampleResults(), sampleOutline());
  const StageReport report = runPlot(folder.path(), {{"format", "svg"}, {"levels", "300,400,500,600"}});
  EXPECT_FALSE(fs::exists(folder.path() / "work-plane.png"));
  const std::string svg = contentOf(folder.path() / "work-plane.svg");
  for (const char* words : {">300</text>", ">400</text>", ">500</text>", ">600</text>", ">x / m</text>",
                            ">in lx</text>", "Sample &lt;office&gt; &amp; more", "mean 380 ± 2 lx",
                            ">Illuminance</text>", ">luminaire</text>", ">not counted</text>"}) {
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(svg.find("Sample <office>"), std::string::npos);
}

TEST(PlotStage, SaysWhenDrawingIsNotPossibleAndKeepsTheData) {
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), sampleResults(), sampleOutline());
  folder.write("work-plane.png", "an earlier picture");
  const Environment off("GONIOLUX_PLOT_NO_GL", "1");
  const StageReport report = runPlot(folder.path(), {});
  ASSERT_EQ(report.warnings.all().size(), 1U);
  EXPECT_NE(report.warnings.all()[0].message.find("drawing is not possible here: "), std::string::npos);
  EXPECT_FALSE(report.warnings.hasErrors());
  EXPECT_FALSE(fs::exists(folder.path() / "work-plane.png")) << "an old picture must not pass for a new one";
  EXPECT_TRUE(fs::exists(folder.path() / "work-plane.csv"));
  EXPECT_TRUE(fs::exists(folder.path() / "work-plane.vtp"));
  EXPECT_TRUE(fs::exists(folder.path() / "work-plane.svg")) << "SVG needs no OpenGL";
}

TEST(PlotStage, SurvivesAMachineWithoutAnyEglVendor) {
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), sampleResults(), sampleOutline());
  const Environment off("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent");
  const StageReport report = runPlot(folder.path(), {{"format", "png"}});
  ASSERT_EQ(report.warnings.all().size(), 1U);
  EXPECT_NE(report.warnings.all()[0].message.find("drawing is not possible here: no OpenGL"), std::string::npos)
      << report.warnings.all()[0].message;
}

TEST(PlotStage, SurvivesAHelperThatIsMissingOrDies) {
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), sampleResults(), sampleOutline());
  {
    const Environment missing("GONIOLUX_PLOT", "/nonexistent/goniolux-plot");
    const StageReport report = runPlot(folder.path(), {});
    ASSERT_EQ(report.warnings.all().size(), 1U);
    EXPECT_NE(report.warnings.all()[0].message.find("could not be started"), std::string::npos);
  }
  const fs::path dying = folder.write("dying", "#!/bin/sh\nkill -SEGV $$\n");
  fs::permissions(dying, fs::perms::owner_all);
  const Environment named("GONIOLUX_PLOT", dying.string());
  const StageReport report = runPlot(folder.path(), {});
  ASSERT_EQ(report.warnings.all().size(), 1U);
  EXPECT_NE(report.warnings.all()[0].message.find("ended by signal 11"), std::string::npos);
}

TEST(PlotStage, DrawsWithoutAnOutlineAndSaysSo) {
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), sampleResults(), sampleOutline());
  fs::remove(folder.path() / "outline.json");
  const StageReport report = runPlot(folder.path(), {{"format", "svg"}});
  ASSERT_EQ(report.warnings.all().size(), 1U);
  EXPECT_EQ(report.warnings.all()[0].rule, "no-outline");
  EXPECT_EQ(contentOf(folder.path() / "work-plane.svg").find(">luminaire</text>"), std::string::npos);
}

TEST(PlotStage, RefusesBadOptionsAndDamagedResultsWithAMessage) {
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), sampleResults(), sampleOutline());
  for (const auto& [key, value] :
       {std::pair("format", "jpeg"), std::pair("levels", "many"), std::pair("palette", "rainbow"),
        std::pair("size", "10x10"), std::pair("grid", "desk")}) {
    EXPECT_THROW(runPlot(folder.path(), {{key, value}}), core::InputError) << key;
  }
  folder.write("grids.json", "{\"format\": \"goniolux-results\", \"version\": 1");
  EXPECT_THROW(runPlot(folder.path(), {}), core::InputError);
  EXPECT_THROW(runPlot(folder.path() / "nowhere", {}), core::InputError);
}

TEST(PlotStage, DrawsRotatedUprightAndListedGrids) {
  project::Results results = sampleResults();
  project::GridResult rotated = results.grids[0], upright = rotated, listed = rotated, uniform = rotated;
  const double c = std::cos(0.5), s = std::sin(0.5);
  rotated.name = "rotated";
  rotated.plane = project::GridPlane{{0, 0, 0.8}, {6 * c, 6 * s, 0}, {-4 * s, 4 * c, 0}};
  for (Vec3& p : rotated.points) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  upright.name = "board";
  upright.plane = project::GridPlane{{0, 4, 1}, {6, 0, 0}, {0, 0, 4}};
  for (Vec3& p : upright.points) p = {p.x, 4, 1 + p.y};
  listed.name = "points";
  listed.counts.reset();
  listed.plane.reset();
  uniform.name = "uniform";
  for (double& value : uniform.values) value = std::isnan(value) ? value : 500;
  results.grids = {rotated, upright, listed, uniform};
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), results, sampleOutline());
  const StageReport report = runPlot(folder.path(), {{"format", "svg"}});
  EXPECT_TRUE(report.warnings.all().empty());
  EXPECT_EQ(report.json.find("pictures")->array().size(), 4U);
  EXPECT_NE(contentOf(folder.path() / "board.svg").find(">height z / m</text>"), std::string::npos);
}

TEST(Helper, RefusesGarbageWithAMessageAndExitCode2) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.png").string();
  for (const char* garbage : {"", "garbage", "{}", "[1,2", "{\"format\":\"goniolux-figure\",\"version\":1}",
                              "{\"format\":\"goniolux-figure\",\"version\":2,\"kind\":\"plan-map\"}"}) {
    const fs::path figure = folder.write("figure.json", garbage);
    const ProcessEnd end = runHelper(helper, {figure.string(), out}, 20);
    EXPECT_EQ(end.how, ProcessEnd::How::exited);
    EXPECT_EQ(end.code, 2) << garbage;
    EXPECT_NE(end.errors.find("error: "), std::string::npos) << garbage;
    EXPECT_FALSE(fs::exists(out));
  }
  EXPECT_EQ(runHelper(helper, {}, 20).code, 2);
  EXPECT_EQ(runHelper(helper, {"/nonexistent.json", out}, 20).code, 2);
}

TEST(Helper, IsEndedWhenItTakesTooLong) {
  const TemporaryFolder folder;
  const fs::path sleeper = folder.write("sleeper", "#!/bin/sh\nexec sleep 20\n");
  fs::permissions(sleeper, fs::perms::owner_all);
  EXPECT_EQ(runHelper(sleeper.string(), {}, 0.2).how, ProcessEnd::How::timedOut);
}

void expectReadBackByVtk(const TemporaryFolder& folder, const project::Results& results, const std::string& file) {
  const std::string out = (folder.path() / "back.json").string();
  const ProcessEnd end = runHelper(helper, {"--read-back", (folder.path() / file).string(), out}, 20);
  ASSERT_EQ(end.code, 0) << end.errors;
  core::Diagnostics diagnostics;
  const core::Value back = core::parseJson(core::readFile(out), out, diagnostics);
  const project::GridResult& grid = results.grids[0];
  ASSERT_EQ(back.find("points")->array().size(), grid.points.size());
  EXPECT_EQ(back.find("scalars")->string(), "illuminance_lx");
  const core::Value& values = *back.find("arrays")->find("illuminance_lx");
  const core::Value& halfWidths = *back.find("arrays")->find("half_width_lx");
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    EXPECT_EQ(back.find("points")->array()[i].array()[0].number(), grid.points[i].x);
    if (i == 31) {
      EXPECT_TRUE(values.array()[i].isNull()) << "excluded";
      continue;
    }
    EXPECT_EQ(values.array()[i].number(), grid.values[i]);
    EXPECT_EQ(halfWidths.array()[i].number(), grid.halfWidths[i]);
  }
  EXPECT_EQ(back.find("polygons")->number(), 29 * 19 - 4) << "every square but the four at the excluded point";
}

TEST(Vtp, IsReadBackByVtkWithTheSameNumbers) {
  const TemporaryFolder folder;
  const project::Results results = sampleResults();
  writeResultFiles(folder.path().string(), results, sampleOutline());
  expectReadBackByVtk(folder, results, "work-plane.vtp");
}

TEST(Vtu, IsReadBackByVtkWithTheSameNumbers) {
  const TemporaryFolder folder;
  const project::Results results = sampleResults();
  folder.write("work-plane.vtu", gridVtu(results, results.grids[0]));
  expectReadBackByVtk(folder, results, "work-plane.vtu");
}

TEST(Vtp, HoldsTheOutlineAsLines) {
  const TemporaryFolder folder;
  writeResultFiles(folder.path().string(), sampleResults(), sampleOutline());
  const std::string out = (folder.path() / "back.json").string();
  ASSERT_EQ(runHelper(helper, {"--read-back", (folder.path() / "outline.vtp").string(), out}, 20).code, 0);
  core::Diagnostics diagnostics;
  const core::Value back = core::parseJson(core::readFile(out), out, diagnostics);
  EXPECT_EQ(back.find("lines")->number(), 4 + 4 + 1);
  EXPECT_EQ(back.find("vertices")->number(), 1);
}

TEST(Figure, ReadsBackWhatItWrote) {
  const project::Results results = sampleResults();
  const Outline outline = sampleOutline();
  const plot::PlanMap map = planMapOf(results, results.grids[0], &outline, {});
  core::Diagnostics diagnostics;
  const std::string text = core::toJson(plot::toJson(map));
  const plot::PlanMap back = plot::planMapFromJson(core::parseJson(text, "figure.json", diagnostics));
  EXPECT_EQ(core::toJson(plot::toJson(back)), text);
  EXPECT_EQ(back.luminaires.size(), 2U);
  EXPECT_EQ(back.roomLines.size(), 1U);
}

}  // namespace
}  // namespace goniolux::pipeline
