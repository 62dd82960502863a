// `luminaire convert` and `luminaire compare`: what they write and what they say.
#include <gtest/gtest.h>

#include "photometry/photometric_file.h"
#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

const std::string luminaires = std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/";

StageReport runOn(const std::vector<std::string>& inputs, const std::map<std::string, std::string>& options = {}) {
  StageRequest request;
  request.inputs = inputs;
  request.options = options;
  core::SilentProgress silent;
  return luminaireStage().run(request, silent);
}

TEST(LuminaireConvert, WritesAFileOfTheSameIntensitiesAndComparesAsTheTurnedOne) {
  const test::TemporaryFolder folder;
  const std::string in = luminaires + "street.ldt", out = (folder.path() / "turned.ies").string();
  const StageReport written = runOn({"convert", in, out}, {{"turn", "90"}});
  EXPECT_EQ(written.json.find("largest_change")->number(), 0);
  EXPECT_EQ(written.json.find("format")->string(), "LM-63-2019");
  const photometry::PhotometricFile a = photometry::readPhotometricFile(in), b = photometry::readPhotometricFile(out);
  EXPECT_DOUBLE_EQ(b.distribution->atAngles(90 + 12, 62.5), a.distribution->atAngles(12, 62.5));
  // Its length lay along C90 and lies along C180 now.
  EXPECT_DOUBLE_EQ(b.opening.lengthAlongC90 ? b.opening.width : b.opening.length, a.opening.length);
  const StageReport compared = runOn({"compare", in, out});
  EXPECT_EQ(compared.json.find("nearest_turn_deg")->number(), 270);
  EXPECT_NEAR(compared.json.find("flux_ratio")->number(), 1, 1e-12);
  EXPECT_NE(compared.text.find("--turn 270"), std::string::npos);
}

TEST(LuminaireConvert, RefusesWhatItCannotWriteAndWritesNothing) {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out.ldt").string();
  EXPECT_THROW(runOn({"convert", luminaires + "floodlight-b.ies", out}), core::InputError);  // EULUMDAT has no type B
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_THROW(runOn({"convert", luminaires + "street.ldt", (folder.path() / "out.txt").string()}), core::InputError);
  EXPECT_THROW(runOn({"convert", luminaires + "street.ldt"}), core::InputError);
}

TEST(LuminaireSheet, TheFullOneHasTablesAndDiagrams) {
  const StageReport report = runOn({luminaires + "wall-washer.ies"}, {{"sheet", "full"}});
  const core::Value& entry = report.json.array().front();
  EXPECT_EQ(entry.find("utilisation")->find("room_index")->find("factors")->array().size(), 10u);
  EXPECT_EQ(entry.find("utilisation")->find("zonal_cavity")->find("factors")->array().size(), 11u);
  EXPECT_EQ(entry.find("ugr")->find("crosswise")->array().size(), 19u);
  EXPECT_GT(entry.find("diagrams")->find("one")->find("misplaced_share")->number(), 0.2);
  EXPECT_NE(entry.find("spacing_criterion")->find("c0_180"), nullptr);
  EXPECT_NE(report.text.find("coefficients of utilisation"), std::string::npos);
  EXPECT_THROW(runOn({luminaires + "street.ldt"}, {{"sheet", "long"}}), core::InputError);
  EXPECT_THROW(runOn({luminaires + "street.ldt"}, {{"mode", "loose"}}), core::InputError);
}

}  // namespace
}  // namespace goniolux::pipeline
