// Textures, smooth normals and reliefs: what they do to light, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "core/statistics.h"
#include "geometry/mesh_checks.h"
#include "geometry/objects.h"
#include "geometry/queries.h"
#include "geometry/smooth_normals.h"
#include "geometry/tessellate.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "texture/texture.h"
#include "tracer/tracer.h"

namespace goniolux::solver {
namespace {

using core::Vec3;
using spectrum::SpectralDistribution;

constexpr double flux = 1000, dark = 0.2, light = 0.8;

material::Material matt(double reflectance) {
  material::Material material;
  material.name = "paint";
  material.model = "lambert";
  material.spectra["diffuse"] = SpectralDistribution::flat(reflectance);
  return material;
}

/// A closed room of radius 2 m about the origin with a lamp in its middle.
class RoundRoom {
 public:
  explicit RoundRoom(geometry::Shape shape, const std::string& solverName = "path") : solverName_(solverName) {
    environment.sourceSpectra = {SpectralDistribution::flat(1)};
    environment.materials = {matt(0.5)};
    scene::Object room;
    room.facesInward = true;
    room.materials.assign(shape.partNames.size(), 0);
    room.shape = std::move(shape);
    environment.objects = {room};
    scene::Luminaire lamp;
    lamp.name = lamp.type = "lamp";
    lamp.center = Vec3(0, 0, 1e-9);
    lamp.flux_lm = flux;
    environment.luminaires = {lamp};
  }
  void setTexture(const std::string& pattern, const texture::Projection& projection) {
    material::Material& finish = environment.materials.front();
    finish.components = {matt(dark), matt(light)};
    environment.textures = {
        std::make_shared<texture::PatternTexture>(projection, texture::findPatternType(pattern)->make({}))};
    finish.texture = 0;
    finish.shares = environment.textures.front()->meanShares();
    finish.spectra["diffuse"] = SpectralDistribution::flat(finish.shares[0] * dark + finish.shares[1] * light);
  }
  void prepare() {
    if (solver) return;
    world = std::make_unique<scene::World>(scene::buildWorld(environment));
    tracer = std::make_unique<tracer::Tracer>(*world);
    quadrature = spectrum::flatQuadrature(world->sourceSpectra);
    solver = findSolverType(solverName_)->make({*world, *tracer, quadrature});
  }
  /// On the wall in a direction, seen from the middle.
  [[nodiscard]] tracer::Hit wallAt(const Vec3& direction) {
    prepare();
    tracer::Hit hit;
    EXPECT_TRUE(tracer->intersect(-world->origin, direction, hit));
    return hit;
  }
  double illuminance(const tracer::Hit& at, std::uint64_t key, std::uint32_t samples) {
    const Receiver receiver{at.position, -at.normal};
    const auto plan = solver->plan(receiver, core::combine(key, 1));
    double value = solver->illuminance(receiver, *plan, core::combine(key, 2), samples)[1];
    if (!solver->isUnbiased()) {
      double missed = 0;
      for (std::uint32_t s = 0; s < samples; ++s)
        missed += solver->missed(receiver, core::combine(key, 3), s)[1] / samples;
      value += missed;
    }
    return value;
  }
  double luminance(const Vec3& direction, std::uint64_t key, std::uint32_t samples) {
    prepare();
    double sum = 0;
    for (std::uint32_t s = 0; s < samples; ++s)
      sum += solver->radiance(-world->origin, direction, core::combine(key, 4), s)[1] / samples;
    return sum;
  }

  scene::Environment environment;
  std::unique_ptr<scene::World> world;
  std::unique_ptr<tracer::Tracer> tracer;
  spectrum::SpectralQuadrature quadrature;
  std::unique_ptr<Solver> solver;

 private:
  std::string solverName_;
};

Vec3 direction(std::uint64_t key, std::uint32_t i) {
  core::Sampler random(key, i);
  const core::Vec2 u = random.next2();
  const double z = 1 - 2 * u.x, r = std::sqrt(1 - z * z), angle = 2 * core::pi * u.y;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

geometry::Shape ball() {
  return geometry::findObjectType("sphere")->make({{"center", Vec3(0)}, {"radius", 2.0}});
}
const double area = 4 * core::pi * 4;

// In a sphere every element of the wall sends every other the same share of its light, whatever its reflectance: with a
// lamp in the middle the illuminance is phi / (A (1 - mean reflectance)) everywhere, exactly.
TEST(Texture, OfASphereGivesTheIlluminanceOfItsMeanReflectance) {
  for (const char* solver : {"path", "gather"})
    for (const char* pattern : {"stripes", "checker"}) {
      SCOPED_TRACE(std::string(solver) + " " + pattern);
      RoundRoom room(ball(), solver);
      // Whole repeats over u and v; rings of equal height, not equal area, for v: stripes run along v.
      room.setTexture(pattern, {.mapping = texture::Projection::Mapping::uv, .size = {1.0 / 6, 0.5}});
      const double expected = flux / area / (1 - 0.5 * (dark + light));
      std::vector<double> replicates;
      for (std::uint64_t r = 0; r < 16; ++r) {
        double sum = 0;
        for (std::uint32_t i = 0; i < 16; ++i)
          sum += room.illuminance(room.wallAt(direction(r, i)), core::combine(r, i), 256) / 16;
        replicates.push_back(sum);
      }
      const auto mean = core::replicateMean(replicates);
      EXPECT_NEAR(mean.mean, expected, 4.1 * mean.standardError);  // by chance once in a thousand
      EXPECT_LT(mean.standardError, 0.01 * expected);
    }
}

TEST(Texture, IsSeenWhereItIs) {
  for (const char* solver : {"path", "gather"}) {
    SCOPED_TRACE(solver);
    RoundRoom room(ball(), solver);
    room.setTexture("stripes", {.mapping = texture::Projection::Mapping::uv, .size = {1.0 / 6, 1}});
    const double e = flux / area / (1 - 0.5 * (dark + light));
    for (const double turn : {0.04, 0.3, 0.63, 0.9}) {
      const double phi = 2 * core::pi * turn;
      const Vec3 d(std::cos(phi) * 0.8, std::sin(phi) * 0.8, 0.6);
      const bool isStripe = turn * 6 - std::floor(turn * 6) < 0.5;
      std::vector<double> replicates;
      for (std::uint64_t r = 0; r < 16; ++r) replicates.push_back(room.luminance(d, r, 128));
      const auto mean = core::replicateMean(replicates);
      const double expected = (isStripe ? light : dark) * e / core::pi;
      EXPECT_NEAR(mean.mean, expected, std::max(4.1 * mean.standardError, 0.01 * expected)) << turn;
    }
  }
}

geometry::Shape tessellatedBall(bool isSmooth) {
  geometry::Shape shape;
  shape.partNames = {"surface"};
  shape.mesh = geometry::tessellate(ball(), 12);
  shape.closed = true;
  geometry::mergeVertices(shape.mesh, 1e-9);
  geometry::removeDegenerateTriangles(shape.mesh);
  if (isSmooth) geometry::addSmoothNormals(shape.mesh, core::pi);
  return shape;
}

// A room of flat triangles that are to look round: its illuminance is that of the triangles, to the last bit, with mean
// phi / (A_mesh (1 - rho)).
TEST(SmoothNormals, ChangeNoPhotometricNumberOfATessellatedSphere) {
  RoundRoom flat(tessellatedBall(false)), smooth(tessellatedBall(true));
  flat.prepare();
  smooth.prepare();
  const double meshArea = geometry::area(flat.environment.objects.front().shape);
  EXPECT_LT(meshArea, 0.98 * area) << "coarse enough to matter";
  std::vector<double> replicates;
  for (std::uint64_t r = 0; r < 16; ++r) {
    double sum = 0;
    constexpr std::uint32_t points = 256;
    for (std::uint32_t i = 0; i < points; ++i) {
      // Evenly over the mesh: triangles by area.
      const auto& t = flat.world->triangles;
      core::Sampler random(core::combine(r, 77), i);
      double pick = random.next() * meshArea;
      std::size_t k = 0;
      const auto corner = [&](std::size_t c) { return flat.world->vertices[t[k][c]]; };
      const auto areaOf = [&] { return 0.5 * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))); };
      for (; k + 1 < t.size() && pick >= areaOf(); ++k) pick -= areaOf();
      const core::Vec2 u = random.next2();
      const double root = std::sqrt(u.x);
      tracer::Hit at;
      at.position = corner(0) * (1 - root) + corner(1) * (root * (1 - u.y)) + corner(2) * (root * u.y);
      at.normal = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
      const double e = flat.illuminance(at, core::combine(r, i), 32);
      EXPECT_EQ(e, smooth.illuminance(at, core::combine(r, i), 32));
      sum += e / points;
    }
    replicates.push_back(sum);
  }
  const auto mean = core::replicateMean(replicates);
  std::printf("tessellated sphere: mean %.3f +- %.3f lx, phi/(A(1-rho)) = %.3f lx\n", mean.mean, mean.standardError,
              flux / meshArea / 0.5);
  EXPECT_NEAR(mean.mean, flux / meshArea / 0.5, 4.1 * mean.standardError);
}

// What is seen: over all directions the mean luminance of the smooth room is that of the flat one, and it varies less.
TEST(SmoothNormals, MakeAPictureRoundWithoutMakingItBrighter) {
  double means[2], scatter[2];
  for (const bool isSmooth : {false, true}) {
    RoundRoom room(tessellatedBall(isSmooth));
    double sum = 0, squares = 0;
    constexpr std::uint32_t rays = 4096;
    for (std::uint32_t i = 0; i < rays; ++i) {
      const double value = room.luminance(direction(5, i), i, 16);
      sum += value / rays;
      squares += value * value / rays;
    }
    means[isSmooth] = sum;
    scatter[isSmooth] = std::sqrt(squares - sum * sum) / sum;
  }
  std::printf("seen from the middle: flat %.3f cd/m2, spread %.2f %%; smooth %.3f cd/m2, spread %.2f %%\n", means[0],
              100 * scatter[0], means[1], 100 * scatter[1]);
  EXPECT_NEAR(means[1] / means[0], 1, 0.02);
  EXPECT_LT(scatter[1], scatter[0]);
}

// In even light a matt surface looks the same however it leans: the gain makes up for what lies behind the horizon.
TEST(Relief, LosesAndGainsNothingInEvenLight) {
  RoundRoom room(ball());
  room.environment.luminaires.clear();
  room.environment.materials.front().emission = material::Emission{100 * core::pi, SpectralDistribution::flat(1)};
  // A flat plate in the middle of an evenly bright sphere.
  room.environment.materials.push_back(matt(0.5));
  room.environment.materials.back().relief = 0;
  room.environment.reliefs = {std::make_shared<const texture::Relief>(
      texture::Relief{{.size = {0.02, 0.02}}, texture::findPatternType("noise")->make({}), 0.01})};
  scene::Object plate;
  plate.shape = geometry::findObjectType("rectangle")
                    ->make({{"origin", Vec3(-0.01, -0.01, -0.5)}, {"u", Vec3(0.02, 0, 0)}, {"v", Vec3(0, 0.02, 0)}});
  plate.materials = {1};
  room.environment.objects.push_back(plate);
  // An emitting ball is triangles: the tessellated one.
  room.environment.objects.front().shape = tessellatedBall(false);
  room.environment.materials.front().spectra["diffuse"] = SpectralDistribution::flat(0);
  room.prepare();
  double leaning = 0;
  std::vector<double> replicates(16, 0.0);
  for (std::uint32_t i = 0; i < 64; ++i) {
    core::Sampler random(8, i);
    const core::Vec2 u = random.next2();
    const Vec3 d = glm::normalize(Vec3(0.018 * (u.x - 0.5), 0.018 * (u.y - 0.5), -0.5));
    const tracer::Hit hit = room.wallAt(d);
    leaning += glm::dot(scene::shownNormal(*room.world, hit, hit.normal, -d), hit.normal) < 0.99;
    for (std::uint64_t r = 0; r < 16; ++r) replicates[r] += room.luminance(d, core::combine(r, i), 64) / 64;
  }
  EXPECT_GT(leaning, 32) << "a relief that can be seen";
  const auto mean = core::replicateMean(replicates);
  EXPECT_NEAR(mean.mean, 50, std::max(4.1 * mean.standardError, 0.1));
}

}  // namespace
}  // namespace goniolux::solver
