#include "display/icc_device.h"

#include <gtest/gtest.h>
#include <lcms2.h>

#include <random>

#include "core/diagnostics.h"
#include "display/display_image.h"
#include "display/icc_profile.h"
#include "spectrum/colour_difference.h"
#include "support/temporary_folder.h"

namespace goniolux::display {
namespace {

// A profile that Little CMS makes itself, not this program.
std::string littleCmsSrgb() {
  const cmsHPROFILE profile = cmsCreate_sRGBProfile();
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  return bytes;
}

// The same picture through the profile and through primaries and curve: dE00 below 0.5 everywhere.
TEST(IccDevice, ProfileAndMatrixAgreeForSrgb) {
  const test::TemporaryFolder folder;
  const Device icc = readDevice(folder.write("srgb.icc", littleCmsSrgb()).string()), matrix = readDevice("srgb");
  ASSERT_EQ(icc.kind, Device::Kind::icc);
  image::XyzImage image;
  image.width = 1000;
  image.height = 1;
  std::mt19937 random(5);
  const core::Mat3 toXyz = xyzFromRgb(matrix);
  for (int i = 0; i < 1000; ++i) {
    const auto next = [&] { return matrix.transfer[0].decode(static_cast<double>(random() % 1001) / 1000); };
    const double r = next(), g = next(), b = next();
    const core::Vec3 xyz = toXyz * core::Vec3(r, g, b) * 100.0;
    image.x.push_back(static_cast<float>(xyz.x));
    image.y.push_back(static_cast<float>(xyz.y));
    image.z.push_back(static_cast<float>(xyz.z));
  }
  DisplaySettings settings;
  settings.mapping = mappingNamed("linear:white=100");
  settings.adoptedWhite = spectrum::Chromaticity{0.3127, 0.3290};
  settings.adaptation = Adaptation::bradford;  // as ICC profiles are made
  settings.bits = 16;
  const CodeImage a = displayImage(image, matrix, settings).codes, b = displayImage(image, icc, settings).codes;
  double largest = 0;
  const spectrum::Xyz white{0.9505, 1, 1.089};
  for (std::size_t i = 0; i < 1000; ++i) {
    const auto lab = [&](const CodeImage& codes) {
      core::Vec3 linear;
      for (int c = 0; c < 3; ++c)
        linear[c] = matrix.transfer[0].decode(codes.rgb[3 * i + static_cast<std::size_t>(c)] / 65535.0);
      const core::Vec3 xyz = toXyz * linear;
      return spectrum::lab({xyz.x, xyz.y, xyz.z}, white);
    };
    largest = std::max(largest, spectrum::deltaE2000(lab(a), lab(b)));
  }
  EXPECT_LT(largest, 0.5);
  std::printf("ICC path against matrix path: largest dE00 %.3f\n", largest);
}

TEST(IccDevice, OwnProfilesComeBackWithTheirNameAndLuminance) {
  const test::TemporaryFolder folder;
  const Device device = readDevice(folder.write("own.icc", iccProfile(readDevice("rec709"))).string());
  EXPECT_EQ(device.name, "Rec. 709");
  EXPECT_NEAR(device.white_cd_m2, 100, 0.01);
  EXPECT_EQ(iccProfile(device), iccProfile(readDevice("rec709"))) << "embedded as it came";
}

TEST(IccDevice, ColoursOutsideAreReported) {
  const test::TemporaryFolder folder;
  const Device icc = readDevice(folder.write("srgb.icc", littleCmsSrgb()).string());
  image::XyzImage image;  // grey, 520 nm, twice as bright as white
  image.width = 3;
  image.height = 1;
  image.x = {48, 9, 193};
  image.y = {50, 100, 200};
  image.z = {41, 11, 165};
  DisplaySettings settings;
  settings.mapping = mappingNamed("linear:white=100");
  const DisplayedImage shown = displayImage(image, icc, settings);
  EXPECT_EQ(shown.shortfalls[0], 0);
  EXPECT_EQ(shown.shortfalls[1], outOfGamut);
  EXPECT_EQ(shown.shortfalls[2], tooBright);
}

TEST(IccDevice, DamagedAndOtherProfilesAreRefused) {
  const std::string whole = littleCmsSrgb();
  const auto refused = [](const std::string& bytes) {
    try {
      (void)iccDevice(bytes, "a.icc");
      return false;
    } catch (const core::InputError&) {
      return true;
    }
  };
  EXPECT_FALSE(refused(whole));
  int count = 0;
  for (std::size_t size = 0; size < whole.size(); size += 31) count += refused(whole.substr(0, size));
  EXPECT_GT(count, static_cast<int>(whole.size() / 31 / 2));
  const cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(lab, nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(lab, bytes.data(), &size);
  cmsCloseProfile(lab);
  EXPECT_TRUE(refused(bytes));
}

}  // namespace
}  // namespace goniolux::display
