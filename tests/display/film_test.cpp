// Film: the grey wedge and colour patches, and the matrices of the recorder.
#include "display/film.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/document.h"
#include "display/display_image.h"
#include "display/picture_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace goniolux::display {
namespace {

// 21 steps of grey in equal steps of density, 0.1 D each, and 24 colours inside the film's gamut, in linear Rec. 709.
std::vector<core::Vec3> wedgeAndPatches() {
  std::vector<core::Vec3> colours;
  for (int i = 0; i <= 20; ++i) colours.emplace_back(0.9 * std::pow(10, -0.1 * i));
  for (int i = 0; i < 24; ++i) {
    const double hue = i * 2 * core::pi / 12, purity = i < 12 ? 0.45 : 0.7;
    const auto channel = [&](double at) { return 0.25 * (1 + purity * std::cos(hue - at)); };
    colours.emplace_back(channel(0), channel(2 * core::pi / 3), channel(4 * core::pi / 3));
  }
  return colours;
}

image::XyzImage chart(const Device& device) {
  image::XyzImage image;
  image.width = 45;
  image.height = 1;
  const core::Mat3 matrix = xyzFromRgb(readDevice("srgb"));
  const core::Mat3 adapt = adaptation({0.3127, 0.3290}, device.white);
  for (const auto& rgb : wedgeAndPatches()) {
    const core::Vec3 xyz = adapt * matrix * rgb * device.white_cd_m2;
    image.x.push_back(static_cast<float>(xyz.x));
    image.y.push_back(static_cast<float>(xyz.y));
    image.z.push_back(static_cast<float>(xyz.z));
  }
  return image;
}

// An independent way to the density that each colour needs: for each layer in turn bisection on its density, over and
// over (the display itself uses Newton's method on dye amounts), with light summed by filmLight.
core::Vec3 predictedCodes(const Film& film, const core::Vec3& light) {
  core::Vec3 codes(0.5);
  for (int sweep = 0; sweep < 40; ++sweep)
    for (int c = 0; c < 3; ++c) {
      double low = 0, high = 1;
      for (int round = 0; round < 22; ++round) {
        codes[c] = 0.5 * (low + high);
        // Red's layer rules X, green's Y, blue's Z.
        const bool tooBright = filmLight(film, codes)[c] > light[c];
        (tooBright != film.reversal ? high : low) = codes[c];
      }
    }
  return codes;
}

TEST(Film, WedgeAndPatchesComeBackWithinFiveThousandthsOfDensity) {
  const test::TemporaryFolder folder;
  for (const char* name : {"film-negative-print", "film-slide"}) {
    const Device device = readDevice(name);
    const Film& film = *device.film;
    const image::XyzImage image = chart(device);
    DisplaySettings settings;
    settings.mapping = mappingNamed("none");
    settings.bits = 10;
    const DisplayedImage shown = displayImage(image, device, settings);
    const std::string path = (folder.path() / "chart.dpx").string();
    writePicture(path, shown.codes, device);
    const CodeImage back = readPicture(path);
    double largest = 0;
    std::size_t compared = 0;
    for (std::size_t i = 0; i < 45; ++i) {
      if (shown.shortfalls[i] != 0) continue;
      const core::Vec3 flare =
          core::Vec3(device.white.x / device.white.y, 1, (1 - device.white.x - device.white.y) / device.white.y) *
          (device.flare_cd_m2 / device.white_cd_m2);
      const core::Vec3 light = core::Vec3(image.x[i], image.y[i], image.z[i]) / device.white_cd_m2 - flare;
      const core::Vec3 predicted = predictedCodes(film, light);
      ++compared;
      for (int c = 0; c < 3; ++c) {
        const double readBack = film.density(back.rgb[3 * i + static_cast<std::size_t>(c)] / film.codeCount());
        const double apart = std::abs(readBack - film.density(predicted[c]));
        largest = std::max(largest, apart);
        EXPECT_LE(apart, 0.005) << name << " patch " << i << " layer " << c;
      }
    }
    EXPECT_GE(compared, 40U) << name << ": the chart must lie inside the film's gamut";
    RecordProperty(std::string(name) + "_largest_density_difference", std::to_string(largest));
    std::printf("%s: %zu of 45 patches inside the gamut, largest difference %.4f D\n", name, compared, largest);
  }
}

// Printing density by the definition that codes rest on: the print's exposure falls by the density's power of ten.
TEST(Film, CodesAreDensitiesOfTwoThousandths) {
  const Device device = readDevice("film-negative-print");
  const Film& film = *device.film;
  EXPECT_NEAR(film.density(95 / 1023.0), 0, 1e-12);
  EXPECT_NEAR(film.density(595 / 1023.0), 1, 1e-12);
  EXPECT_NEAR(film.code(1.18) * 1023, 685, 1e-9);
}

TEST(Film, RecorderExposesEachLayerMostlyByItsOwnColour) {
  const Device device = readDevice("film-negative-print");
  const core::Mat3 crosstalk = recorderCrosstalk(*device.film);
  for (int layer = 0; layer < 3; ++layer) {
    EXPECT_NEAR(crosstalk[0][layer] + crosstalk[1][layer] + crosstalk[2][layer], 1, 1e-12);
    EXPECT_GT(crosstalk[layer][layer], 0.8);
  }
  const core::Vec3 white = recorderDrive(*device.film, core::Vec3(1));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 1e-9) << "white drives all colours alike";
}

// Composite primaries: red, green and blue light, and a white that is the film's.
TEST(Film, CompositePrimariesSpanAGamutAboutTheWhite) {
  for (const char* name : {"film-negative-print", "film-slide"}) {
    const Device device = readDevice(name);
    EXPECT_GT(device.red.x, 0.5) << name;
    EXPECT_GT(device.green.y, 0.38) << name;
    EXPECT_LT(device.blue.x, 0.27) << name;
    const core::Mat3 matrix = xyzFromRgb(device);
    const core::Vec3 white = matrix * core::Vec3(1);
    EXPECT_NEAR(white.y, 1, 1e-9) << name;
    EXPECT_NEAR(white.x / (white.x + white.y + white.z), device.white.x, 1e-9) << name;
  }
}

TEST(Film, FaultsInItsFileAreNamed) {
  const test::TemporaryFolder folder;
  const std::string good = test::contentOf(std::string(GONIOLUX_SOURCE_DIR) + "/data/devices/film-slide.device.json");
  const auto complaint = [&](const std::string& from, const std::string& to) -> std::string {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    try {
      readDevice(folder.write("film.device.json", text).string());
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint("\"bits\"", "\"bits\""), "");
  EXPECT_NE(complaint("\"dyes\"", "\"dies\"").find("did you mean 'dyes'"), std::string::npos);
  EXPECT_NE(complaint("\"curve\": [[", "\"curve\": [[9, 9], [").find("must ascend"), std::string::npos);
  EXPECT_NE(complaint("\"blackbody\": 3200", "\"blackbody\": -1").find("must lie between"), std::string::npos);
  EXPECT_NE(complaint("\"film-recorder\"", "\"film-recoder\"").find("did you mean 'film-recorder'"), std::string::npos);
}

}  // namespace
}  // namespace goniolux::display
