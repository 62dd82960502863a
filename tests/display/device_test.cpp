#include "display/device.h"

#include <gtest/gtest.h>

#include <string>

#include "core/diagnostics.h"
#include "display/adaptation.h"
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
  EXPECT_GE(names.size(), 8U);
  for (const auto& name : names) {
    const Device device = readDevice(name);
    EXPECT_FALSE(device.name.empty()) << name;
    EXPECT_FALSE(device.source.empty()) << name;
    if (device.kind != Device::Kind::monitor) continue;
    for (const TransferCurve& curve : device.transfer) {
      // PQ: 1000 cd/m2 have the code 0.7518 (ITU-R BT.2100).
      EXPECT_NEAR(curve.encode(1), curve.form == TransferCurve::Form::pq ? 0.7518 : 1, 1e-4) << name;
      EXPECT_NEAR(curve.encode(0), 0, 1e-5) << name;
      for (double linear = 0; linear <= 1; linear += 1.0 / 1024)
        EXPECT_NEAR(curve.decode(curve.encode(linear)), linear, 1e-4) << name << " " << linear;
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

TEST(Device, EveryAdaptationTurnsOneWhiteIntoTheOtherAndTheyAgreeOnModerateColours) {
  const spectrum::Chromaticity a{0.4476, 0.4074}, d65{0.3127, 0.3290};
  for (const std::string& name : adaptationNames()) {
    const auto matrix = adaptation(a, d65, adaptationNamed(name));
    const auto white = matrix * core::Vec3(a.x / a.y, 1, (1 - a.x - a.y) / a.y);
    EXPECT_NEAR(white.x, d65.x / d65.y, 1e-9) << name;
    EXPECT_NEAR(white.z, (1 - d65.x - d65.y) / d65.y, 1e-9) << name;
    const auto skin = matrix * core::Vec3(0.5, 0.4, 0.1);
    EXPECT_NEAR(skin.x, 0.42, 0.03) << name;
    EXPECT_NEAR(skin.y, 0.39, 0.02) << name;
  }
  EXPECT_THROW(adaptationNamed("cat99"), core::InputError);
}

TEST(Device, CurvesPerChannelTablesAndBlackAreRead) {
  const test::TemporaryFolder folder;
  const Device device = readDevice(folder
                                       .write("own.device.json", R"({
  "format": "goniolux-device", "version": 1, "name": "mine", "white_cd_m2": 200, "black_cd_m2": 0.5, "flare_cd_m2": 1.5,
  "primaries": { "red": [0.64, 0.33], "green": [0.30, 0.60], "blue": [0.15, 0.06] },
  "white": [0.3127, 0.3290],
  "transfer": { "red": { "gamma": 2.2 }, "green": { "gamma": 2.4 }, "blue": { "table": [0, 0.1, 0.4, 1] } }
})")
                                       .string());
  EXPECT_EQ(device.transfer[1].gamma, 2.4);
  EXPECT_NEAR(device.transfer[2].decode(0.5), 0.25, 1e-12);  // halfway between the 2nd and the 3rd value
  EXPECT_NEAR(device.transfer[2].encode(0.25), 0.5, 1e-12);
  EXPECT_NEAR(darkest(device), 0.01, 1e-12);
}

TEST(Device, BlackWithoutWhiteIsRefused) {
  EXPECT_TRUE(says(complaint(R"({ "format": "goniolux-device", "version": 1, "black_cd_m2": 1,
  "primaries": { "red": [0.64, 0.33], "green": [0.30, 0.60], "blue": [0.15, 0.06] },
  "white": [0.3127, 0.3290], "transfer": { "gamma": 2.2 } })"),
                   "need \"white_cd_m2\""));
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
