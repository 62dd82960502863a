// A proof of free view must never be wrong, and must be found where nothing is near.
#include "solver/free_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "geometry/objects.h"
#include "scene/environment.h"
#include "tracer/tracer.h"

namespace goniolux::solver {
namespace {

using core::Vec3;

scene::Environment furnishedRoom(int boxes) {
  scene::Environment environment;
  material::Material paint;
  paint.name = "paint";
  paint.model = "lambert";
  paint.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0.5);
  environment.materials = {paint};
  environment.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
  const auto add = [&](const Vec3& low, const Vec3& high) {
    scene::Object object;
    object.shape = geometry::findObjectType("box")->make({{"min", low}, {"max", high}});
    object.materials.assign(object.shape.partNames.size(), 0);
    environment.objects.push_back(object);
  };
  add(Vec3(0), Vec3(6, 4, 3));
  for (int i = 0; i < boxes; ++i) {
    core::Sampler random(77, static_cast<std::uint32_t>(i));
    const core::Vec2 xy = random.next2(), size = random.next2();
    const Vec3 low(5 * xy.x, 3 * xy.y, 1.8 * random.next());
    add(low, low + Vec3(0.1 + 0.7 * size.x, 0.1 + 0.7 * size.y, 0.1 + 0.5 * random.next()));
  }
  scene::Object ball;
  ball.shape = geometry::findObjectType("sphere")->make({{"center", Vec3(3, 2, 1.2)}, {"radius", 0.3}});
  ball.materials.assign(ball.shape.partNames.size(), 0);
  if (boxes > 0) environment.objects.push_back(ball);
  for (int i = 0; i < 4; ++i) {
    scene::Luminaire panel;
    panel.name = panel.type = "panel";
    panel.center = {1.5 + 3 * (i % 2), 1 + 2 * (i / 2), 3};
    panel.frame.aim = {0, 0, -1};
    panel.opening = {.shape = emitter::Opening::Shape::rectangle, .length = 0.6, .width = 0.6};
    panel.flux_lm = 1000;
    environment.luminaires.push_back(panel);
  }
  return environment;
}

struct Count {
  int proofs = 0, wrong = 0, seenWhole = 0, pairs = 0;
};

Count compare(const scene::Environment& environment) {
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const FreeView view(world);
  Count count;
  for (std::uint32_t i = 0; i < 400; ++i) {
    core::Sampler random(5, i);
    const core::Vec2 xy = random.next2();
    const Vec3 point = Vec3(0.05 + 5.9 * xy.x, 0.05 + 3.9 * xy.y, 0.02 + 2.5 * random.next()) - world.origin;
    for (std::uint32_t e = 0; e < world.emitters.size(); ++e) {
      const bool proof = view.isFree(point, world.emitters[e].bounds, e);
      int blocked = 0;
      for (std::uint32_t k = 0; k < 256; ++k) {
        core::Sampler aim(core::combine(i, e), k);
        const auto light = world.emitters[e].emitter->sample(point, aim.next2());
        blocked += tracer.occluded(point, light.direction, light.distance * (1 - 1e-5) - tracer.slack());
      }
      ++count.pairs;
      count.proofs += proof;
      count.seenWhole += blocked == 0;
      count.wrong += proof && blocked > 0;
    }
  }
  return count;
}

TEST(FreeView, IsProvenForEveryPointOfAnEmptyRoom) {
  const Count count = compare(furnishedRoom(0));
  EXPECT_EQ(count.wrong, 0);
  EXPECT_EQ(count.proofs, count.pairs);
}

TEST(FreeView, IsNeverProvenWhereARayIsBlockedAndMostlyFoundWhereNoneIs) {
  const Count count = compare(furnishedRoom(12));
  EXPECT_EQ(count.wrong, 0);
  EXPECT_LT(count.seenWhole, count.pairs) << "the furniture blocks nothing: this test would prove nothing";
  EXPECT_GT(count.proofs, 0.8 * count.seenWhole);
}

}  // namespace
}  // namespace goniolux::solver
