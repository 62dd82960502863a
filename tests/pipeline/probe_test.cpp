#include <gtest/gtest.h>

#include <filesystem>

#include "display/picture_file.h"
#include "image/exr.h"
#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

std::string imageFile(const test::TemporaryFolder& folder, const char* name, float luminance) {
  image::XyzImage image;
  image.width = 20;
  image.height = 10;
  image.x.assign(200, luminance * 0.9505F);
  image.y.assign(200, luminance);
  image.z.assign(200, luminance * 1.089F);
  image.halfWidth.assign(200, 1);
  const std::string path = (folder.path() / name).string();
  image::writeExr(path, image);
  return path;
}

StageReport called(Stage (*stage)(), std::vector<std::string> inputs, std::map<std::string, std::string> options = {},
                   std::optional<std::string> output = {}) {
  StageRequest request;
  request.inputs = std::move(inputs);
  request.options = std::move(options);
  request.common.output = std::move(output);
  core::SilentProgress progress;
  return stage().run(request, progress);
}

TEST(ProbeStage, ReadsLuminanceAndColourWithHalfWidths) {
  const test::TemporaryFolder folder;
  const std::string image = imageFile(folder, "a.exr", 100);
  const auto report = called(probeStage, {image, "5,5", "3,3,2"});
  const auto& json = report.json;
  EXPECT_NEAR(json.find("luminance_cd_m2")->find("value")->number(), 100, 1e-9);
  EXPECT_NEAR(json.find("luminance_cd_m2")->find("half_width")->number(), 1, 1e-9);
  EXPECT_NEAR(json.find("x")->find("value")->number(), 0.3127, 1e-4);
  EXPECT_NEAR(json.find("cct_k")->find("value")->number(), 6504, 10);
  EXPECT_EQ(json.find("points")->array().size(), 2U);
  EXPECT_NE(report.text.find("100 ± 1 cd/m2"), std::string::npos) << report.text;
}

TEST(ProbeStage, NonsenseIsRefused) {
  const test::TemporaryFolder folder;
  const std::string image = imageFile(folder, "a.exr", 100);
  for (const char* place : {"", "5", "5,x", "5,5,-1", "20,5", "-1,0", "1,2,3,4"})
    EXPECT_THROW(called(probeStage, {image, place}), core::InputError) << place;
  EXPECT_THROW(called(probeStage, {image}), core::InputError);
  EXPECT_THROW(called(probeStage, {"absent.exr", "1,1"}), core::InputError);
}

TEST(CompareStage, GivesDifferencesAndTheirImage) {
  const test::TemporaryFolder folder;
  const std::string a = imageFile(folder, "a.exr", 100), b = imageFile(folder, "b.exr", 101);
  const std::string difference = (folder.path() / "d.exr").string();
  const auto report = called(compareStage, {a, b}, {{"white", "200"}}, difference);
  EXPECT_NEAR(report.json.find("luminance_rmse")->number(), 1, 1e-5);
  EXPECT_NEAR(report.json.find("within_half_widths")->number(), 1, 1e-9);
  const auto* delta = report.json.find("delta_e00");
  EXPECT_GT(delta->find("mean")->number(), 0.1);
  EXPECT_LT(delta->find("max")->number(), 0.5);
  EXPECT_NEAR(image::readExr(difference).y[7], 1, 1e-5);
}

TEST(CompareStage, DrawsAMapOfColourDifferences) {
  const test::TemporaryFolder folder;
  const std::string a = imageFile(folder, "a.exr", 100), b = imageFile(folder, "b.exr", 120);
  const std::string map = (folder.path() / "map.png").string();
  const auto report = called(compareStage, {a, b}, {{"map", map}});
  EXPECT_EQ(report.files, std::vector<std::string>{map});
  const display::CodeImage picture = display::readPicture(map);
  EXPECT_GT(picture.width, image::readExr(a).width) << "the scale stands beside it";
  EXPECT_EQ(picture.rgb[0], picture.rgb[3]) << "one difference everywhere, one colour";
  EXPECT_THROW(called(compareStage, {a, b}, {{"map", "map.gif"}}), core::InputError);
}

TEST(CompareStage, ImagesOfDifferentSizeAreRefused) {
  const test::TemporaryFolder folder;
  const std::string a = imageFile(folder, "a.exr", 100), b = (folder.path() / "b.exr").string();
  image::XyzImage small;
  small.width = small.height = 1;
  small.x = small.y = small.z = {1};
  image::writeExr(b, small);
  EXPECT_THROW(called(compareStage, {a, b}), core::InputError);
  EXPECT_THROW(called(compareStage, {a}), core::InputError);
  EXPECT_THROW(called(compareStage, {a, a}, {{"white", "0"}}), core::InputError);
  EXPECT_THROW(called(compareStage, {a, a}, {}, "difference.png"), core::InputError);
}

}  // namespace
}  // namespace goniolux::pipeline
