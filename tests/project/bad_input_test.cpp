// Bad projects: each fault gets a message that says where it stands, what is wrong and what to do.
#include <algorithm>

#include "project_fixture.h"

namespace goniolux::project {
namespace {

class BadInput : public test::ProjectFixture {};

TEST_F(BadInput, MinimalProjectIsGood) {
  EXPECT_EQ(errors(minimal()), "");
}

TEST_F(BadInput, MissingProjectSaysWhatIsExpected) {
  try {
    readProject((folder_.path() / "nowhere").string());
    FAIL() << "no error";
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("give a folder that holds a project.json"), std::string::npos);
  }
  EXPECT_THROW(readProject(folder_.path().string()), core::InputError);  // a folder without a project.json
}

TEST_F(BadInput, BrokenJsonIsReportedAtItsPlace) {
  expectError(changed("\"flux\": 1000", "\"flux\": "), ", \"position\"", "a value is expected here");
  expectError(minimal().substr(0, 300), "", "is the file complete?");
}

TEST_F(BadInput, AnotherFormatOrVersionIsRefusedAtOnce) {
  expectError("{\"hello\": 1}", "{", "no project file");
  expectError("[1, 2]", "[", "a project is an object");
  expectError(changed("\"version\": 1", "\"version\": 2"), "2,", "\"version\": 1");
}

TEST_F(BadInput, UnknownKeyIsNamedWithLineAndClosestKey) {
  expectError(changed("\"photometry\"", "\"photometri\""), "\"photometri\"",
              "no key \"photometri\"; did you mean 'photometry'?");
  expectError(changed("\"objects\"", "\"objcts\""), "\"objcts\"", "did you mean 'objects'?");
  expectError(changed("\"diffuse\"", "\"difuse\""), "\"difuse\"", "did you mean 'diffuse'?");
  expectError(changed("\"facing\"", "\"faceing\""), "\"faceing\"", "did you mean 'facing'?");
  expectError(with("\"settings\": { \"tree\": { \"cutof\": 1 } }"), "\"cutof\"", "did you mean 'cutoff'?");
}

TEST_F(BadInput, MissingFileNamesTheFoldersThatWereSearched) {
  const std::string text = changed("\"isotropic\"", "\"no-such-panel.ies\"");
  expectError(text, "\"no-such", "there is no file 'no-such-panel.ies'; looked in " + folder_.path().string());
  const std::string message = [&] {
    try {
      read(text);
      return std::string();
    } catch (const core::InputError& error) {
      return std::string(error.what());
    }
  }();
  const std::size_t own = message.find("looked in " + folder_.path().string());
  const std::size_t library = message.find(std::string(GONIOLUX_SOURCE_DIR) + "/luminaires");
  ASSERT_NE(own, std::string::npos) << message;
  ASSERT_NE(library, std::string::npos) << message;
  EXPECT_LT(own, library) << "the project's folder is looked in first";
  expectError(changed("\"diffuse\": 0.5", "\"diffuse\": \"no-such-finish.spd\""), "\"no-such-finish.spd\"",
              "there is no file 'no-such-finish.spd'");
  expectError(changed("\"isotropic\"", "\"isotropc\""), "\"isotropc\"", "did you mean \"isotropic\"?");
}

TEST_F(BadInput, NegativeLengthIsRefused) {
  const std::string shape = "\"flux\": 1000, \"shape\": { \"sphere\": { \"diameter\": -0.1 } }";
  expectError(changed("\"flux\": 1000", shape), "-0.1 }", "\"diameter\" is -0.1; it must be above 0");
  expectError(changed("\"shape\": \"box\", \"min\": [0,0,0], \"max\": [6,4,3], \"facing\": \"inward\"",
                      "\"shape\": \"sphere\", \"center\": [0,0,0], \"radius\": -1"),
              "", "\"radius\" is -1; it must be above 0");
}

TEST_F(BadInput, ReflectanceAboveOneOrBelowZeroIsRefused) {
  expectError(changed("\"diffuse\": 0.5", "\"diffuse\": 1.2"), "1.2 }", "\"diffuse\" is 1.2; it lies between 0 and 1");
  expectError(changed("\"diffuse\": 0.5", "\"diffuse\": -0.1"), "-0.1 }", "it lies between 0 and 1");
  expectError(changed("\"diffuse\": 0.5", "\"diffuse\": { \"wavelengths\": [400, 500], \"values\": [0.5, 1.5] }"),
              "1.5]", "it lies between 0 and 1");
  folder_.write("percent.csv", "400,50\n700,60\n");
  expectError(changed("\"diffuse\": 0.5", "\"diffuse\": \"percent.csv\""), "", "percent.csv:1");
}

TEST_F(BadInput, NotANumberIsRefused) {
  expectError(changed("\"diffuse\": 0.5", "\"diffuse\": NaN"), "NaN",
              "NaN is not a number that can be calculated with");
  expectError(changed("\"flux\": 1000", "\"flux\": Infinity"), "Infinity", "finite");
}

TEST_F(BadInput, GridWhollyOutsideTheRoomIsRefused) {
  expectError(changed("\"origin\": [0,0,0.8]", "\"origin\": [20,0,0.8]"), "{ \"name\": \"work plane\"",
              "the grid \"work plane\" lies wholly outside every room");
  expectError(changed("\"origin\": [0,0,0.8]", "\"origin\": [0,0,800]"), "{ \"name\": \"work plane\"",
              "check its origin, edges and the project's \"units\"");
}

TEST_F(BadInput, GridPartlyOutsideIsAWarning) {
  const Project project = read(changed("\"u\": [6,0,0]", "\"u\": [12,0,0]"));
  ASSERT_EQ(project.warnings.all().size(), 1U);
  EXPECT_NE(project.warnings.all()[0].message.find("2 of 6 points"), std::string::npos)
      << project.warnings.all()[0].message;
}

TEST_F(BadInput, ViewInsideAnObjectIsRefused) {
  const std::string desk =
      "\"material\": \"grey\" }, { \"name\": \"desk\", \"shape\": \"box\", \"min\": [1,1,0], \"max\": [2,2,1], "
      "\"material\": \"grey\" }";
  std::string text = changed("\"material\": \"grey\" }", desk);
  const std::string view = ",\n  \"views\": [ { \"name\": \"v\", \"eye\": [1.5,1.5,0.5], \"target\": [3,3,1] } ]\n}\n";
  text.replace(text.rfind("\n}\n"), 3, view);
  expectError(text, "{ \"name\": \"v\"", "the eye of the view \"v\" lies inside \"desk\" (line 4)");
}

TEST_F(BadInput, ViewInsideARoundSolidIsRefused) {
  for (const char* solid : {"\"shape\": \"sphere\", \"center\": [1.5,1.5,1], \"radius\": 0.3",
                            "\"shape\": \"cylinder\", \"base\": [1.5,1.5,0], \"height\": 2, \"radius\": 0.3"}) {
    std::string text = changed("\"material\": \"grey\" }", "\"material\": \"grey\" }, { \"name\": \"solid\", " +
                                                               std::string(solid) + ", \"material\": \"grey\" }");
    const std::string view =
        ",\n  \"views\": [ { \"name\": \"v\", \"eye\": [1.5,1.6,0.9], \"target\": [3,3,1] } ]\n}\n";
    text.replace(text.rfind("\n}\n"), 3, view);
    expectError(text, "{ \"name\": \"v\"", "lies inside \"solid\"");
  }
}

TEST_F(BadInput, UndefinedMaterialIsNamedWithTheClosest) {
  expectError(changed("\"material\": \"grey\"", "\"material\": \"gray\""), "\"gray\"",
              "the material \"gray\" is not defined; did you mean 'grey'?");
}

TEST_F(BadInput, PartWithoutMaterialAndUnknownPartAreNamed) {
  expectError(changed("\"material\": \"grey\"", "\"materials\": { \"floor\": \"grey\", \"walls\": \"grey\" }"),
              "{ \"name\": \"room\"", "no material for ceiling of \"room\"");
  expectError(changed("\"material\": \"grey\"", "\"materials\": { \"wals\": \"grey\", \"*\": \"grey\" }"), "\"wals\"",
              "did you mean 'walls'?");
}

TEST_F(BadInput, NamesMustBeUnique) {
  const std::string tail = "\"counts\": [3,2] }";
  expectError(
      changed(tail,
              tail + ",\n { \"name\": \"a\", \"points\": [[1,1,1]] },\n { \"points\": [[2,2,2]], \"name\": \"a\"}"),
      "\"a\"}", "another grid (line 7) is named \"a\" too");
  const std::string luminaire =
      "{ \"name\": \"L\", \"photometry\": \"isotropic\", \"flux\": 1000, \"position\": [3,2,2] }";
  expectError(changed(luminaire, luminaire + ",\n" + luminaire + " "), luminaire + " ", "is named \"L\" too");
}

TEST_F(BadInput, NamesThatMakeTheSameFileAreRefused) {
  const std::string view = "\"views\": [ { \"name\": \"Work-Plane\", \"eye\": [1,1,1], \"target\": [3,3,1] } ]";
  expectError(with(view), "\"Work-Plane\"", "would write the same result files (work-plane.*) as the name in line 6");
  expectError(changed("\"work plane\"", "\"..\""), "\"..\"", "no file name can be made");
  expectError(changed("\"work plane\"", "\"\""), "\"\", \"origin\"", "no file name can be made");
}

TEST_F(BadInput, RequirementForAnUnknownGridIsRefused) {
  expectError(with("\"requirements\": [ { \"grid\": \"workplane\", \"mean_lx\": { \"min\": 500 } } ]"), "\"workplane\"",
              "there is no grid \"workplane\"; did you mean 'work plane'?");
  expectError(with("\"requirements\": [ { \"grid\": \"work plane\", \"ugr\": { \"max\": 19 } } ]"), "\"ugr\"",
              "limit for observers");
  expectError(with("\"requirements\": [ { \"mean_lx\": { \"min\": 500 } } ]"), "{ \"mean_lx\"",
              "either a \"grid\" or an \"observer\"");
  expectError(with("\"requirements\": [ { \"grid\": \"work plane\", \"u0\": { \"min\": 2, \"max\": 1 } } ]"),
              "{ \"min\": 2", "exceeds");
}

TEST_F(BadInput, CountsMustBeWholeAndPositive) {
  for (const char* counts : {"[0,2]", "[3,-2]", "[1.5,2]", "[3]", "[3,2,1]", "3", "\"3x2\"", "[1000001,1]"}) {
    expectError(changed("[3,2] } ]", std::string(counts) + " } ]"), std::string(counts) + " } ]",
                "\"counts\" must be two whole numbers");
  }
  expectError(changed("[3,2] } ]", "[100000,100000] } ]"), "[100000", "at most a million");
}

TEST_F(BadInput, VectorsWithoutLengthAreRefused) {
  expectError(changed("\"flux\": 1000", "\"flux\": 1000, \"aim\": [0,0,0]"), "[0,0,0], \"position\"",
              "\"aim\" has no length");
  expectError(changed("\"flux\": 1000", "\"flux\": 1000, \"aim\": [1,0,0], \"c0\": [2,0,0]"), "[2,0,0]",
              "parallel to \"aim\"");
  expectError(changed("\"v\": [0,4,0]", "\"v\": [3,0,0]"), "[6,0,0], \"v\"", "span no area");
  expectError(changed("\"flux\": 1000", "\"flux\": 1000, \"array\": { \"counts\": [3,1] }"), "{ \"counts\": [3,1]",
              "would stand in one place");
}

TEST_F(BadInput, WrongTypesSayWhatIsExpected) {
  expectError(changed("\"flux\": 1000", "\"flux\": \"1000\""), "\"1000\"", "\"flux\" is a text; a number is expected");
  expectError(changed("\"position\": [3,2,2]", "\"position\": [3,2]"), "[3,2] }", "three numbers");
  expectError(changed("\"name\": \"L\"", "\"name\": 7"), "7, \"photometry\"", "a text in quotes is expected");
  expectError(changed("\"objects\": [", "\"objects\": { \"a\": ["), "", "error");
  expectError(with("\"views\": { \"name\": \"v\" }"), "{ \"name\": \"v\"", "\"views\" must be a list");
  expectError(with("\"settings\": [1]"), "[1]", "an object");
}

TEST_F(BadInput, AReceiverThatDoesNotKnowWhereItFacesIsRefused) {
  const auto grid = [&](const std::string& keys) { return changed("[3,2] } ]", "[3,2], " + keys + " } ]"); };
  expectError(grid("\"quantity\": \"cylindric\""), "\"cylindric\"", "did you mean 'cylindrical'?");
  expectError(grid("\"quantity\": \"semi-cylindrical\""), "\"semi-cylindrical\"", "give a \"normal\"");
  expectError(grid("\"axis\": [1,0,0]"), "[1,0,0]", "means nothing for the quantity \"illuminance\"");
  expectError(
      with("\"observers\": [ { \"name\": \"o\", \"eye\": [1,1,1], \"direction\": [1,0,0], \"quantity\": \"ugg\" } ]"),
      "\"ugg\"", "did you mean 'ugr'?");
}

TEST_F(BadInput, ALuminaireOfRevolutionMustBeClosed) {
  expectError(changed("\"flux\": 1000",
                      "\"flux\": 1000, \"shape\": { \"revolution\": { \"profile\": [[1,0],[0.2,0.5],[1,1]] } }"),
              "[[1,0]", "the profile must begin and end on the axis");
}

TEST_F(BadInput, MaterialsThatMakeLightAreRefused) {
  const std::string grey = "\"model\": \"lambert\", \"diffuse\": 0.5";
  expectError(changed(grey, "\"model\": \"ward\", \"diffuse\": 0.7, \"specular\": 0.4"), "{ \"model\"",
              "\"diffuse\" and \"specular\" exceed 1 together");
  expectError(changed(grey, "\"model\": \"conductor\", \"ior\": 1, \"k\": 5, \"roughness\": 0.1, \"gloss\": 20"),
              "{ \"model\"", "leave only one");
  expectError(changed(grey, "\"model\": \"dielectric\", \"ior\": 0"), "0 }", "\"ior\"");
  expectError(changed(grey, "\"model\": \"dielectric\", \"ior\": { \"cauchy\": [1.5, 4200] }"), "[1.5, 4200]",
              "wavelengths are in micrometres");
  expectError(changed(grey, "\"model\": \"lambrt\", \"diffuse\": 0.5"), "\"lambrt\"", "no reflection model");
}

TEST_F(BadInput, AllErrorsOfAFileAreListedTogether) {
  std::string text = changed("\"diffuse\": 0.5", "\"diffuse\": 1.5");
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("\"flux\": 1000", "\"flux\": -1");
  replace("\"counts\": [3,2]", "\"counts\": [3,0]");
  replace("\"facing\"", "\"faceing\"");
  const std::string message = errors(text);
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 3) << message;
  for (const char* line : {"json:3:", "json:4:", "json:5:", "json:6:"})
    EXPECT_NE(message.find(line), std::string::npos) << message;
}

}  // namespace
}  // namespace goniolux::project
