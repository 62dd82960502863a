#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "display/device.h"
#include "display/mapping.h"
#include "image/exr.h"
#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

// A grey ramp from 1 to 400 cd/m2 and, in the last column, a light of 10 000 cd/m2 and a pure green.
void writeTestImage(const std::filesystem::path& path, bool namesItsWhite = false) {
  image::XyzImage image;
  image.width = 41;
  image.height = 2;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 41; ++x) {
      const float luminance = x == 40 ? (y == 0 ? 10000.0F : 50.0F) : 1.0F + 10.0F * static_cast<float>(x);
      const bool green = x == 40 && y == 1;
      image.x.push_back(luminance * (green ? 0.1F : 0.9505F));
      image.y.push_back(luminance);
      image.z.push_back(luminance * (green ? 0.1F : 1.0890F));
    }
  }
  if (namesItsWhite) image.attributes["adoptedWhite"] = "0.4476 0.4074";
  image::writeExr(path.string(), image);
}

StageReport runDisplay(const std::filesystem::path& input, const std::filesystem::path& output,
                       std::map<std::string, std::string> options = {}) {
  StageRequest request;
  request.inputs = {input.string()};
  if (!output.empty()) request.common.output = output.string();
  request.options = std::move(options);
  core::SilentProgress progress;
  return displayStage().run(request, progress);
}

TEST(DisplayStage, WritesAPictureAndCountsWhatTheDeviceCannotShow) {
  const test::TemporaryFolder folder;
  writeTestImage(folder.path() / "view.exr");
  const auto report = runDisplay(folder.path() / "view.exr", folder.path() / "view.png", {{"white", "500"}});
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "view.png"));
  EXPECT_EQ(report.json.find("clipped")->find("pixels")->number(), 1);
  EXPECT_EQ(report.json.find("out_of_gamut")->find("pixels")->number(), 1);
  EXPECT_EQ(report.json.find("exposure")->find("white_cd_m2")->number(), 500);
  EXPECT_TRUE(report.json.find("adopted_white")->isNull());
  EXPECT_NE(report.text.find("1 (1.22 %) pixels clipped"), std::string::npos) << report.text;
}

TEST(DisplayStage, WithoutAnOutputThePictureStandsBesideTheImage) {
  const test::TemporaryFolder folder;
  writeTestImage(folder.path() / "view.exr");
  const auto report = runDisplay(folder.path() / "view.exr", {});
  EXPECT_EQ(report.files, std::vector<std::string>{(folder.path() / "view.png").string()});
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "view.png"));
}

TEST(DisplayStage, AdaptsToTheWhiteThatTheImageNamesUnlessToldNotTo) {
  const test::TemporaryFolder folder;
  const auto image = folder.path() / "view.exr";
  writeTestImage(image, true);
  const auto adapted = runDisplay(image, folder.path() / "a.png");
  EXPECT_NEAR(adapted.json.find("adopted_white")->array().at(0).number(), 0.4476, 1e-12);
  const auto plain = runDisplay(image, folder.path() / "b.png", {{"adapt", "none"}});
  EXPECT_TRUE(plain.json.find("adopted_white")->isNull());
  EXPECT_NE(test::contentOf(folder.path() / "a.png"), test::contentOf(folder.path() / "b.png"));
}

TEST(DisplayStage, BadInputIsRefusedAndEarlierPicturesStay) {
  const test::TemporaryFolder folder;
  const auto image = folder.path() / "view.exr";
  writeTestImage(image);
  const auto earlier = folder.write("earlier.png", "earlier");
  const std::map<std::string, std::string> wrong[] = {{{"device", "no-such-device"}},
                                                      {{"exposure", "bright"}},
                                                      {{"white", "-1"}},
                                                      {{"white", "100"}, {"exposure", "9"}},
                                                      {{"adapt", "0.9,0.9"}},
                                                      {{"bits", "12"}},
                                                      {{"mapping", "warp"}},
                                                      {{"mapping", "ward:glue"}},
                                                      {{"gamut", "stretch"}},
                                                      {{"cat", "cat99"}},
                                                      {{"map", "map.gif"}},
                                                      {{"mapping", "ward"}, {"white", "100"}}};
  for (const auto& options : wrong) {
    EXPECT_THROW(runDisplay(image, earlier, options), core::InputError) << options.begin()->first;
  }
  EXPECT_THROW(runDisplay(folder.write("damaged.exr", "no image"), earlier), core::InputError);
  EXPECT_THROW(runDisplay(folder.path() / "absent.exr", earlier), core::InputError);
  EXPECT_THROW(runDisplay(image, image), core::InputError) << "the image must not become the picture";
  EXPECT_THROW(runDisplay(image, folder.path() / "view.gif"), core::InputError);
  EXPECT_EQ(test::contentOf(earlier), "earlier");
}

TEST(DisplayStage, EveryMappingAndEveryDeviceGivesAPicture) {
  const test::TemporaryFolder folder;
  writeTestImage(folder.path() / "view.exr", true);
  for (const auto& mapping : display::mappingTypes()) {
    const auto report = runDisplay(folder.path() / "view.exr", folder.path() / "a.png", {{"mapping", mapping.name}});
    EXPECT_EQ(report.json.find("mapping")->string(), mapping.name);
    EXPECT_GT(std::filesystem::file_size(folder.path() / "a.png"), 200U) << mapping.name;
    EXPECT_LT(report.json.find("clipped")->find("fraction")->number(), 1) << mapping.name;
  }
  for (const auto& device : display::presetNames()) {
    const auto report =
        runDisplay(folder.path() / "view.exr", folder.path() / "a.dpx", {{"device", device}, {"gamut", "neutral"}});
    EXPECT_EQ(report.json.find("bits")->number(), 10) << device;
    EXPECT_EQ(report.json.find("rgb_from_xyz")->array().size(), 3U) << device;
  }
}

// EXR: the light of the monitor, as R, G, B of its primaries; read back it is what the way back from codes gives.
TEST(DisplayStage, ExrIsTheLightOfTheMonitor) {
  const test::TemporaryFolder folder;
  writeTestImage(folder.path() / "view.exr");
  const auto wanted = image::readExr((folder.path() / "view.exr").string());
  for (const char* device : {"srgb", "studio-monitor-1985", "film-slide"}) {
    runDisplay(folder.path() / "view.exr", folder.path() / "shown.exr", {{"device", device}, {"mapping", "none"}});
    const auto shown = image::readExr((folder.path() / "shown.exr").string());
    EXPECT_FALSE(shown.attributes.contains(image::unitsAttribute) &&
                 shown.attributes.at(image::unitsAttribute) == "relative")
        << device;
    for (const std::size_t i : {1U, 3U}) {                          // 11 and 31 cd/m2
      if (i == 3 && device == std::string("film-slide")) continue;  // daylight's blue at 31 cd/m2 is beyond its lamp
      EXPECT_NEAR(shown.y[i], wanted.y[i], 0.005F * wanted.y[i]) << device;
      EXPECT_NEAR(shown.x[i], wanted.x[i], 0.005F * wanted.x[i]) << device;
      EXPECT_NEAR(shown.z[i], wanted.z[i], 0.005F * wanted.z[i]) << device;
    }
    EXPECT_LT(shown.y[30], 130) << device << " has no more";
  }
}

// The way back: what the picture shows is what was asked for, within the rounding of ten bits.
TEST(DisplayStage, InverseGivesTheLightOfThePicture) {
  const test::TemporaryFolder folder;
  writeTestImage(folder.path() / "view.exr");
  for (const char* device : {"studio-monitor-1985", "film-negative-print"}) {
    runDisplay(folder.path() / "view.exr", folder.path() / "view.dpx",
               {{"device", device}, {"mapping", "none"}, {"gamut", "neutral"}});
    const auto report =
        runDisplay(folder.path() / "view.dpx", folder.path() / "back.exr", {{"device", device}, {"inverse", "true"}});
    EXPECT_EQ(report.json.find("unit")->string(), "cd/m2");
    const auto wanted = image::readExr((folder.path() / "view.exr").string());
    const auto back = image::readExr((folder.path() / "back.exr").string());
    EXPECT_NEAR(back.y[1], wanted.y[1], 0.02F * wanted.y[1]) << device;  // 11 cd/m2
    EXPECT_NEAR(back.y[3], wanted.y[3], 0.02F * wanted.y[3]) << device;  // 31 cd/m2
    EXPECT_LT(back.y[30], 130) << device << " has no more";
  }
}

TEST(DisplayStage, MeasuredPatchesAreComparedWithTheDevice) {
  const test::TemporaryFolder folder;
  const auto patches =
      folder.write("patches.txt", "# R G B X Y Z\n255 255 255 76.04 80 87.1\n0,0,0\n255 0 0 34 17 1.5\n");
  const auto report = runDisplay(patches, {}, {{"inverse", "true"}});
  EXPECT_EQ(report.json.find("patches")->array().size(), 3U);
  EXPECT_LT(report.json.find("patches")->array().at(0).find("delta_e00")->number(), 0.1);
  EXPECT_GT(report.json.find("delta_e00_max")->number(), 0.1);
  EXPECT_THROW(runDisplay(folder.write("bad.txt", "256 0 0\n"), {}, {{"inverse", "true"}}), core::InputError);
  EXPECT_THROW(runDisplay(folder.write("bad.txt", "1 2\n"), {}, {{"inverse", "true"}}), core::InputError);
}

TEST(DisplayStage, TiffHasSixteenBits) {
  const test::TemporaryFolder folder;
  writeTestImage(folder.path() / "view.exr");
  const auto report = runDisplay(folder.path() / "view.exr", folder.path() / "view.tif");
  EXPECT_EQ(report.json.find("bits")->number(), 16);
}

}  // namespace
}  // namespace goniolux::pipeline
