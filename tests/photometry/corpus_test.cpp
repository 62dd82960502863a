// Every photometric file of the shared corpus, against the fluxes of an independent reader (reference.tsv).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "core/document.h"
#include "photometry/flux_check.h"
#include "photometry/photometric_file.h"
#include "photometry/sphere_quadrature.h"
#include "support/shared_folder.h"

namespace goniolux::photometry {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
  return fields;
}

std::vector<Row> referenceRows(const std::filesystem::path& folder) {
  std::ifstream file(folder / "reference.tsv");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = split(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = split(line);
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = i < fields.size() ? fields[i] : "";
    rows.push_back(row);
  }
  return rows;
}

class Corpus : public testing::Test {
 protected:
  void SetUp() override {
    const auto shared = test::sharedFolder();
    if (!shared) GTEST_SKIP() << test::sharedFolderIsAbsent;
    folder_ = *shared / "corpus" / "photometry";
    rows_ = referenceRows(folder_);
    ASSERT_GT(rows_.size(), 300u);
  }
  [[nodiscard]] PhotometricFile read(const Row& row) const {
    return readPhotometricFile((folder_ / row.at("file")).string());
  }

  std::filesystem::path folder_;
  std::vector<Row> rows_;
};

double relative(double a, double b) {
  return std::abs(a - b) / std::max(std::abs(b), 1e-300);
}

// The reference prints seven digits.
TEST_F(Corpus, EveryReadableFileIsReadWithTheReferenceFluxAndPeak) {
  int files = 0, fluxes = 0;
  double worstExact = 0, worstZonal = 0;
  for (const Row& row : rows_) {
    if (row.at("readable") != "1") continue;
    ++files;
    SCOPED_TRACE(row.at("file"));
    PhotometricFile file;
    ASSERT_NO_THROW(file = read(row));
    const TabulatedDistribution& d = *file.distribution;
    if (row.at("flux_exact_lm").empty()) continue;  // a type B file whose H begins at 1: the reference gives no flux
    ++fluxes;
    const double exact = relative(d.flux(), std::stod(row.at("flux_exact_lm")));
    EXPECT_LT(exact, 1e-4) << d.flux();
    worstExact = std::max(worstExact, exact);
    const double zonal = relative(zonalConstantFlux(d), std::stod(row.at("flux_zonal_lm")));
    EXPECT_LT(zonal, 1e-4) << zonalConstantFlux(d);
    worstZonal = std::max(worstZonal, zonal);
    EXPECT_LT(relative(d.maximumIntensity(), std::stod(row.at("peak_cd"))), 1e-6) << d.maximumIntensity();
    EXPECT_EQ(d.verticalAngles().size(), std::stoul(row.at("angles_per_plane")));
    EXPECT_EQ(d.horizontalAngles().size(), std::stoul(row.at("planes")));
  }
  EXPECT_GE(files, 255);
  RecordProperty("files", files);
  std::cout << files << " files read, " << fluxes << " fluxes; worst disagreement exact " << worstExact << ", zonal "
            << worstZonal << "\n";
}

// Quadrature over directions with 0.5 x 1 degree panels; tables with narrower features are what 2e-3 is for.
TEST_F(Corpus, FluxesOfASampleAreConfirmedByIndependentIntegration) {
  int readable = 0, checked = 0;
  for (const Row& row : rows_) {
    if (row.at("readable") != "1" || ++readable % 10 != 0) continue;
    const PhotometricFile file = read(row);
    const double flux = file.distribution->flux();
    EXPECT_NEAR(test::quadratureFlux(*file.distribution), flux, 2e-3 * flux) << row.at("file");
    ++checked;
  }
  EXPECT_GE(checked, 25);
}

TEST_F(Corpus, EveryUnreadableFileIsRefusedAtALine) {
  int files = 0;
  for (const Row& row : rows_) {
    if (row.at("readable") == "1" || row.at("kind") == "tm33-xml") continue;
    ++files;
    SCOPED_TRACE(row.at("file"));
    try {
      (void)read(row);
      ADD_FAILURE() << "was read, although: " << row.at("refused_because");
    } catch (const core::InputError& error) {
      const core::Diagnostic& first = error.diagnostics().all().front();
      EXPECT_GT(first.position.line, 0) << error.what();
      EXPECT_FALSE(first.rule.empty());
      if (row.at("kind") == "gldf") {
        EXPECT_NE(first.message.find("GLDF"), std::string::npos) << error.what();
      }
    }
  }
  EXPECT_GE(files, 70);
}

// Files that state lumens: how the table agrees, file by file. A luminaire's own flux is held to 2 %, lamp lumens to
// what a luminaire can make of them (20 to 102 %); a file that leaves that has the warning, and no other has.
TEST_F(Corpus, EveryFileThatStatesLumensSaysHowItsTableAgrees) {
  int ofLuminaire = 0, agreeing = 0, ofLamps = 0, possible = 0;
  for (const Row& row : rows_) {
    if (row.at("readable") != "1" || row.at("kind") == "tm33-xml") continue;
    SCOPED_TRACE(row.at("file"));
    const PhotometricFile file = read(row);
    const double flux = file.distribution->flux();
    bool expected = false;
    std::string said;
    if (file.declaredLuminaireLumens) {
      const double ratio = flux / *file.declaredLuminaireLumens;
      ++ofLuminaire;
      const bool apart = std::abs(ratio - 1) > 0.02 * std::max(ratio, 1.0);
      agreeing += !apart;
      expected = expected || apart;
      said += fmt::format(" {:.2f} % of the luminaire's {:g} {}", 100 * ratio, *file.declaredLuminaireLumens,
                          file.fluxUnit);
    }
    if (file.declaredLumens) {
      const double ratio = flux / *file.declaredLumens;
      ++ofLamps;
      possible += ratio >= 0.2 && ratio <= 1.02;
      expected = expected || ratio < 0.2 || ratio > 1.02;
      said += fmt::format(" {:.1f} % of the lamps' {:g} {}", 100 * ratio, *file.declaredLumens, file.fluxUnit);
    }
    if (said.empty()) continue;
    std::cout << row.at("file") << ":" << said << "\n";
    const auto& all = file.warnings.all();
    EXPECT_EQ(std::any_of(all.begin(), all.end(),
                          [](const auto& d) {
                            return d.rule == "flux-declared" || d.rule == "flux-above-lamps" ||
                                   d.rule == "flux-below-lamps";
                          }),
              expected && flux > 0)
        << said;
  }
  std::cout << agreeing << " of " << ofLuminaire
            << " files agree with the luminaire's flux that they state within 2 %; " << possible << " of " << ofLamps
            << " give between 20 and 102 % of their lamps' flux\n";
  EXPECT_GT(ofLuminaire, 50);
  EXPECT_GT(ofLamps, 100);
}

// The reference has no fluxes for TM-33: each is confirmed by quadrature, and stands beside what the file declares.
// Most of these files are made up and carry a round number of lumens; the warning says so.
TEST_F(Corpus, EveryTm33FileIsReadAndStandsBesideItsDeclaredFlux) {
  int files = 0, declared = 0, agreeing = 0;
  for (const Row& row : rows_) {
    if (row.at("kind") != "tm33-xml") continue;
    ++files;
    SCOPED_TRACE(row.at("file"));
    PhotometricFile file;
    ASSERT_NO_THROW(file = read(row));
    const double flux = file.distribution->flux();
    EXPECT_NEAR(test::quadratureFlux(*file.distribution), flux, 2e-3 * flux);
    const auto stated = file.declaredLuminaireLumens ? file.declaredLuminaireLumens : file.declaredLumens;
    if (!stated) continue;
    ++declared;
    const bool agrees = std::abs(flux / *stated - 1) <= 0.02;
    agreeing += agrees;
    const bool possible =
        file.declaredLumens && flux <= 1.02 * *file.declaredLumens && flux >= 0.2 * *file.declaredLumens;
    std::cout << row.at("file") << ": " << flux << " of " << *stated << " declared " << file.fluxUnit << "\n";
    const auto& all = file.warnings.all();
    const bool warned = std::any_of(all.begin(), all.end(), [](const auto& d) {
      return d.rule == "flux-declared" || d.rule == "flux-above-lamps" || d.rule == "flux-below-lamps";
    });
    EXPECT_EQ(warned, !(agrees || (possible && !file.declaredLuminaireLumens))) << flux << " of " << *stated;
  }
  EXPECT_EQ(files, 32);
  std::cout << agreeing << " of " << declared << " agree with their declared flux within 2 %\n";
}

}  // namespace
}  // namespace goniolux::photometry
