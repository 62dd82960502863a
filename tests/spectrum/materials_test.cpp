// The finishes of materials/: that each file is what its head says, and the table in materials/README.md what the files
// are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/spectrum_files.h"

namespace goniolux::spectrum {
namespace {

const std::filesystem::path folder = std::filesystem::path(GONIOLUX_SOURCE_DIR) / "materials";

std::map<std::string, std::filesystem::path> finishes() {
  std::map<std::string, std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".spd") files[entry.path().filename().string()] = entry.path();
  }
  return files;
}

// Text after "# KEY: " in a file's head; "" when there is none.
std::string headLine(const std::filesystem::path& file, const std::string& key) {
  std::ifstream stream(file);
  const std::string start = "# " + key + ": ";
  for (std::string line; std::getline(stream, line) && !line.empty() && line[0] == '#';) {
    if (line.rfind(start, 0) == 0) return line.substr(start.size());
  }
  return "";
}

// "0.04 + edge(0.81, 402, 6) - band(0.02, 480, 40)" at a wavelength.
double modelAt(const std::string& model, double wavelength) {
  static const std::regex term(R"(([+-]?)\s*(?:(edge|band)\(([\d.]+), ([\d.]+), ([\d.]+)\)|([\d.]+)))");
  double sum = 0;
  for (std::sregex_iterator match(model.begin(), model.end(), term), end; match != end; ++match) {
    const double sign = (*match)[1] == "-" ? -1 : 1;
    if ((*match)[6].matched) {
      sum += sign * std::stod((*match)[6]);
      continue;
    }
    const double height = std::stod((*match)[3]), centre = std::stod((*match)[4]), width = std::stod((*match)[5]);
    const double t = (wavelength - centre) / width;
    sum += sign * height * ((*match)[2] == "edge" ? 1 / (1 + std::exp(-t)) : std::exp(-t * t / 2));
  }
  return sum;
}

TEST(Materials, ThereAreManyAndEachIsAReadableReflectance) {
  const auto files = finishes();
  EXPECT_GE(files.size(), 40U);
  for (const auto& [name, file] : files) {
    core::Diagnostics warnings;
    const auto reflectance = readSpectrumFile(file.string(), Role::reflectance, &warnings);
    EXPECT_GT(reflectance.range().first, 0) << name;
    EXPECT_LT(reflectance.range().second, 0.95) << name << ": no finish is whiter";
    EXPECT_TRUE(warnings.all().empty()) << name;
    EXPECT_NE(headLine(file, "Maker"), "") << name << " does not say where its numbers come from";
  }
}

TEST(Materials, EachIsEitherMeasuredWithSourceAndTermsOrModelledWithItsFormula) {
  int measured = 0;
  for (const auto& [name, file] : finishes()) {
    const bool isMeasured = !headLine(file, "measured").empty();
    EXPECT_NE(isMeasured, !headLine(file, "model").empty()) << name;
    EXPECT_EQ(isMeasured, !headLine(file, "terms").empty()) << name;
    measured += isMeasured ? 1 : 0;
  }
  EXPECT_GE(measured, 15);
}

TEST(Materials, ModelledCurvesAreWhatTheirFormulaSays) {
  for (const auto& [name, file] : finishes()) {
    const std::string model = headLine(file, "model");
    if (model.empty()) continue;
    const auto reflectance = readSpectrumFile(file.string(), Role::reflectance);
    for (const auto& [wavelength, value] : reflectance.samples()) {
      EXPECT_NEAR(value, modelAt(model, wavelength), 5.1e-5) << name << " at " << wavelength << " nm";
    }
  }
}

TEST(Materials, TableOfTheReadmeGivesTheComputedLuminousReflectance) {
  std::ifstream readme(folder / "README.md");
  const std::regex row(R"(\| `([^`]+\.spd)` \|[^|]*\| (0\.\d{3}) \| `(#[0-9a-f]{6})` \|)");
  const auto d65 = illuminant("CIE D65").value();
  auto missing = finishes();
  for (std::string line; std::getline(readme, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    const std::string name = match[1];
    ASSERT_TRUE(missing.contains(name)) << name << " stands in the table but not in the folder, or twice";
    const auto [X, Y, Z] = tristimulus(readSpectrumFile(missing[name].string(), Role::reflectance), d65);
    EXPECT_NEAR(Y, std::stod(match[2]), 6e-4) << name;
    // IEC 61966-2-1; each code within one.
    const double linear[] = {3.2406 * X - 1.5372 * Y - 0.4986 * Z, -0.9689 * X + 1.8758 * Y + 0.0415 * Z,
                             0.0557 * X - 0.2040 * Y + 1.0570 * Z};
    for (std::size_t c = 0; c < 3; ++c) {
      const double code = 255 * (1.055 * std::pow(std::max(linear[c], 0.0031308), 1 / 2.4) - 0.055);
      EXPECT_NEAR(std::stoi(match[3].str().substr(1 + 2 * c, 2), nullptr, 16), code, 1) << name;
    }
    missing.erase(name);
  }
  for (const auto& [name, file] : missing) ADD_FAILURE() << name << " is missing in the table of materials/README.md";
}

}  // namespace
}  // namespace goniolux::spectrum
