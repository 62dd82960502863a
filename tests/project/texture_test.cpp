// Textures of the project format: read as meant, refused with their place.
#include <fstream>

#include "display/code_image.h"
#include "display/device_model.h"
#include "display/picture_file.h"
#include "project/project_fixture.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"

namespace goniolux::project {
namespace {

class Textures : public test::ProjectFixture {
 protected:
  static std::string material(const std::string& keys) {
    return changed("\"diffuse\": 0.5 } }",
                   "\"diffuse\": 0.5, " + keys +
                       " }, \"black\": { \"model\": \"lambert\", \"diffuse\": 0.1 }, \"glass\": "
                       "{ \"model\": \"dielectric\" } }");
  }
  void writePicture(const std::string& name, int width, int height, std::uint16_t red = 200) {
    display::CodeImage image;
    image.width = width, image.height = height;
    const bool isTiff = name.ends_with(".tif");  // written with 16 bits
    image.bits = isTiff ? 16 : 8;
    for (int i = 0; i < width * height; ++i)
      for (const int code : {int(red), 120, i % 2 ? 40 : 60})
        image.rgb.push_back(static_cast<std::uint16_t>(isTiff ? 257 * code : code));
    display::writePicture((folder_.path() / name).string(), image, display::readDevice("srgb"));
  }
};

TEST_F(Textures, OfTwoMaterialsHaveTheirMeanAsTheirOwnReflectance) {
  const Project project =
      read(material("\"texture\": { \"pattern\": \"stripes\", \"share\": 0.25, \"width\": 0.6, \"with\": \"black\" }"));
  const material::Material& finish = project.environment.materials.front();
  ASSERT_TRUE(finish.texture);
  ASSERT_EQ(finish.components.size(), 2U);
  EXPECT_NEAR(finish.spectra.at("diffuse").continuum(555), 0.75 * 0.5 + 0.25 * 0.1, 1e-12);
  const texture::Texture& stripes = *project.environment.textures.at(*finish.texture);
  EXPECT_EQ(stripes.at({{0.1, 5, 0}, {0, 0, 1}, {}}).component[0], 1U) << "the first quarter of 0.6 m";
  EXPECT_EQ(stripes.at({{0.2, 5, 0}, {0, 0, 1}, {}}).component[0], 0U);
}

TEST_F(Textures, PicturesKeepTheMeasuredReflectanceOnTheMean) {
  for (const char* name : {"wood.png", "wood.jpg", "wood.tif"}) {
    SCOPED_TRACE(name);
    writePicture(name, 8, 4, 160);
    const Project project = read(material("\"texture\": { \"image\": \"" + std::string(name) + "\", \"width\": 1 }"));
    const material::Material& finish = project.environment.materials.front();
    const auto colour = spectrum::tristimulus(finish.spectra.at("diffuse"), *spectrum::illuminant("CIE D65"));
    EXPECT_NEAR(colour.Y, 0.5, 1e-3);
    EXPECT_GT(colour.X, 0.5) << "reddish";
    EXPECT_EQ(project.inputs.size(), 2U) << "the picture is an input of the calculation";
  }
}

TEST_F(Textures, CalibratedPicturesAreTakenAsTheyAre) {
  writePicture("wood.png", 8, 4);
  const Project project =
      read(material("\"texture\": { \"image\": \"wood.png\", \"width\": 1, \"calibrated\": true }"));
  const auto colour = spectrum::tristimulus(project.environment.materials.front().spectra.at("diffuse"),
                                            *spectrum::illuminant("CIE D65"));
  // sRGB 200, 120, 50: linear 0.5776, 0.1878, 0.0319 on the mean.
  EXPECT_NEAR(colour.Y, 0.2126 * 0.5776 + 0.7152 * 0.1878 + 0.0722 * 0.0330, 1e-3);
}

TEST_F(Textures, ThatPromiseGigapixelsAreRefusedBeforeTheyAreUnpacked) {
  writePicture("bomb.png", 4, 4);
  // A PNG's width and height stand at bytes 16 to 23: 60 000 x 60 000 pixels, in a file with room for them.
  std::fstream file(folder_.path() / "bomb.png", std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(16);
  for (int i = 0; i < 2; ++i) file.write("\0\0\xEA\x60", 4);
  file.close();
  EXPECT_NE(errors(material("\"texture\": { \"image\": \"bomb.png\", \"width\": 1 }")).find("bomb.png"),
            std::string::npos);
  writePicture("large.png", 8000, 5001);
  EXPECT_NE(errors(material("\"texture\": { \"image\": \"large.png\", \"width\": 1 }"))
                .find("8000 x 5001 pixels, more than the 40 million"),
            std::string::npos);
}

TEST_F(Textures, AreRefusedWhereTheyMakeNoSense) {
  const auto refused = [&](const std::string& texture, const std::string& words) {
    expectError(material(texture), "", words);
  };
  refused("\"texture\": { \"pattern\": \"chequer\", \"width\": 1, \"with\": \"black\" }", "checker");
  refused("\"texture\": { \"pattern\": \"checker\", \"with\": \"black\" }", "needs \"width\"");
  refused("\"texture\": { \"pattern\": \"checker\", \"width\": 1 }", "needs \"with\"");
  refused("\"texture\": { \"pattern\": \"checker\", \"width\": 1, \"with\": \"blakc\" }", "black");
  refused("\"texture\": { \"pattern\": \"checker\", \"width\": 1, \"with\": \"grey\" }", "the material itself");
  refused("\"texture\": { \"pattern\": \"checker\", \"width\": 1, \"with\": \"glass\" }",
          "cannot be part of a texture");
  refused("\"texture\": { \"pattern\": \"checker\", \"share\": 0.2, \"width\": 1, \"with\": \"black\" }",
          "belongs to \"pattern\": \"stripes\"");
  refused("\"texture\": { \"pattern\": \"checker\", \"repeats\": [1,2], \"width\": 1, \"with\": \"black\" }", "uv");
  refused("\"texture\": { \"mapping\": \"uv\", \"pattern\": \"checker\", \"width\": 1, \"with\": \"black\" }",
          "repeats");
  refused("\"texture\": { \"image\": \"none.png\", \"width\": 1 }", "none.png");
  refused("\"bump\": { \"pattern\": \"noise\", \"width\": 1 }", "depth");
}

TEST_F(Textures, AReliefIsReadAndASmoothMeshHasNormals) {
  folder_.write("roof.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1.2\nf 1 2 3\nf 2 4 3\n");
  std::string text = material("\"bump\": { \"pattern\": \"noise\", \"width\": 0.05, \"depth\": 0.002 }");
  const std::string room = "\"material\": \"grey\" }";
  text.replace(text.find(room), room.size(),
               room + ", { \"shape\": \"mesh\", \"file\": \"roof.obj\", \"material\": \"grey\", \"smooth\": 40 }");
  const Project project = read(text);
  ASSERT_EQ(project.environment.reliefs.size(), 1U);
  EXPECT_EQ(project.environment.reliefs.front()->depth, 0.002);
  EXPECT_EQ(project.environment.objects.back().shape.mesh.smoothNormals.size(), 2U);
}

}  // namespace
}  // namespace goniolux::project
