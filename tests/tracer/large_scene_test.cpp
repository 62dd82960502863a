// Large models and arrays: what they cost. Each test prints its figures; run alone they are the benchmark commands.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "geometry/mesh_import.h"
#include "scene/world.h"
#include "support/temporary_folder.h"
#include "tracer/tracer.h"

namespace goniolux::tracer {
namespace {

using core::Vec3;

double peakGiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024 / 1024;  // Linux counts in KiB
}

class Watch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// What this process has had of a processor: on a machine of its own the same as the time on the wall.
  [[nodiscard]] double cpuSeconds() const { return cpuNow() - cpu_; }

 private:
  static double cpuNow() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double cpu_ = cpuNow();
};

scene::Environment empty() {
  scene::Environment environment;
  material::Material paint;
  paint.name = "paint";
  paint.model = "lambert";
  paint.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0.5);
  environment.materials = {paint};
  return environment;
}

scene::Object wavySheet(int side, double size) {
  scene::Object object;
  object.shape.partNames = {"surface"};
  auto& mesh = object.shape.mesh;
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j)
      mesh.vertices.emplace_back(size * i / side, size * j / side,
                                 0.05 * size * std::sin(9.0 * i / side) * std::cos(7.0 * j / side));
  const auto row = static_cast<std::uint32_t>(side + 1);
  for (std::uint32_t i = 0; i + 1 < row; ++i)
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = i * row + j;
      mesh.triangles.push_back({a, a + row, a + row + 1});
      mesh.triangles.push_back({a, a + row + 1, a + 1});
    }
  mesh.parts.assign(mesh.triangles.size(), 0);
  object.materials = {0};
  return object;
}

TEST(LargeScene, TenThousandInstancesOfTenThousandTrianglesFitInTwoGiB) {
  scene::Environment environment = empty();
  scene::Object sheet = wavySheet(71, 0.5);  // 10 082 triangles
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      if (i == 0 && j == 0) continue;
      core::Mat4 place(1.0);
      place[3] = {0.6 * i, 0.6 * j, 0, 1};
      sheet.copies.push_back(place);
    }
  environment.objects = {sheet};
  const Watch watch;
  const scene::World world = scene::buildWorld(environment);
  const Tracer tracer(world);
  std::printf("10000 instances of %zu triangles: %.2f s, peak %.3f GiB\n", sheet.shape.mesh.triangles.size(),
              watch.seconds(), peakGiB());
  EXPECT_EQ(world.triangles.size(), 0U);
  EXPECT_LT(peakGiB(), 2);
  // The same hit as on the one sheet that stands there.
  scene::Environment alone = empty();
  alone.objects = {wavySheet(71, 0.5)};
  const scene::World single = scene::buildWorld(alone);
  const Tracer reference(single);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 local(0.013 + 0.000473 * k, 0.41 - 0.00031 * k, 1), down = glm::normalize(Vec3(0.1, 0.05, -1));
    const Vec3 shift(0.6 * (k % 100), 0.6 * (k / 10), 0);
    Hit here, there;
    ASSERT_EQ(reference.intersect(local - single.origin, down, here),
              tracer.intersect(local + shift - world.origin, down, there));
    if (here.distance == 0) continue;
    EXPECT_NEAR(here.distance, there.distance, 2e-5);
    EXPECT_GT(glm::dot(here.normal, there.normal), 1 - 1e-2);
    EXPECT_TRUE(tracer.occluded(local + shift - world.origin, down, 2));
  }
}

TEST(LargeScene, AModelOfAMillionTrianglesIsLoadedAndReadyToTrace) {
  goniolux::test::TemporaryFolder folder;
  const std::string file = (folder.path() / "large.obj").string();
  {
    const scene::Object sheet = wavySheet(708, 10);  // 1 002 528 triangles
    std::ofstream out(file);
    for (const Vec3& v : sheet.shape.mesh.vertices) out << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
    for (const auto& t : sheet.shape.mesh.triangles)
      out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  scene::Environment environment = empty();
  scene::Object object;
  const Watch watch;
  object.shape = geometry::importMesh(file, 1, false);
  const double read = watch.seconds();
  object.materials.assign(object.shape.partNames.size(), 0);
  environment.objects.push_back(std::move(object));
  const scene::World world = scene::buildWorld(environment);
  const Tracer tracer(world);
  std::printf("%zu triangles: read %.2f s, ready to trace %.2f s (%.2f s of CPU), peak %.3f GiB\n",
              world.triangles.size(), read, watch.seconds(), watch.cpuSeconds(), peakGiB());
  EXPECT_EQ(world.triangles.size(), 1002528U);
  EXPECT_LT(peakGiB(), 1);
  EXPECT_LT(watch.cpuSeconds(), 5) << "tests may share the machine: the time on the wall is longer";
}

}  // namespace
}  // namespace goniolux::tracer
