// Materials of every model: keys, dispersion formulas, n and k from files.
#include <gtest/gtest.h>

#include "project_fixture.h"

namespace goniolux::project {
namespace {

class MaterialReader : public test::ProjectFixture {
 protected:
  material::Material materialOf(const std::string& json) {
    return read(changed("{ \"model\": \"lambert\", \"diffuse\": 0.5 }", json)).environment.materials.at(0);
  }
};

// BK7 at the sodium line: 1.5168 (F. Schott's catalogue), by its Sellmeier coefficients and by Cauchy's two terms.
TEST_F(MaterialReader, DispersionFormulasAreTabulated) {
  const auto bk7 = materialOf(
      "{ \"model\": \"dielectric\", \"ior\": { \"sellmeier\": { \"b\": [1.03961212, 0.231792344, 1.01046945], \"c\": "
      "[0.00600069867, 0.0200179144, 103.560653] } } }");
  EXPECT_NEAR(bk7.spectra.at("ior").continuum(587.6), 1.51680, 2e-5);
  EXPECT_NEAR(bk7.spectra.at("ior").continuum(486.1), 1.52238, 2e-5);
  const auto crown = materialOf("{ \"model\": \"dielectric\", \"ior\": { \"cauchy\": [1.5046, 0.0042] } }");
  EXPECT_NEAR(crown.spectra.at("ior").continuum(500), 1.5046 + 0.0042 / 0.25, 1e-9);
}

TEST_F(MaterialReader, NAndKComeFromAnNkFile) {
  folder_.write("metal.nk", "# made up\nwavelength n k\n400 1.5 1.9\n600 0.3 2.9\n700 0.16 3.7\n");
  const auto metal = materialOf("{ \"model\": \"conductor\", \"ior\": \"metal.nk\", \"roughness\": 0.1 }");
  EXPECT_NEAR(metal.spectra.at("ior").continuum(500), 0.9, 1e-12);
  EXPECT_NEAR(metal.spectra.at("k").continuum(500), 2.4, 1e-12);
  EXPECT_EQ(metal.numbers.at("roughness"), 0.1);
}

TEST_F(MaterialReader, FaultsOfAnNkFileNameItsLine) {
  folder_.write("metal.nk", "400 1.5 1.9\n600 0.3\n");
  const std::string text =
      changed("{ \"model\": \"lambert\", \"diffuse\": 0.5 }", "{ \"model\": \"conductor\", \"ior\": \"metal.nk\" }");
  const std::string message = errors(text);
  EXPECT_NE(message.find("metal.nk:2"), std::string::npos) << message;
  EXPECT_NE(message.find("three expected"), std::string::npos) << message;
  folder_.write("metal.nk", "400 1.5 1.9\n600 0.3 2\n");
  expectError(
      changed("{ \"model\": \"lambert\", \"diffuse\": 0.5 }", "{ \"model\": \"dielectric\", \"ior\": \"metal.nk\" }"),
      "\"metal.nk\"", "n and k are those of a metal");
}

TEST_F(MaterialReader, AnOpenBodyOfGlassIsWarnedOf) {
  std::string text = changed("\"material\": \"grey\" } ]",
                             "\"material\": \"grey\" }, { \"shape\": \"rectangle\", \"origin\": [1,1,1], \"u\": "
                             "[1,0,0], \"v\": [0,1,0], \"material\": \"glass\" } ]");
  text.replace(text.find("\"grey\": {"), 0, "\"glass\": { \"model\": \"dielectric\" }, ");
  const Project project = read(text);
  const auto& warnings = project.warnings.all();
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const auto& warning) {
    return core::toString(warning).find("not closed") != std::string::npos;
  }));
}

}  // namespace
}  // namespace goniolux::project
