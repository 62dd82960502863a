// What a good project becomes: units, frames, fluxes, points.
#include <cmath>

#include "project_fixture.h"

namespace goniolux::project {
namespace {

using core::Vec3;

class ProjectReader : public test::ProjectFixture {
 protected:
  scene::Luminaire luminaire(const std::string& keys) {
    const std::string entry = "\"name\": \"L\", \"photometry\": \"isotropic\", \"flux\": 1000, \"position\": [3,2,2]";
    const Project project = read(changed(entry, keys));
    EXPECT_FALSE(project.environment.luminaires.empty());
    return project.environment.luminaires.empty() ? scene::Luminaire{} : project.environment.luminaires.front();
  }
  static void expectNear(const Vec3& a, const Vec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-12) << a.x << " " << a.y << " " << a.z;
  }
};

TEST_F(ProjectReader, EveryUnitBecomesMetres) {
  const std::map<std::string, double> metres{{"m", 1}, {"mm", 0.001}, {"cm", 0.01}, {"ft", 0.3048}, {"in", 0.0254}};
  for (const auto& [unit, factor] : metres) {
    const Project project = read(changed("\"version\": 1,", "\"version\": 1, \"units\": \"" + unit + "\","));
    expectNear(project.environment.luminaires[0].center, Vec3(3, 2, 2) * factor);
    expectNear(project.grids[0].points[0], Vec3(1, 1, 0.8) * factor);
    expectNear(project.environment.objects[0].shape.mesh.vertices[7], Vec3(6, 4, 3) * factor);
  }
}

TEST_F(ProjectReader, GridPointsAreCellCentresWithUFastest) {
  const analysis::Grid grid = read(minimal()).grids[0];
  ASSERT_EQ(grid.points.size(), 6U);
  expectNear(grid.points[0], {1, 1, 0.8});
  expectNear(grid.points[1], {3, 1, 0.8});
  expectNear(grid.points[3], {1, 3, 0.8});
  expectNear(grid.normals[5], {0, 0, 1});
}

TEST_F(ProjectReader, ListedPointsTakeTheirNormals) {
  const std::string regular = "\"origin\": [0,0,0.8], \"u\": [6,0,0], \"v\": [0,4,0], \"counts\": [3,2]";
  const Project project = read(changed(regular, "\"points\": [[1,1,1],[2,2,2]], \"normals\": [[0,0,2],[3,0,4]]"));
  expectNear(project.grids[0].normals[1], {0.6, 0, 0.8});
  EXPECT_FALSE(project.grids[0].counts.has_value());
}

TEST_F(ProjectReader, LuminaireFrameFollowsTheFormat) {
  // Aim -z and c0 +x give C90 = +y: anticlockwise seen from above.
  const auto plain = luminaire("\"photometry\": \"isotropic\", \"flux\": 1, \"position\": [1,1,1]").frame;
  expectNear(plain.aim, {0, 0, -1});
  expectNear(plain.c0, {1, 0, 0});
  expectNear(plain.c90, {0, 1, 0});
  // Along x the default c0 would be parallel: [0, 1, 0] is taken. A c0 askew is made perpendicular.
  expectNear(luminaire("\"photometry\": \"isotropic\", \"flux\": 1, \"position\": [1,1,1], \"aim\": [2,0,0]").frame.c0,
             {0, 1, 0});
  const auto askew =
      luminaire("\"photometry\": \"isotropic\", \"flux\": 1, \"position\": [1,1,1], \"aim\": [0,0,-3], \"c0\": [1,1,5]")
          .frame;
  expectNear(askew.c0, Vec3(1, 1, 0) / std::sqrt(2.0));
  // A right-handed quarter turn about the aim -z takes +x to -y.
  const auto turned =
      luminaire("\"photometry\": \"isotropic\", \"flux\": 1, \"position\": [1,1,1], \"turn\": 90").frame;
  expectNear(turned.c0, {0, -1, 0});
  expectNear(turned.c90, {1, 0, 0});
}

TEST_F(ProjectReader, RotationAndTiltAimALuminaireAsItIsSetOnSite) {
  const auto frame = [&](const std::string& keys) {
    return luminaire("\"photometry\": \"isotropic\", \"flux\": 1, \"position\": [1,1,1], " + keys).frame;
  };
  // Turned to +y, then 30 degrees up from the nadir towards it.
  const auto set = frame("\"rotation\": 90, \"tilt\": 30");
  expectNear(set.aim, {0, 0.5, -std::sqrt(0.75)});
  expectNear(set.c0, {0, std::sqrt(0.75), 0.5});
  expectNear(set.c90, {-1, 0, 0});
  const auto same = frame("\"aim\": [0, 0.5, -0.8660254037844386], \"c0\": [0, 0.8660254037844386, 0.5]");
  expectNear(set.c90, same.c90);
  expectNear(frame("\"rotation\": 30").c0, {std::sqrt(0.75), 0.5, 0});
  expectNear(frame("\"tilt\": 180").aim, {0, 0, 1});
  EXPECT_THROW(frame("\"tilt\": 20, \"aim\": [1, 0, 0]"), core::InputError);
}

TEST_F(ProjectReader, FluxScalesTheDistribution) {
  const auto cosine = luminaire("\"photometry\": \"cosine\", \"flux\": 3600, \"position\": [1,1,1]");
  EXPECT_NEAR(cosine.distribution->flux() * cosine.scale, 3600, 1e-9);
  EXPECT_NEAR(cosine.distribution->intensity({0, 0, 1}) * cosine.scale, 3600 / core::pi, 1e-9);
  const auto point = luminaire("\"photometry\": \"isotropic\", \"flux\": 1000, \"position\": [1,1,1]");
  EXPECT_NEAR(point.distribution->intensity({1, 0, 0}) * point.scale, 1000 / (4 * core::pi), 1e-9);
  const auto file = luminaire("\"photometry\": \"panel-600.ies\", \"flux\": 4000, \"position\": [1,1,1]");
  EXPECT_NEAR(file.distribution->flux() * file.scale, 4000, 1e-9);
  EXPECT_EQ(file.watts, 30);
  const auto stated = luminaire("\"photometry\": \"panel-600.ies\", \"position\": [1,1,1]");
  EXPECT_EQ(stated.scale, 1) << "a file's candelas are not touched";
  EXPECT_NEAR(stated.flux_lm, 3600, 3.6);
  const auto diffuse = luminaire(
      "\"photometry\": \"diffuse\", \"flux\": 2800, \"position\": [1,1,1], \"shape\": { \"sphere\": { \"diameter\": "
      "0.3 } }");
  EXPECT_EQ(diffuse.distribution, nullptr);
  EXPECT_EQ(diffuse.flux_lm, 2800);
}

TEST_F(ProjectReader, LampFluxKeepsTheLightOutputRatio) {
  // The batten declares 3350 lm of its lamp and gives 95 % of it (luminaires/README.md).
  const auto batten = luminaire("\"photometry\": \"batten-t8.ldt\", \"lamp_flux\": 2000, \"position\": [1,1,1]");
  EXPECT_NEAR(batten.flux_lm, 1900, 2);
  expectError(changed("\"isotropic\", \"flux\": 1000", "\"panel-600.ies\", \"lamp_flux\": 100"), "100, \"position\"",
              "absolute");
  expectError(changed("\"flux\": 1000", "\"lamp_flux\": 100"), "\"isotropic\"", "needs \"flux\"");
}

TEST_F(ProjectReader, DiffuseLightNeedsASurface) {
  expectError(changed("\"isotropic\"", "\"diffuse\""), "\"diffuse\", \"flux\"", "leaves a surface");
}

TEST_F(ProjectReader, OpeningComesFromTheFileOrTheProject) {
  using Shape = emitter::Opening::Shape;
  const auto panel = luminaire("\"photometry\": \"panel-600.ies\", \"position\": [1,1,1]").opening;
  EXPECT_EQ(panel.shape, Shape::rectangle);
  EXPECT_NEAR(panel.length, 0.6, 1e-3);
  // EULUMDAT lays the length along C90: the opening's length, along C0, is the file's width.
  const auto pendant = luminaire("\"photometry\": \"linear-pendant.ldt\", \"position\": [1,1,1]").opening;
  EXPECT_NEAR(pendant.width, 1.2, 1e-3);
  EXPECT_NEAR(pendant.length, 0.06, 1e-3);
  const auto tube = luminaire(
                        "\"photometry\": \"diffuse\", \"flux\": 1, \"position\": [1,1,1], \"shape\": { \"tube\": "
                        "{ \"length\": 1.2, \"diameter\": 0.026, \"axis\": [0,2,0] } }")
                        .opening;
  EXPECT_EQ(tube.shape, Shape::tube);
  expectNear(tube.axis, {0, 1, 0});
  EXPECT_EQ(luminaire("\"photometry\": \"panel-600.ies\", \"position\": [1,1,1], \"shape\": \"point\"").opening.shape,
            Shape::point);
}

TEST_F(ProjectReader, ArraysStepFromTheFirstElement) {
  const std::string one = "\"flux\": 1000";
  const Project project =
      read(changed(one, one + ", \"array\": { \"counts\": [2,2], \"u\": [1,0,0], \"v\": [0,0.5,0] }"));
  ASSERT_EQ(project.environment.luminaires.size(), 4U);
  EXPECT_EQ(project.environment.luminaires[1].name, "L[1,0]");
  expectNear(project.environment.luminaires[1].center, {4, 2, 2});
  EXPECT_EQ(project.environment.luminaires[2].name, "L[0,1]");
  expectNear(project.environment.luminaires[2].center, {3, 2.5, 2});
  EXPECT_EQ(project.environment.luminaires[3].type, "L");
}

TEST_F(ProjectReader, EqualSpectraAreKeptOnce) {
  const std::string a = "{ \"name\": \"L\", \"photometry\": \"isotropic\", \"flux\": 1000, \"position\": [3,2,2] }";
  std::string list;
  for (const char* spectrum : {"\"CIE A\"", "\"CIE FL11\"", "\"CIE A\"", "{ \"blackbody\": 4000 }"}) {
    list += std::string(list.empty() ? "" : ", ") + "{ \"name\": \"L" + std::to_string(list.size()) +
            "\", \"photometry\": \"isotropic\", \"flux\": 1, \"position\": [1,1,1], \"spectrum\": " + spectrum + " }";
  }
  const Project project = read(changed(a, list));
  EXPECT_EQ(project.environment.sourceSpectra.size(), 3U);
  EXPECT_EQ(project.environment.luminaires[0].spectrum, project.environment.luminaires[2].spectrum);
}

TEST_F(ProjectReader, TransformStepsAreAppliedInOrder) {
  const std::string material = "\"material\": \"grey\" }";
  const Project project = read(changed(
      material,
      material + ", { \"shape\": \"box\", \"min\": [0,0,0], \"max\": [1,1,1], \"material\": \"grey\", \"transform\": ["
                 "{ \"scale\": [2,1,1] }, { \"translate\": [1,0,0] }, "
                 "{ \"rotate\": { \"axis\": [0,0,3], \"degrees\": 90, \"center\": [1,0,0] } } ] }"));
  const auto& box = project.environment.objects[1];
  // (1,1,1) -> (2,1,1) -> (3,1,1) -> about (1,0): (2,1) turns to (-1,2) -> (0,2,1).
  expectNear(Vec3(box.transform * glm::dvec4(1, 1, 1, 1)), {0, 2, 1});
}

TEST_F(ProjectReader, PartsTakeTheirOwnMaterialBeforeTheGroups) {
  std::string text = changed("\"material\": \"grey\"",
                             "\"material\": \"grey\", \"materials\": { \"walls\": \"white\", \"xmax\": \"black\" }");
  text.replace(text.find("\"grey\": {"), 0,
               "\"white\": { \"model\": \"lambert\", \"diffuse\": 0.9 }, \"black\": { \"model\": \"lambert\", "
               "\"diffuse\": 0 }, ");
  const Project project = read(text);
  const auto& room = project.environment.objects[0];
  const auto materialOf = [&](const std::string& part) {
    const auto& names = room.shape.partNames;
    const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), part) - names.begin());
    return project.environment.materials[room.materials[at]].name;
  };
  EXPECT_EQ(materialOf("floor"), "grey");
  EXPECT_EQ(materialOf("xmin"), "white");
  EXPECT_EQ(materialOf("xmax"), "black");
}

TEST_F(ProjectReader, SceneDimsGroupsAndSwitchesTheOthersOff) {
  const std::string l = "{ \"name\": \"L\", \"photometry\": \"isotropic\", \"flux\": 1000, \"position\": [3,2,2] }";
  std::string text = changed(
      l,
      "{ \"name\": \"L\", \"photometry\": \"isotropic\", \"flux\": 1000, \"position\": [3,2,2], \"dimming\": 0.5 },\n"
      "{ \"name\": \"M\", \"photometry\": \"isotropic\", \"flux\": 1, \"position\": [1,2,2], \"group\": \"g\" }");
  text.replace(text.rfind("\n}\n"), 3, ",\n \"scenes\": [ { \"name\": \"s\", \"groups\": { \"L\": 0.4 } } ]\n}\n");
  const Project all = read(text), dimmed = read(text, {{}, "s"});
  EXPECT_EQ(all.environment.luminaires[0].dimming, 0.5);
  EXPECT_EQ(all.environment.luminaires[1].dimming, 1);
  EXPECT_DOUBLE_EQ(dimmed.environment.luminaires[0].dimming, 0.2);
  EXPECT_EQ(dimmed.environment.luminaires[1].dimming, 0);
  EXPECT_NE(all.hash, dimmed.hash);
  expectError(text, "", "--scene x: error: the project has no lighting scene \"x\"", {{}, "x"});
}

TEST_F(ProjectReader, SettingsOnTheCommandLineGoBeforeTheFile) {
  const std::string text =
      with("\"settings\": { \"accuracy\": { \"grid\": \"1 %\" }, \"tree\": { \"max_depth\": 9 }, \"seed\": 3 }");
  const Settings file = read(text).settings;
  EXPECT_DOUBLE_EQ(file.accuracy.grid, 0.01);
  EXPECT_EQ(file.seed, 3U);
  const Settings set =
      read(text, {{"tree.cutoff=0.5", "accuracy.grid=0.5 %", "spectral=uniform:9", "time_limit_s=7"}, {}}).settings;
  EXPECT_EQ(set.treeCutoff, 0.5);
  EXPECT_EQ(set.treeMaxDepth, 9) << "what is not set stays";
  EXPECT_DOUBLE_EQ(set.accuracy.grid, 0.005);
  EXPECT_EQ(set.spectralScheme, "uniform");
  EXPECT_EQ(set.spectralSamples, 9);
  EXPECT_EQ(set.timeLimit_s, 7);
  expectError(text, "", "--set tree.cutof=1: error: tree has no key \"cutof\"; did you mean 'cutoff'?",
              {{"tree.cutof=1"}, {}});
  expectError(text, "", "--set seed: error: write KEY=VALUE", {{"seed"}, {}});
  expectError(text, "", "--set accuracy.grid=200 %: error:", {{"accuracy.grid=200 %"}, {}});
}

TEST_F(ProjectReader, HashIsOfTheInputsAndOfWhatChangesResults) {
  const std::string hash = read(minimal()).hash;
  EXPECT_EQ(hash.size(), 64U);
  EXPECT_EQ(read(minimal()).hash, hash);
  EXPECT_EQ(read(minimal(), {{"time_limit_s=5"}, {}}).hash, hash) << "a time limit changes no result that was reached";
  EXPECT_NE(read(minimal(), {{"seed=5"}, {}}).hash, hash);
  EXPECT_NE(read(changed("1000", "1001")).hash, hash);
  folder_.write("grey.csv", "400,0.5\n700,0.5\n");
  const std::string text = changed("\"diffuse\": 0.5", "\"diffuse\": \"grey.csv\"");
  const Project before = read(text);
  ASSERT_EQ(before.inputs.size(), 2U);
  EXPECT_EQ(before.inputs[0].path, "project.json");
  EXPECT_EQ(before.inputs[1].path, "grey.csv");
  folder_.write("grey.csv", "400,0.5\n700,0.6\n");
  EXPECT_NE(read(text).hash, before.hash);
}

TEST_F(ProjectReader, FileOfTheProjectGoesBeforeTheLibrarys) {
  folder_.write("oak.spd", "400 0.25\n700 0.25\n");
  const Project project = read(changed("\"diffuse\": 0.5", "\"diffuse\": \"oak.spd\""));
  EXPECT_DOUBLE_EQ(project.environment.materials[0].spectra.at("diffuse").continuum(550), 0.25);
}

TEST_F(ProjectReader, HorizontalFieldOfViewBecomesVertical) {
  const std::string view = "\"name\": \"v\", \"eye\": [1,1,1], \"target\": [3,3,1]";
  const auto fov = [&](const std::string& keys) {
    return read(with("\"views\": [ { " + view + keys + " } ]")).views[0].verticalFov;
  };
  EXPECT_NEAR(fov(", \"fov\": 50"), 50 * core::degree, 1e-12);
  // tan(v/2) = tan(45 deg) 480/640.
  EXPECT_NEAR(fov(", \"fov\": { \"horizontal\": 90 }"), 2 * std::atan(0.75), 1e-12);
  EXPECT_NEAR(fov(", \"fov\": { \"horizontal\": 160 }, \"projection\": \"fisheye-equidistant\""), 120 * core::degree,
              1e-12);
  expectError(with("\"views\": [ { " + view + ", \"fov\": 180 } ]"), "180", "less than 180");
  expectError(with("\"views\": [ { " + view + ", \"projection\": \"orthographic\" } ]"), "{ \"name\": \"v\"",
              "needs \"span\"");
}

TEST_F(ProjectReader, GoniometricDiagramsKeepTheirCandelas) {
  const auto both = luminaire(
      "\"photometry\": { \"goniometric\": { \"c0\": [[0,100],[90,0]], \"c90\": [[0,100],[45,80],[90,0]] } }, "
      "\"position\": [1,1,1]");
  const double s = std::sqrt(0.5);
  EXPECT_NEAR(both.distribution->intensity({0, 0, 1}), 100, 1e-9);
  EXPECT_NEAR(both.distribution->intensity({s, 0, s}), 50, 1e-9);
  EXPECT_NEAR(both.distribution->intensity({0, s, s}), 80, 1e-9);
  EXPECT_NEAR(both.distribution->intensity({0, -s, s}), 80, 1e-9);
  EXPECT_EQ(both.distribution->intensity({0, 0, -1}), 0);
}

TEST_F(ProjectReader, DefaultSpectrumIsNamedWhereColoursDependOnIt) {
  EXPECT_TRUE(read(minimal()).warnings.all().empty()) << "greys do not";
  const Project coloured = read(changed("\"diffuse\": 0.5", "\"diffuse\": { \"srgb\": [0.8, 0.2, 0.2] }"));
  ASSERT_EQ(coloured.warnings.all().size(), 1U);
  EXPECT_NE(coloured.warnings.all()[0].message.find("CIE E"), std::string::npos);
}

}  // namespace
}  // namespace goniolux::project
