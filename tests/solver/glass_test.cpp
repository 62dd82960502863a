// Light through glass and water, and reflections of real surfaces, against closed forms (catalogue of validation cases,
// sections 4 and the stress scenes 15, 23, 24).
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/statistics.h"
#include "geometry/objects.h"
#include "reflection/bsdf.h"
#include "reflection/fresnel.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "support/mirror_scenes.h"
#include "tracer/tracer.h"

namespace goniolux::solver {
namespace {

using core::Vec3;
using spectrum::SpectralDistribution;

material::Material finish(const std::string& name, const std::string& model,
                          const std::vector<std::pair<std::string, double>>& spectra,
                          const std::vector<std::pair<std::string, double>>& numbers = {}) {
  material::Material material;
  material.name = name;
  material.model = model;
  for (const auto& [key, value] : spectra) material.spectra[key] = SpectralDistribution::flat(value);
  for (const auto& [key, value] : numbers) material.numbers[key] = value;
  return material;
}

class Scene {
 public:
  Scene() { environment.sourceSpectra = {SpectralDistribution::flat(1)}; }

  std::uint32_t add(material::Material material) {
    environment.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(environment.materials.size() - 1);
  }
  void addQuad(const Vec3& origin, const Vec3& u, const Vec3& v, std::uint32_t material) {
    test::addQuad(environment, origin, u, v, material);
  }
  void addBox(const Vec3& min, const Vec3& max, std::uint32_t material) {
    scene::Object box;
    box.shape = geometry::findObjectType("box")->make({{"min", min}, {"max", max}});
    box.materials.assign(box.shape.partNames.size(), material);
    environment.objects.push_back(box);
  }
  void addPoint(const Vec3& center, double candela) {
    scene::Luminaire lamp;
    lamp.name = lamp.type = "lamp";
    lamp.center = center;
    lamp.flux_lm = 4 * core::pi * candela;
    environment.luminaires.push_back(lamp);
  }
  /// A sphere of uniform luminance.
  void addSphere(const Vec3& center, double diameter, double luminance) {
    scene::Luminaire lamp;
    lamp.name = lamp.type = "ball";
    lamp.center = center;
    lamp.opening = {.shape = emitter::Opening::Shape::sphere, .diameter = diameter};
    lamp.flux_lm = luminance * core::pi * core::pi * diameter * diameter;
    environment.luminaires.push_back(lamp);
  }

  void prepare() {
    world = std::make_unique<scene::World>(scene::buildWorld(environment));
    tracer = std::make_unique<tracer::Tracer>(*world);
    if (quadrature.wavelengths.empty()) quadrature = spectrum::flatQuadrature(world->sourceSpectra);
    solver = findSolverType("path")->make({*world, *tracer, quadrature});
  }
  core::ReplicateMean illuminance(const Vec3& point, const Vec3& normal, std::uint32_t samples,
                                  std::size_t channel = 1) {
    if (!solver) prepare();
    std::vector<double> replicates;
    for (std::uint64_t r = 0; r < 16; ++r) {
      const Receiver receiver{point - world->origin, normal};
      const auto plan = solver->plan(receiver, core::combine(r, 1));
      replicates.push_back(solver->illuminance(receiver, *plan, core::combine(r, 2), samples)[channel]);
    }
    return core::replicateMean(replicates);
  }
  core::ReplicateMean radiance(const Vec3& eye, const Vec3& direction, std::uint32_t samples, std::size_t channel = 1) {
    if (!solver) prepare();
    std::vector<double> replicates;
    for (std::uint64_t r = 0; r < 16; ++r) {
      double sum = 0;
      for (std::uint32_t s = 0; s < samples; ++s)
        sum += solver->radiance(eye - world->origin, glm::normalize(direction), core::combine(r, 3), s)[channel];
      replicates.push_back(sum / samples);
    }
    return core::replicateMean(replicates);
  }

  scene::Environment environment;
  std::unique_ptr<scene::World> world;
  std::unique_ptr<tracer::Tracer> tracer;
  spectrum::SpectralQuadrature quadrature;
  std::unique_ptr<Solver> solver;
};

TEST(ThinPane, LetsThePointSourceThroughAndMirrorsIt) {
  Scene scene;
  const auto pane = scene.add(finish("pane", "dielectric", {{"ior", 1.5}}, {{"thickness_m", 0.004}}));
  scene.addQuad({-2, -2, 1}, {4, 0, 0}, {0, 4, 0}, pane);
  scene.addPoint({0, 0, 2}, 1000);
  // Straight below: I / d^2 times 12/13.
  EXPECT_NEAR(scene.illuminance({0, 0, 0}, {0, 0, 1}, 8).mean, 250 * 12.0 / 13, 1e-3);
  // Above the pane, facing down: the pane shows the lamp's image at z = 0, at 3 m with R = 1/13.
  EXPECT_NEAR(scene.illuminance({0, 0, 3}, {0, 0, -1}, 8).mean, 1000 + 1000.0 / 9 / 13, 1e-2);
  // 45 degrees.
  const double t = reflection::slab(std::sqrt(0.5), 1.5, 0, 0.004).transmittance;
  EXPECT_NEAR(scene.illuminance({2, 0, 0}, {0, 0, 1}, 8).mean, 1000 / 8.0 * std::sqrt(0.5) * t, 1e-3);
}

TEST(ThinPane, AbsorbsAsItsThicknessSays) {
  Scene scene;
  const auto pane =
      scene.add(finish("pane", "dielectric", {{"ior", 1.52}, {"attenuation_per_m", 50}}, {{"thickness_m", 0.006}}));
  scene.addQuad({-2, -2, 1}, {4, 0, 0}, {0, 4, 0}, pane);
  scene.addSphere({0, 0, 3}, 0.02, 1e6);
  const double bare = 1e6 * core::pi * 0.01 * 0.01 / 9;
  const auto e = scene.illuminance({0, 0, 0}, {0, 0, 1}, 64);
  EXPECT_NEAR(e.mean, bare * 0.679750, 1e-4 * bare);
}

// A lamp over water 0.5 m deep, seen from the floor: nadir I T / (h + d/n)^2 = 517.608 lx. A small sphere, and a point.
TEST(Water, FloorUnderALampAgreesWithTheClosedForm) {
  Scene scene;
  const auto water = scene.add(finish("water", "dielectric", {{"ior", 1.33}}));
  const auto black = scene.add(finish("black", "lambert", {{"diffuse", 0}}));
  scene.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, water);
  scene.addQuad({-50, -50, -0.5}, {100, 0, 0}, {0, 100, 0}, black);
  const double diameter = 0.2, luminance = 1000 / (core::pi * 0.25 * diameter * diameter);
  scene.addSphere({0, 0, 1}, diameter, luminance);
  EXPECT_NEAR(scene.illuminance({0, 0, -0.5 + 1e-9}, {0, 0, 1}, 4).mean, 517.608, 0.002 * 517.608);

  Scene point;
  const auto same = point.add(finish("water", "dielectric", {{"ior", 1.33}}));
  const auto bottom = point.add(finish("black", "lambert", {{"diffuse", 0}}));
  point.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, same);
  point.addQuad({-50, -50, -0.5}, {100, 0, 0}, {0, 100, 0}, bottom);
  point.addPoint({0, 0, 1}, 1000);
  EXPECT_NEAR(point.illuminance({0, 0, -0.5 + 1e-9}, {0, 0, 1}, 4).mean, 517.608, 1e-4 * 517.608);
}

// Seen through a clear block, a luminous ceiling keeps its luminance but for the Fresnel losses of both faces:
// (1-R)^2/(1-R^2) at normal incidence, R = 0.04.
TEST(Glass, BlockOfGlassTransmitsAsASlabDoes) {
  Scene scene;
  const auto glass = scene.add(finish("glass", "dielectric", {{"ior", 1.5}}));
  scene.addBox({-3, -3, 1}, {3, 3, 1.2}, glass);
  auto bright = finish("bright", "lambert", {{"diffuse", 0}});
  bright.emission = material::Emission{core::pi * 100, SpectralDistribution::flat(1)};
  scene.addQuad({-100, -100, 3}, {0, 200, 0}, {200, 0, 0}, scene.add(bright));
  const auto l = scene.radiance({0, 0, 0}, {0, 0, 1}, 16384);
  EXPECT_LT(std::abs(l.mean - 100 * 0.96 / 1.04), 4 * l.standardError + 1e-6);
  EXPECT_LT(l.standardError, 0.2);
}

// Bouguer: exp(-a d), along a slanted path d = thickness / cosine of the refracted ray.
TEST(Glass, AbsorbsByTheDistanceInside) {
  Scene scene;
  const auto glass = scene.add(finish("glass", "dielectric", {{"ior", 1.5}, {"attenuation_per_m", 3}}));
  scene.addBox({-3, -3, 1}, {3, 3, 1.2}, glass);
  auto bright = finish("bright", "lambert", {{"diffuse", 0}});
  bright.emission = material::Emission{core::pi * 100, SpectralDistribution::flat(1)};
  scene.addQuad({-100, -100, 3}, {0, 200, 0}, {200, 0, 0}, scene.add(bright));
  const double expected = 100 * reflection::slab(std::sqrt(0.5), 1.5, 3, 0.2).transmittance;
  const auto l = scene.radiance({0, 0, 0}, {1, 0, 1}, 16384);
  // The ray splits without polarisation at each face, so single reflections inside differ a little from the slab's.
  EXPECT_LT(std::abs(l.mean - expected), 4 * l.standardError + 0.01 * expected);
}

// Glass set into water touches water, without air between: R = 0.003608, not 0.0585.
TEST(Glass, OverlappingBodiesMeetWithoutAirBetween) {
  Scene scene;
  const auto water = scene.add(finish("water", "dielectric", {{"ior", 1.33}}));
  const auto glass = scene.add(finish("glass", "dielectric", {{"ior", 1.5}}));
  scene.addBox({-3, -3, 0}, {3, 3, 1}, water);
  scene.addBox({-1, -1, 0.5}, {1, 1, 1.5}, glass);  // half in, half out
  auto bright = finish("bright", "lambert", {{"diffuse", 0}});
  bright.emission = material::Emission{core::pi * 100, SpectralDistribution::flat(1)};
  scene.addQuad({-100, -100, -3}, {200, 0, 0}, {0, 200, 0}, scene.add(bright));
  // Down through the glass block, then the water: three interfaces. Basic radiance is kept, so T of the stack counts.
  const double a = 0.04, b = std::pow(0.17 / 2.83, 2), c = std::pow(0.33 / 2.33, 2);
  const auto both = [](double p, double q) { return p + (1 - p) * (1 - p) * q / (1 - p * q); };
  const double expected = 100 * (1 - both(both(a, b), c));
  const auto l = scene.radiance({0, 0, 2}, {0, 0, -1}, 65536);
  EXPECT_NEAR(b, 0.003608, 1e-6);
  EXPECT_LT(std::abs(l.mean - expected), 4 * l.standardError + 0.02);
  EXPECT_LT(l.standardError, 0.1);
}

// Inside a glass block in a uniform white surround of luminance L, radiance is n^2 L wherever light comes from outside:
// the furnace of two media. Seen from outside the block is invisible.
TEST(Glass, IsInvisibleInAUniformSurround) {
  Scene scene;
  const auto glass = scene.add(finish("glass", "dielectric", {{"ior", 1.5}}));
  scene.addBox({-0.3, -0.4, -0.5}, {0.3, 0.4, 0.5}, glass);
  auto bright = finish("bright", "lambert", {{"diffuse", 0.5}});
  bright.emission = material::Emission{core::pi * 50, SpectralDistribution::flat(1)};
  scene.addBox({-3, -3, -3}, {3, 3, 3}, scene.add(bright));  // L = 50 + 0.5 L
  for (const Vec3 direction : {Vec3(1, 0, 0.02), Vec3(1, 0.1, 0.15)}) {
    const auto l = scene.radiance({-2, 0, 0}, direction, 2048);
    EXPECT_LT(std::abs(l.mean - 100), 4 * l.standardError + 1e-6);
    EXPECT_LT(l.standardError, 1);
  }
}

// A prism of dispersive glass: every wavelength comes out where its index says, and the white light that enters is the
// white light that leaves.
TEST(Dispersion, EachWavelengthBendsByItsOwnIndex) {
  Scene scene;
  material::Material glass = finish("flint", "dielectric", {});
  glass.spectra["ior"] = SpectralDistribution::sampled({{400, 1.9}, {700, 1.5}}, SpectralDistribution::Outside::hold);
  scene.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, scene.add(glass));  // a half space below z = 0
  // The lower half space is bright only where blue light comes from.
  auto bright = finish("bright", "lambert", {{"diffuse", 0}});
  bright.emission = material::Emission{core::pi * 100, SpectralDistribution::flat(1)};
  // Eye at 45 degrees: sin t = sin 45 / n: at depth 1 the ray is at tan t: 0.4008 (n 1.9), 0.5345 (n 1.5).
  scene.addQuad({0.3, -50, -1}, {0.14, 0, 0}, {0, 100, 0}, scene.add(bright));
  scene.environment.sourceSpectra = {SpectralDistribution::flat(1)};
  scene.quadrature = spectrum::uniformQuadrature(9, scene.environment.sourceSpectra);
  scene.prepare();
  const auto Y = scene.radiance({-1, 0, 1}, {1, 0, -1}, 4096, 1), Z = scene.radiance({-1, 0, 1}, {1, 0, -1}, 4096, 2);
  double expectedY = 0, expectedZ = 0;
  for (std::size_t k = 0; k < 9; ++k) {
    const double nm = scene.quadrature.wavelengths[k], n = 1.9 - 0.4 * (nm - 400) / 300;
    const double sine = std::sqrt(0.5) / n, x = sine / std::sqrt(1 - sine * sine);
    if (x < 0.3 || x > 0.44) continue;
    const double t = 1 - reflection::dielectricReflectance(std::sqrt(0.5), n).mean();
    expectedY += 100 * t / (n * n) * scene.quadrature.weights[0][k][1];
    expectedZ += 100 * t / (n * n) * scene.quadrature.weights[0][k][2];
  }
  EXPECT_GT(expectedZ, 3 * expectedY);  // it is blue
  EXPECT_LT(std::abs(Y.mean - expectedY), 4 * Y.standardError + 1e-6);
  EXPECT_LT(std::abs(Z.mean - expectedZ), 4 * Z.standardError + 1e-6);
  EXPECT_LT(Z.standardError, 0.05 * expectedZ);
}

// A light guide 10 mm square, 1 m long, entered at 45 degrees inside: total reflection loses nothing over 53
// reflections.
TEST(Glass, LightGuideLosesNothingByTotalReflection) {
  Scene scene;
  const auto glass = scene.add(finish("glass", "dielectric", {{"ior", 1.5}}));
  scene.addBox({0, -0.005, -0.005}, {1, 0.005, 0.005}, glass);
  auto bright = finish("bright", "lambert", {{"diffuse", 0}});
  bright.emission = material::Emission{core::pi * 100, SpectralDistribution::flat(1)};
  scene.addQuad({1.1, -30, -30}, {0, 60, 0}, {0, 0, 60}, scene.add(bright));
  // From outside through the end face: refracted angle t, then total reflections to the other end, same face angle.
  const Vec3 direction(std::cos(60 * core::degree), 0, std::sin(60 * core::degree));
  const double r = reflection::dielectricReflectance(std::cos(60 * core::degree), 1.5).mean();
  const auto l = scene.radiance(Vec3(0, 0, 0) - direction * 0.002, direction, 2048);
  EXPECT_LT(std::abs(l.mean - 100 * (1 - r) / (1 + r)), 4 * l.standardError + 0.5);
}

// A body that loses no light cannot be seen in a uniform surround, whatever its finish: the furnace through the whole
// solver, with emitters found both by connections and by sampled directions.
TEST(Finishes, ThatLoseNoLightAreInvisibleInAUniformSurround) {
  const struct {
    const char* name;
    material::Material material;
  } cases[] = {
      {"rough metal", finish("metal", "conductor", {{"ior", 1e-4}, {"k", 1e5}}, {{"roughness", 0.3}})},
      {"nearly smooth metal", finish("metal", "conductor", {{"ior", 1e-4}, {"k", 1e5}}, {{"roughness", 0.05}})},
      {"rough glass", finish("frosted", "dielectric", {{"ior", 1.5}}, {{"roughness", 0.4}})},
      {"opal film", finish("film", "diffuse-transmission", {{"diffuse", 0.3}, {"transmission", 0.7}})},
      {"chalk", finish("chalk", "oren-nayar", {{"diffuse", 1}}, {{"roughness", 0.8}})},
  };
  for (const auto& c : cases) {
    Scene scene;
    scene.addBox({-0.3, -0.4, -0.5}, {0.3, 0.4, 0.5}, scene.add(c.material));
    auto bright = finish("bright", "lambert", {{"diffuse", 0.5}});
    bright.emission = material::Emission{core::pi * 50, SpectralDistribution::flat(1)};
    scene.addBox({-3, -3, -3}, {3, 3, 3}, scene.add(bright));  // L = 50 + 0.5 L
    const auto l = scene.radiance({-2, 0, 0}, {1, 0.1, 0.15}, 512);
    EXPECT_LT(std::abs(l.mean - 100), 4 * l.standardError + 0.1) << c.name << " " << l.mean;
    EXPECT_LT(l.standardError, 1) << c.name;
  }
}

// A lamp's reflection in a rough metal plate against the integral over the lamp of the model's own value.
TEST(Finishes, ALampInARoughMetalPlateHasTheLuminanceOfTheIntegralOverIt) {
  for (const double alpha : {0.02, 0.1, 0.3, 0.9}) {
    Scene scene;
    const auto metal = finish("metal", "conductor", {{"ior", 0.96}, {"k", 6.69}}, {{"roughness", alpha}});
    scene.addQuad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, scene.add(metal));
    const Vec3 lamp(1, 0, 2);
    const double radius = 0.2, luminance = 1000;
    scene.addSphere(lamp, 2 * radius, luminance);
    const Vec3 out = glm::normalize(Vec3(-1.1, 0.1, 2));
    const auto l = scene.radiance(out * 0.5, -out, 4096);
    // Midpoint rule over the cone in which the sphere is seen.
    const auto bsdf = reflection::findReflectionModel("conductor")->make(metal, scene.quadrature);
    const double distance = glm::length(lamp), most = 1 - std::sqrt(1 - radius * radius / (distance * distance));
    core::Frame frame;
    frame.z = lamp / distance;
    core::perpendiculars(frame.z, frame.x, frame.y);
    double sum = 0;
    constexpr int rows = 300, columns = 600;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        const double z = 1 - most * (i + 0.5) / rows, angle = 2 * core::pi * (j + 0.5) / columns,
                     r = std::sqrt(1 - z * z);
        const Vec3 in = frame.toWorld({r * std::cos(angle), r * std::sin(angle), z});
        float f = 0;
        bsdf->evaluate(out, in, {}, &f);
        sum += static_cast<double>(f) * in.z * luminance * 2 * core::pi * most / (rows * columns);
      }
    EXPECT_LT(std::abs(l.mean - sum), 4 * l.standardError + 0.002 * sum) << alpha << ": " << l.mean << " and " << sum;
    EXPECT_LT(l.standardError, 0.02 * sum + 0.01) << alpha;
  }
}

}  // namespace
}  // namespace goniolux::solver
