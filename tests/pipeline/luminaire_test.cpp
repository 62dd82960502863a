// The luminaire stage: its document as the interface promises it, and what happens to files that cannot be read.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

using core::Value;

const std::string luminaires = std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/";

StageReport runOn(const std::vector<std::string>& files) {
  StageRequest request;
  request.inputs = files;
  core::SilentProgress silent;
  return luminaireStage().run(request, silent);
}

TEST(LuminaireStage, DocumentHasEveryPromisedMember) {
  const StageReport report = runOn({luminaires + "panel-600.ies"});
  EXPECT_FALSE(report.inputFailed);
  ASSERT_TRUE(report.json.isArray());
  ASSERT_EQ(report.json.array().size(), 1u);
  const Value& entry = report.json.array()[0];
  for (const char* key :
       {"file", "format", "photometric_type", "symmetry", "c_planes", "gamma_angles", "declared_lumens",
        "integrated_lumens", "downward_fraction", "max_intensity_cd", "max_direction", "zonal_lumens", "beam_angle_deg",
        "field_angle_deg", "input_watts", "efficacy_lm_w", "opening", "cie_flux_code", "warnings"}) {
    EXPECT_NE(entry.find(key), nullptr) << key;
  }
}

TEST(LuminaireStage, ALambertianPanelGivesTheNumbersOfTheClosedForm) {
  const StageReport report = runOn({luminaires + "panel-600.ies"});
  const Value& panel = report.json.array()[0];
  EXPECT_EQ(panel.find("format")->string(), "LM-63-2002");
  EXPECT_EQ(panel.find("symmetry")->string(), "rotational");
  EXPECT_NEAR(panel.find("integrated_lumens")->number(), 3600, 0.02);
  EXPECT_NEAR(panel.find("max_intensity_cd")->number(), 3600 / 3.14159265,
              1);  // the interpolant of 2.5 degree steps lies below the cosine
  EXPECT_EQ(panel.find("downward_fraction")->number(), 1);
  EXPECT_NEAR(panel.find("efficacy_lm_w")->number(), 120, 0.01);
  EXPECT_NEAR(panel.find("beam_angle_deg")->find("c0_180")->number(), 120, 0.1);
  EXPECT_NEAR(panel.find("field_angle_deg")->find("c90_270")->number(), 2 * std::acos(0.1) * 180 / 3.14159265, 0.1);
  const std::vector<double> code{44, 75, 94, 100, 100};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(panel.find("cie_flux_code")->array()[i].number(), code[i]);
  EXPECT_EQ(panel.find("zonal_lumens")->array().size(), 18u);
  EXPECT_EQ(panel.find("opening")->find("shape")->string(), "rectangle");
  EXPECT_DOUBLE_EQ(panel.find("opening")->find("length_m")->number(), 0.6);
}

TEST(LuminaireStage, AFileThatCannotBeReadDoesNotStopTheOthers) {
  const test::TemporaryFolder folder;
  const std::string broken = (folder.path() / "broken.ies").string();
  std::ofstream(broken) << "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 one\n";
  const StageReport report = runOn({broken, luminaires + "street.ldt", luminaires + "absent.ies"});
  EXPECT_TRUE(report.inputFailed);
  ASSERT_EQ(report.json.array().size(), 3u);
  const Value* error = report.json.array()[0].find("error");
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->find("line")->number(), 3);
  EXPECT_EQ(error->find("column")->number(), 12);
  EXPECT_NE(error->find("message")->string().find("'one'"), std::string::npos);
  EXPECT_EQ(report.json.array()[0].find("file")->string(), broken);
  EXPECT_EQ(report.json.array()[1].find("error"), nullptr);
  EXPECT_NE(report.json.array()[2].find("error"), nullptr);
  EXPECT_TRUE(report.warnings.hasErrors());
  EXPECT_NE(report.text.find("Street luminaire"), std::string::npos);
}

TEST(LuminaireStage, TheSheetNamesTheThreeFluxesAndTheRules) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "odd.ies").string();
  std::ofstream(path)
      << "IESNA95\n[LUMINAIRE] odd one\nTILT=NONE\n2 500 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n1000 700 0\n";
  const StageReport report = runOn({path});
  for (const char* words :
       {"exact", "zonal constant", "lamps", "odd-format-line", "flux-above-lamps", "light output ratio", "odd one"}) {
    EXPECT_NE(report.text.find(words), std::string::npos) << words << "\n" << report.text;
  }
  const Value& odd = report.json.array()[0];
  EXPECT_EQ(odd.find("declared_lumens")->number(), 1000);
  EXPECT_EQ(odd.find("warnings")->array()[0].find("line")->number(), 1);
  EXPECT_EQ(odd.find("warnings")->array()[0].find("rule")->string(), "odd-format-line");
}

TEST(LuminaireStage, IsAVerb) {
  const auto& list = stages();
  EXPECT_TRUE(
      std::any_of(list.begin(), list.end(), [](const Stage& s) { return s.name == "luminaire" && s.manyInputs; }));
}

}  // namespace
}  // namespace goniolux::pipeline
