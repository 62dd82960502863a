// Layers, spectral channels and the test card: images of small projects with known answers.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/document.h"
#include "image/exr.h"
#include "image/image_file.h"
#include "pipeline/stages.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

StageReport called(Stage (*stage)(), std::vector<std::string> inputs, std::map<std::string, std::string> options,
                   std::optional<std::string> output) {
  StageRequest request;
  request.inputs = std::move(inputs);
  request.options = std::move(options);
  request.common.output = std::move(output);
  core::SilentProgress progress;
  return stage().run(request, progress);
}

// A diffuse card of reflectance 1 that faces two lamps at 2 m; each pixel sees the card straight on.
std::string card(const char* dimA, const char* dimB, const char* extra = "") {
  return std::string(R"({
  "format": "goniolux-project", "version": 1, "name": "card",
  "materials": { "white": { "model": "lambert", "diffuse": 1.0 })") +
         extra + R"( },
  "objects": [ { "name": "card", "shape": "rectangle", "origin": [-0.05,-0.05,0], "u": [0.1,0,0], "v": [0,0.1,0], "material": "white" } ],
  "luminaires": [
    { "name": "a", "photometry": "isotropic", "flux": 4000, "position": [0,0,2], "spectrum": "CIE A", "group": "warm", "dimming": )" +
         dimA + R"( },
    { "name": "b", "photometry": "isotropic", "flux": 2000, "position": [0,0,2], "spectrum": "CIE D65", "group": "cool", "dimming": )" +
         dimB + R"( }
  ],
  "views": [ { "name": "card", "eye": [0,0,1], "target": [0,0,0], "up": [0,1,0], "fov": 2, "width": 6, "height": 4 } ],
  "settings": { "solver": "path", "accuracy": { "image": "1 %" } }
})";
}

// Closed form: L = rho / pi * I cos / d^2 at each pixel's own place; I = flux / 4 pi.
double closedForm(double flux, double fromAxis) {
  const double d2 = 4 + fromAxis * fromAxis;
  return flux / (4 * core::pi) / core::pi * 2 / std::pow(d2, 1.5);
}

TEST(TestCard, EveryPixelHasTheXyzOfTheClosedForm) {
  const test::TemporaryFolder folder;
  const std::string project = folder.write("p/project.json", card("1", "0")).string();
  called(renderStage, {project}, {}, folder.path().string());
  const image::XyzImage image = image::readExr((folder.path() / "card.exr").string());
  const spectrum::Xyz a = spectrum::tristimulus(*spectrum::illuminant("CIE A"));
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 6; ++x) {
      const auto i = static_cast<std::size_t>(6 * y + x);
      const double scale = 2 * std::tan(core::degree) / 4;  // metres per pixel at 1 m
      const double expected = closedForm(4000, std::hypot((x - 2.5) * scale, (y - 1.5) * scale));
      // Half-widths of a picture without noise are tiny: single precision is what is left, and the steps of 1 nm to 5
      // nm between the two ways to integrate illuminant A.
      const double h = static_cast<double>(image.halfWidth[i]) + 1e-5 * expected;
      EXPECT_NEAR(image.y[i], expected, h) << x << " " << y;
      EXPECT_NEAR(image.x[i], expected * a.X / a.Y, h * a.X / a.Y + 3e-4 * expected);
      EXPECT_NEAR(image.z[i], expected * a.Z / a.Y, h * a.Z / a.Y + 3e-4 * expected);
    }
}

TEST(Layers, AreKeptAndMixedForAnyDimmingWithoutTracing) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("p/project.json", card("1", "0"));
  const auto out = folder.path() / "out";
  const auto first = called(renderStage, {file.string()}, {{"layers", "true"}}, out.string());
  EXPECT_EQ(first.json.find("layers_rendered")->number(), 2);
  EXPECT_TRUE(std::filesystem::exists(out / "layers/warm/card.exr"));
  EXPECT_TRUE(std::filesystem::exists(out / "layers/cool/card.exr")) << "also of a group that is dimmed to 0";
  const auto warm = image::readExr((out / "card.exr").string());
  EXPECT_NEAR(warm.y[9], closedForm(4000, 0), 0.01 * closedForm(4000, 0));

  folder.write("p/project.json", card("0.25", "0.5"));
  const auto second = called(renderStage, {file.string()}, {{"layers", "true"}}, out.string());
  EXPECT_EQ(second.json.find("layers_rendered")->number(), 0);
  EXPECT_EQ(second.json.find("layers_kept")->number(), 2);
  const auto both = image::readExr((out / "card.exr").string());
  EXPECT_NEAR(both.y[9], closedForm(0.25 * 4000 + 0.5 * 2000, 0), 0.001 * closedForm(2000, 0));

  // The same by hand, from the layers.
  const std::string mixed = (folder.path() / "mixed.exr").string();
  called(mixStage,
         {(out / "layers/warm/card.exr").string() + "=0.25", (out / "layers/cool/card.exr").string() + "=0.5"}, {},
         mixed);
  EXPECT_EQ(image::readExr(mixed).y, both.y);
  // And the same rendered directly, with both lamps on.
  called(renderStage, {file.string()}, {}, (folder.path() / "direct").string());
  const auto direct = image::readExr((folder.path() / "direct/card.exr").string());
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_NEAR(both.x[i], direct.x[i], 0.001F * direct.x[i]);
    EXPECT_NEAR(both.z[i], direct.z[i], 0.001F * direct.z[i]);
  }
  EXPECT_EQ(both.attributes.at("adoptedWhite"), direct.attributes.at("adoptedWhite"));

  // A change of the scene itself is seen.
  folder.write("p/project.json", card("1", "1", R"(, "grey": { "model": "lambert", "diffuse": 0.5 })"));
  EXPECT_EQ(
      called(renderStage, {file.string()}, {{"layers", "true"}}, out.string()).json.find("layers_rendered")->number(),
      2);
}

// Spectral radiance of the card is the lamp's spectrum: L_e = L_v S / (Km integral of S ybar).
TEST(SpectralChannels, AreTheLampsSpectrumInAbsoluteUnits) {
  const test::TemporaryFolder folder;
  const std::string project = folder.write("p/project.json", card("1", "0")).string();
  called(renderStage, {project}, {{"channels", "450:650:50"}}, folder.path().string());
  const image::XyzImage image = image::readExr((folder.path() / "card.exr").string());
  ASSERT_EQ(image.spectrum.size(), 5U);
  const auto a = *spectrum::illuminant("CIE A");
  const double luminous = spectrum::maximumLuminousEfficacy * a.integral(spectrum::cie1931().ybar);
  for (const auto& channel : image.spectrum) {
    const double mean = a.integral(channel.wavelength_nm - 25, channel.wavelength_nm + 25) / 50;
    const double expected = closedForm(4000, 0) * mean / luminous;
    EXPECT_NEAR(channel.values[9], expected, 0.002 * expected) << channel.wavelength_nm;
    ASSERT_EQ(channel.halfWidth.size(), channel.values.size());
    EXPECT_LT(channel.halfWidth[9], 0.001 * expected) << "a card without noise";
  }
  EXPECT_THROW(called(renderStage, {project}, {{"channels", "400:700"}}, folder.path().string()), core::InputError);
}

// Direct and indirect light as layers of the image and of its groups: they add up, and are mixed apart.
TEST(Layers, OfDirectAndIndirectLightAreMixedApart) {
  const test::TemporaryFolder folder;
  const std::string wall = R"(, "wall": { "model": "lambert", "diffuse": 0.8 })";
  std::string text = card("1", "0.5", wall.c_str());
  // A wall beside the card, which lights it.
  const std::string mark = "\"objects\": [";
  text.insert(
      text.find(mark) + mark.size(),
      R"( { "name": "wall", "shape": "rectangle", "origin": [0.06,-1,0], "u": [0,2,0], "v": [0,0,2], "material": "wall" },)");
  const std::string project = folder.write("p/project.json", text).string();
  const auto out = folder.path() / "out";
  called(renderStage, {project}, {{"parts", "true"}, {"layers", "true"}}, out.string());
  const std::string file = (out / "card.exr").string();
  const image::XyzImage image = image::readExr(file);
  ASSERT_EQ(image.layers.size(), 2U);
  EXPECT_EQ(image.layers[0].name, "direct");
  EXPECT_EQ(image.layers[1].name, "indirect");
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_NEAR(image.layers[0].y[i], closedForm(4000 + 0.5 * 2000, 0), 0.01 * closedForm(5000, 0));
    EXPECT_GT(image.layers[1].y[i], 0.01F * image.y[i]);
    EXPECT_NEAR(image.layers[0].y[i] + image.layers[1].y[i], image.y[i], 1e-4F * image.y[i]);
  }
  const std::string half = (folder.path() / "half.exr").string();
  called(mixStage, {file + ":direct", file + ":indirect=0.5"}, {}, half);
  const image::XyzImage mixed = image::readExr(half);
  EXPECT_NEAR(mixed.y[7], image.layers[0].y[7] + 0.5F * image.layers[1].y[7], 1e-4F * image.y[7]);
  EXPECT_GT(mixed.halfWidth[7], 0);
  EXPECT_THROW(called(mixStage, {file + ":ambient"}, {}, half), core::InputError);
  EXPECT_EQ(image::readExr((out / "layers/warm/card.exr").string()).layers.size(), 2U);
}

TEST(MixStage, WritesOtherForms) {
  const test::TemporaryFolder folder;
  const std::string project = folder.write("p/project.json", card("1", "0")).string();
  called(renderStage, {project}, {}, folder.path().string());
  const std::string image = (folder.path() / "card.exr").string();
  const float expected = image::readExr(image).y[9];
  for (const auto& [name, form, tolerance] : {std::tuple("a.hdr", "xyze", 0.01F),
                                              {"b.hdr", "rgbe", 0.02F},
                                              {"c.exr", "half", 0.001F},
                                              {"d.exr", "paper", 0.001F}}) {
    const std::string out = (folder.path() / name).string();
    called(mixStage, {image}, {{"form", form}}, out);
    const image::XyzImage back = image::readImage(out);
    EXPECT_NEAR(back.y[9], expected, tolerance * expected) << name;
    EXPECT_EQ(back.attributes.contains(image::viewAttribute), true) << name;
  }
  EXPECT_THROW(called(mixStage, {image}, {{"form", "half"}}, "x.hdr"), core::InputError);
  EXPECT_THROW(called(mixStage, {image}, {}, "x.png"), core::InputError);
  EXPECT_THROW(called(mixStage, {image + "=-1"}, {}, (folder.path() / "x.exr").string()), core::InputError);
}

TEST(GlareStage, RefusesImagesWithoutAView) {
  const test::TemporaryFolder folder;
  image::XyzImage image;
  image.width = image.height = 1;
  image.x = image.y = image.z = {1};
  const std::string path = (folder.path() / "a.exr").string();
  image::writeExr(path, image);
  EXPECT_THROW(called(glareStage, {path}, {}, {}), core::InputError);
  image.attributes[image::viewGeometryAttribute] = "-vtl -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 1 -vv 1";
  image::writeExr(path, image);
  EXPECT_THROW(called(glareStage, {path}, {}, {}), core::InputError) << "an orthographic view has no eye";
}

}  // namespace
}  // namespace goniolux::pipeline
