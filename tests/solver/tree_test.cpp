// The intersection tree: the gallery of the paper's Table 2, depth control between mirrors, kept trees evaluated anew.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "reflection/fresnel.h"
#include "solver/tree_shadings.h"
#include "support/mirror_scenes.h"

namespace goniolux::solver {
namespace {

using core::Vec3;
using spectrum::SpectralDistribution;
using test::addBall;
using test::addQuad;
using test::flatFinish;
using test::gallery;

struct Figures {
  double mean = 0, discarded = 0, seconds = 0;
  int deepest = 0;
  double image = 0;  // mean of the pixels, every matt surface of luminance 1
};

// Luminance 1 on all matt surfaces and lamps, as the catalogue has it: no light is looked for, nodes are counted.
class White final : public reflection::LocalShading {
 public:
  void addSource(const Vec3&, const Vec3&, double, const reflection::Interface&, float*) const override {}
  void ambientFactor(float* values) const override { values[0] = 1; }
  [[nodiscard]] bool isLit() const override { return false; }
  void reflectedFactor(const Vec3&, const reflection::Interface&, float* values) const override { values[0] = 0; }
  void transmittedFactor(const Vec3&, const reflection::Interface&, float* values) const override { values[0] = 0; }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return 1; }
};

Figures walkGallery(double rho, const TreeControl& control, int step) {
  const scene::Environment environment = gallery(rho);
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
  TreeSettings settings;
  settings.ambient = SpectralDistribution::flat(1);
  Shadings shadings = makeShadings(world, quadrature, settings);
  shadings[0] = std::make_unique<White>();
  const TreeLighting lighting = treeLighting(world, quadrature, settings);
  // No emitters to connect to: what is counted are the nodes of the view.
  const TreeBuilder builder(world, tracer, shadings, 1, 0, control, {1, 1, 1});
  const scene::View view = test::galleryView();
  Figures figures;
  IntersectionTree tree;
  std::uint64_t trees = 0, nodes = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int y = step / 2; y < view.height; y += step)
    for (int x = step / 2; x < view.width; x += step) {
      const scene::ViewRay ray = scene::rayThrough(view, x + 0.5, y + 0.5);
      core::Sampler random(1, static_cast<std::uint32_t>(y * view.width + x));
      builder.build(ray.origin - world.origin, ray.direction, random, tree);
      ++trees;
      nodes += tree.nodes.size();
      figures.deepest = std::max(figures.deepest, tree.deepest);
      figures.discarded += tree.discarded;
      figures.image += evaluate(tree, shadings, lighting, world)[1];
    }
  figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto n = static_cast<double>(trees);
  figures.mean = static_cast<double>(nodes) / n;
  figures.discarded /= n;
  figures.image /= n;
  return figures;
}

// The paper: 14.89 nodes a tree forced to depth 15, 1.71 with adaptive control; 3941 and 480 minutes.
TEST(Gallery, ReproducesTheTreeDepthsOfThePapersTable2) {
  const Figures forced = walkGallery(0.88, {15, 0, false}, 1), adaptive = walkGallery(0.88, {15, 0, true}, 1);
  std::printf("forced %.4f nodes, adaptive %.4f; time %.2f s : %.2f s = %.2f (the paper: 3941 : 480 = 8.21)\n",
              forced.mean, adaptive.mean, forced.seconds, adaptive.seconds, forced.seconds / adaptive.seconds);
  EXPECT_NEAR(forced.mean, 14.890, 0.002);
  EXPECT_NEAR(adaptive.mean, 1.7104, 0.002);
  EXPECT_EQ(forced.deepest, 15);
  EXPECT_EQ(adaptive.deepest, 15);
  EXPECT_NEAR(adaptive.image, 0.92263 * (1 - 0.000095), 1e-4);
  EXPECT_NEAR(forced.image, adaptive.image, 1e-6);  // the same picture
  EXPECT_LE(0.92263 - adaptive.image, adaptive.discarded + 1e-5);
}

TEST(Gallery, CutOffEndsTreesWhereItsBoundSays) {
  const struct {
    double rho, cutoff, nodes;
    int deepest;
    double bias;
  } rows[] = {
      {.5, .1, 1.6332, 4, -.0012}, {.5, .01, 1.6845, 7, 0}, {.7, .1, 1.6845, 7, -.00035}, {.7, .01, 1.7073, 13, 0}};
  for (const auto& row : rows) {
    const Figures cut = walkGallery(row.rho, {15, row.cutoff, true}, 1);
    const Figures whole = walkGallery(row.rho, {60, 0, true}, 1);
    std::printf("rho %.1f cut-off %.2f: %.4f nodes, deepest %d; lost %.5f of %.5f, bound %.5f\n", row.rho, row.cutoff,
                cut.mean, cut.deepest, whole.image - cut.image, whole.image, cut.discarded);
    EXPECT_NEAR(cut.mean, row.nodes, 0.002);
    EXPECT_EQ(cut.deepest, row.deepest);
    EXPECT_LE(whole.image - cut.image, cut.discarded + 1e-6);  // the reported truncation bound holds
    if (row.bias != 0) {
      EXPECT_NEAR(cut.image / whole.image - 1, row.bias, 0.0001);
    }
  }
}

// Two mirrors face each other; a ray between them meets 1 + floor(ln c / ln rho) of them (catalogue, 7.3).
std::size_t nodesBetweenMirrors(double rho, double cutoff, const LuminanceScale& scale) {
  scene::Environment environment;
  environment.sourceSpectra = {SpectralDistribution::flat(1)};
  environment.materials = {flatFinish("mirror", "reflectance", rho)};
  addQuad(environment, {0, -5, -5}, {0, 10, 0}, {0, 0, 10}, 0);
  addQuad(environment, {2, -5, -5}, {0, 10, 0}, {0, 0, 10}, 0);
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const auto quadrature = spectrum::flatQuadrature({SpectralDistribution::flat(1)});
  const Shadings shadings = makeShadings(world, quadrature, {});
  const TreeBuilder builder(world, tracer, shadings, 1, 0, {2000, cutoff, true}, scale);
  IntersectionTree tree;
  core::Sampler random(1, 0);
  builder.build(Vec3(1, 0.1, 0.1) - world.origin, {1, 0, 0}, random, tree);
  return tree.nodes.size();
}

TEST(DepthControl, BetweenMirrorsFollowsTheCutOff) {
  const struct {
    double rho;
    std::array<std::size_t, 4> nodes;  // cut-off 0.1, 0.01, 1/256, 0.001
  } rows[] = {{.5, {4, 7, 9, 10}},
              {.8, {11, 21, 25, 31}},
              {.9, {22, 44, 53, 66}},
              {.95, {45, 90, 109, 135}},
              {.99, {230, 459, 552, 688}}};
  const double cutoffs[] = {.1, .01, 1.0 / 256, .001};
  for (const auto& row : rows)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(nodesBetweenMirrors(row.rho, cutoffs[i], {1, 1, 1}), row.nodes[i]) << row.rho << " " << cutoffs[i];
}

// A lamp 10^4 times brighter than the room: its image in a mirror must not vanish where matt surfaces' may.
TEST(DepthControl, ABrightLampDoesNotVanishFromAMirror) {
  scene::Environment environment;
  environment.sourceSpectra = {SpectralDistribution::flat(1)};
  environment.materials = {flatFinish("mirror", "reflectance", 0.01)};
  addQuad(environment, {0, -5, -5}, {0, 10, 0}, {0, 0, 10}, 0);
  addBall(environment, {2, 0, 0}, 0.1, 1e4);
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
  const Shadings shadings = makeShadings(world, quadrature, {});
  const TreeLighting lighting = treeLighting(world, quadrature, {});
  // The mirror's bound, 0.01, is under the cut-off of 0.02.
  const auto luminance = [&](double lampScale) {
    const TreeBuilder builder(world, tracer, shadings, 1, 0, {15, 0.02, true}, {1, 1, lampScale});
    IntersectionTree tree;
    core::Sampler random(1, 0);
    builder.build(Vec3(1, 0, 0) - world.origin, {-1, 0, 0}, random, tree);
    return evaluate(tree, shadings, lighting, world)[1];
  };
  EXPECT_NEAR(luminance(1e4), 100, 1e-3);
  EXPECT_EQ(luminance(1), 0);  // what a controller that does not know the lamp would show
}

// Glass forced: 2^D - 1 nodes (catalogue, 7.4).
TEST(DepthControl, ForcedTreesOfGlassAreFullBinaryTrees) {
  scene::Environment environment;
  environment.sourceSpectra = {SpectralDistribution::flat(1)};
  material::Material pane = flatFinish("dielectric", "ior", 1.5);
  pane.numbers["thickness_m"] = 0.004;
  environment.materials = {pane};
  for (int side = 0; side < 2; ++side) {  // a box of panes: every ray meets another one
    scene::Object box;
    const double size = 1 + side;
    box.shape = geometry::findObjectType("box")->make({{"min", Vec3(-size)}, {"max", Vec3(size)}});
    box.materials.assign(box.shape.partNames.size(), 0);
    environment.objects.push_back(box);
  }
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const auto quadrature = spectrum::flatQuadrature({SpectralDistribution::flat(1)});
  const Shadings shadings = makeShadings(world, quadrature, {});
  IntersectionTree tree;
  core::Sampler random(1, 0);
  // Rays that leave the outer box meet nothing: a lower bound is counted from the part that stays inside.
  const TreeBuilder builder(world, tracer, shadings, 1, 0, {2, 0, false}, {1, 1, 1});
  builder.build(Vec3(0.1, 0.2, 0.3) - world.origin, glm::normalize(Vec3(1, 0.3, 0.2)), random, tree);
  EXPECT_EQ(tree.nodes.size(), 3u);
  EXPECT_EQ(tree.nodes[0].depth, 1);
  EXPECT_GE(tree.nodes[0].reflected, 1);
  EXPECT_GE(tree.nodes[0].transmitted, 1);
}

// Kept trees for other dimming, other lamp spectra, other reflectances: the same as tracing anew.
TEST(KeptTrees, EvaluateAnewAsAFullRunWould) {
  const auto scene = [](double dimming, double diffuse, const SpectralDistribution& lamp) {
    scene::Environment environment = gallery(0.7);
    environment.sourceSpectra = {lamp};
    environment.materials[0] = flatFinish("lambert", "diffuse", diffuse);
    for (std::size_t i = 0; i < environment.luminaires.size(); ++i)
      environment.luminaires[i].dimming = i % 2 == 0 ? dimming : 1;
    return environment;
  };
  const auto white = SpectralDistribution::flat(1);
  const auto bluish = SpectralDistribution::sampled({{400, 2}, {700, 0.2}}, SpectralDistribution::Outside::zero);
  const auto environments = std::array{scene(1, 0.5, white), scene(0.3, 0.8, bluish)};
  std::array<std::unique_ptr<scene::World>, 2> worlds;
  std::array<std::unique_ptr<tracer::Tracer>, 2> tracers;
  std::array<spectrum::SpectralQuadrature, 2> quadratures;
  std::array<Shadings, 2> shadings;
  std::array<TreeLighting, 2> lightings;
  for (std::size_t i = 0; i < 2; ++i) {
    worlds[i] = std::make_unique<scene::World>(scene::buildWorld(environments[i]));
    tracers[i] = std::make_unique<tracer::Tracer>(*worlds[i]);
    quadratures[i] = spectrum::uniformQuadrature(9, worlds[i]->sourceSpectra);
    shadings[i] = makeShadings(*worlds[i], quadratures[i], {});
    lightings[i] = treeLighting(*worlds[i], quadratures[i], {});
  }
  const TreeControl control{15, 0, true};
  IntersectionTree kept, anew;
  TreeLighting dimmed = lightings[1];
  for (std::size_t e = 0; e < worlds[0]->emitters.size(); ++e) dimmed.dimming.push_back(e % 2 == 0 ? 0.3 : 1);
  for (int i = 0; i < 200; ++i) {
    core::Sampler choice(5, static_cast<std::uint32_t>(i));
    const core::Vec2 u = choice.next2();
    const Vec3 eye = Vec3(6, 2, 2) - worlds[0]->origin,
               direction = glm::normalize(Vec3(2 * u.x - 1, 2 * u.y - 1, choice.next() - 0.5));
    core::Sampler first(9, static_cast<std::uint32_t>(i)), second = first;
    TreeBuilder(*worlds[0], *tracers[0], shadings[0], 9, 4, control, {1, 1, 1}).build(eye, direction, first, kept);
    TreeBuilder(*worlds[1], *tracers[1], shadings[1], 9, 4, control, {1, 1, 1}).build(eye, direction, second, anew);
    const Response a = evaluate(kept, shadings[1], dimmed, *worlds[0]),
                   b = evaluate(anew, shadings[1], lightings[1], *worlds[1]);
    for (std::size_t c = 0; c < a.size(); ++c) EXPECT_NEAR(a[c], b[c], 1e-5 * std::abs(b[c]) + 1e-9);
  }
}

}  // namespace
}  // namespace goniolux::solver
