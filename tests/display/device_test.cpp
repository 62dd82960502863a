#include "display/device.h"

#include <gtest/gtest.h>

#include <string>

#include "core/diagnostics.h"
#include "support/temporary_folder.h"

namespace goniolux::display {
namespace {

std::string complaint(const std::string& text) {
  const test::TemporaryFolder folder;
  try {
    readDevice(folder.write("my.device.json", text).string());
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

::testing::AssertionResult says(const std::string& complaint, const std::string& part) {
  if (complaint.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << part << "' is not in:\n" << complaint;
}

TEST(Device, EveryPresetIsReadAndItsCurveClosesUp) {
  const auto names = presetNames();
  EXPECT_GE(names.size(), 4U);
  for (const auto& name : names) {
    const Device device = readDevice(name);
    EXPECT_FALSE(device.name.empty()) << name;
    EXPECT_FALSE(device.source.empty()) << name;
    EXPECT_NEAR(device.transfer.encode(1), 1, 1e-12) << name;
    EXPECT_NEAR(device.transfer.encode(0), 0, 1e-12) << name;
    for (double linear = 0; linear <= 1; linear += 1.0 / 1024) {
      EXPECT_NEAR(device.transfer.decode(device.transfer.encode(linear)), linear, 1e-4) << name << " " << linear;
    }
  }
}

TEST(Device, SrgbMatrixIsThatOfTheStandard) {
  const auto matrix = xyzFromRgb(readDevice("sRGB"));  // IEC 61966-2-1, four decimals; columns are the primaries
  const double expected[3][3] = {{0.4124, 0.2126, 0.0193}, {0.3576, 0.7152, 0.1192}, {0.1805, 0.0722, 0.9505}};
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) EXPECT_NEAR(matrix[column][row], expected[column][row], 6e-5);
  }
}

TEST(Device, AdaptationTurnsOneWhiteIntoTheOther) {
  const spectrum::Chromaticity a{0.4476, 0.4074}, d65{0.3127, 0.3290};
  const auto white = adaptation(a, d65) * core::Vec3(a.x / a.y, 1, (1 - a.x - a.y) / a.y);
  EXPECT_NEAR(white.x, d65.x / d65.y, 1e-9);
  EXPECT_NEAR(white.y, 1, 1e-9);
  EXPECT_NEAR(white.z, (1 - d65.x - d65.y) / d65.y, 1e-9);
  const auto nothing = adaptation(a, a);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) EXPECT_NEAR(nothing[column][row], column == row ? 1 : 0, 1e-12);
  }
}

constexpr const char* good = R"({
  "format": "goniolux-device", "version": 1, "name": "mine",
  "primaries": { "red": [0.64, 0.33], "green": [0.30, 0.60], "blue": [0.15, 0.06] },
  "white": [0.3127, 0.3290],
  "transfer": { "gamma": 2.2 }
})";

std::string with(const std::string& from, const std::string& to) {
  std::string text = good;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST(Device, OwnFilesAreReadAndFaultsAreNamedWithTheirPlace) {
  EXPECT_EQ(complaint(good), "");
  EXPECT_TRUE(says(complaint(with("\"gamma\"", "\"gama\"")),
                   "my.device.json:5:17: error: unknown key \"gama\"; did you mean 'gamma'?"));
  EXPECT_TRUE(says(complaint(with("2.2", "-1")), "\"gamma\" must lie between"));
  EXPECT_TRUE(says(complaint(with("[0.30, 0.60]", "[0.30]")), "my.device.json:3:48"));
  EXPECT_TRUE(says(complaint(with("[0.15, 0.06]", "[0.47, 0.465]")), "lie on one line"));
  EXPECT_TRUE(says(complaint(with("0.3127, 0.3290", "0.7, 0.2")), "outside the triangle"));
  EXPECT_TRUE(says(complaint(with("goniolux-device", "other")), "no device file"));
  EXPECT_TRUE(says(complaint(with("\"version\": 1", "\"version\": 2")), "\"version\" must be 1"));
  EXPECT_TRUE(
      says(complaint(with("\"gamma\": 2.2", "\"gamma\": 2.4, \"slope\": 5, \"threshold\": 0.1")), "straight part"));
  EXPECT_TRUE(says(complaint("{"), "my.device.json"));
  EXPECT_TRUE(says(complaint("[1]"), "one object"));
}

TEST(Device, UnknownPresetIsRefusedWithTheKnownNames) {
  try {
    readDevice("srg");
    FAIL() << "expected an InputError";
  } catch (const core::InputError& error) {
    EXPECT_TRUE(says(error.what(), "did you mean 'srgb'?"));
  }
  EXPECT_THROW(readDevice("absent/file.device.json"), core::InputError);
}

}  // namespace
}  // namespace goniolux::display
