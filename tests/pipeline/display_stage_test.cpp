#include <gtest/gtest.h>

#include <filesystem>
#include <string>

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
  const std::map<std::string, std::string> wrong[] = {
      {{"device", "no-such-device"}},        {{"exposure", "bright"}}, {{"white", "-1"}},
      {{"white", "100"}, {"exposure", "9"}}, {{"adapt", "0.9,0.9"}},   {{"bits", "12"}}};
  for (const auto& options : wrong) {
    EXPECT_THROW(runDisplay(image, earlier, options), core::InputError) << options.begin()->first;
  }
  EXPECT_THROW(runDisplay(folder.write("damaged.exr", "no image"), earlier), core::InputError);
  EXPECT_THROW(runDisplay(folder.path() / "absent.exr", earlier), core::InputError);
  EXPECT_THROW(runDisplay(image, image), core::InputError) << "the image must not become the picture";
  EXPECT_THROW(runDisplay(image, folder.path() / "view.dpx"), core::InputError);
  EXPECT_EQ(test::contentOf(earlier), "earlier");
}

TEST(DisplayStage, TiffHasSixteenBits) {
  const test::TemporaryFolder folder;
  writeTestImage(folder.path() / "view.exr");
  const auto report = runDisplay(folder.path() / "view.exr", folder.path() / "view.tif");
  EXPECT_EQ(report.json.find("bits")->number(), 16);
}

}  // namespace
}  // namespace goniolux::pipeline
