#include <gtest/gtest.h>

#include <string>

#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

StageReport runSpectrum(const std::vector<std::string>& inputs) {
  StageRequest request;
  request.inputs = inputs;
  core::SilentProgress progress;
  return spectrumStage().run(request, progress);
}

TEST(SpectrumStage, BuiltInIlluminantsAndFilesGiveTheirColour) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("equal.csv", "360,1\n830,1\n").string();
  const auto report = runSpectrum({"CIE FL11", file});
  ASSERT_EQ(report.json.array().size(), 2U);
  const auto& fl11 = report.json.array()[0];
  EXPECT_NEAR(fl11.find("x")->number(), 0.38054, 5e-5);
  EXPECT_NEAR(fl11.find("y")->number(), 0.37692, 5e-5);
  EXPECT_NEAR(fl11.find("cct_k")->number(), 3999, 1);
  EXPECT_NEAR(fl11.find("ra")->number(), 82.8, 0.1);
  EXPECT_NEAR(fl11.find("r9")->number(), 25, 0.6);
  EXPECT_NEAR(fl11.find("melanopic_der")->number(), 0.5636, 5e-4);
  EXPECT_NEAR(report.json.array()[1].find("x")->number(), 1.0 / 3, 5e-5);
  EXPECT_NEAR(report.json.array()[1].find("melanopic_der")->number(), 0.9058, 5e-4);
  EXPECT_FALSE(report.inputFailed);
  EXPECT_NE(report.text.find("CCT 3999 K"), std::string::npos) << report.text;
}

TEST(SpectrumStage, UnreadableFilesAreReportedAndTheOthersDone) {
  const test::TemporaryFolder folder;
  const auto bad = folder.write("bad.csv", "400,1\n500,x\n").string();
  const auto report = runSpectrum({bad, "CIE D65"});
  EXPECT_TRUE(report.inputFailed);
  EXPECT_EQ(report.json.array()[0].find("error")->find("line")->number(), 2);
  EXPECT_NEAR(report.json.array()[1].find("melanopic_der")->number(), 1, 5e-4);
}

TEST(SpectrumStage, FarFromThePlanckianLocusThereIsNoTemperature) {
  const test::TemporaryFolder folder;
  const auto green = folder.write("green.csv", "519,0\n520,1\n521,0\n").string();
  EXPECT_TRUE(runSpectrum({green}).json.array()[0].find("cct_k")->isNull());
  EXPECT_TRUE(runSpectrum({green}).json.array()[0].find("ra")->isNull());
}

}  // namespace
}  // namespace goniolux::pipeline
