// A mesh's own names in "materials": the materials and groups of its file, and what reading the file says.
#include "project_fixture.h"

namespace goniolux::project {
namespace {

class MeshParts : public test::ProjectFixture {
 protected:
  void SetUp() override {
    folder_.write(
        "chair.obj",
        "v 1 1 0\nv 2 1 0\nv 1 2 0\nv 1 1 1\n"
        "o seat\nusemtl fabric\nf 1 3 2\nf 1 1 2\nusemtl steel\nf 1 2 4\no legs\nusemtl steel\nf 2 3 4\nf 1 4 3\n");
  }
  static std::string chair(const std::string& materials) {
    return changed("\"material\": \"grey\" } ]",
                   "\"material\": \"grey\" }, { \"name\": \"chair\", \"shape\": \"mesh\", "
                   "\"file\": \"chair.obj\", \"materials\": " +
                       materials + " } ]");
  }
};

TEST_F(MeshParts, GroupsOfTheFileNameSeveralPartsAtOnce) {
  const Project project = read(chair("{ \"seat\": \"grey\", \"legs/steel\": \"grey\" }"));
  EXPECT_EQ(project.environment.objects.at(1).materials.size(), 3U);
  EXPECT_EQ(errors(chair("{ \"fabric\": \"grey\", \"steel\": \"grey\" }")), "");
}

TEST_F(MeshParts, ABarePartAndAnUnknownNameAreErrors) {
  EXPECT_NE(errors(chair("{ \"seat\": \"grey\" }")).find("no material for legs/steel"), std::string::npos);
  EXPECT_NE(errors(chair("{ \"*\": \"grey\", \"seet\": \"grey\" }")).find("did you mean 'seat'"), std::string::npos);
}

TEST_F(MeshParts, TrianglesWithoutAreaAreAWarning) {
  const Project project = read(chair("{ \"*\": \"grey\" }"));
  ASSERT_FALSE(project.warnings.all().empty());
  EXPECT_NE(toString(project.warnings.all()[0]).find("1 triangle without area left out"), std::string::npos);
}

}  // namespace
}  // namespace goniolux::project
