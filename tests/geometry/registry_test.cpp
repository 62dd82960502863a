// What the registry of object types promises, for every entry: a newcomer cannot escape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "geometry/inside.h"
#include "geometry/mesh_checks.h"
#include "geometry/objects.h"
#include "geometry/quadric_intersect.h"
#include "geometry/queries.h"
#include "geometry/samples.h"
#include "geometry/tessellate.h"
#include "support/temporary_folder.h"

namespace goniolux::geometry {
namespace {

using core::Mat4;
using core::Vec3;

class Registry : public ::testing::Test {
 protected:
  void forEachSample(const std::function<void(const test::Sample&, const ObjectType&, const Shape&)>& check) {
    for (const test::Sample& sample : test::samples(folder_.path())) {
      SCOPED_TRACE(sample.type + ": " + sample.title);
      const ObjectType* type = findObjectType(sample.type);
      ASSERT_NE(type, nullptr);
      check(sample, *type, type->make(sample.arguments));
    }
  }

 private:
  goniolux::test::TemporaryFolder folder_;
};

// A similarity with a rotation, and the same with a mirror.
Mat4 placed(double scale, bool mirrored) {
  Mat4 map{1.0};
  map[0] = scale * glm::dvec4(0.36, 0.48, -0.8, 0);
  map[1] = scale * glm::dvec4(-0.8, 0.6, 0, 0);
  map[2] = scale * glm::dvec4(0.48, 0.64, 0.6, 0) * (mirrored ? -1.0 : 1.0);
  map[3] = {-7, 11, 5, 1};
  return map;
}

TEST_F(Registry, EveryTypeHasASampleATitleAndHelpForEachKey) {
  goniolux::test::TemporaryFolder folder;
  const auto samples = test::samples(folder.path());
  std::set<std::string> names;
  for (const ObjectType& type : objectTypes()) {
    EXPECT_TRUE(names.insert(type.name).second) << type.name << " is registered twice";
    EXPECT_FALSE(type.title.empty()) << type.name;
    EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [&](const auto& s) { return s.type == type.name; }))
        << type.name << " has no sample in tests/geometry/samples.cpp";
    std::set<std::string> keys;
    for (const core::Parameter& parameter : type.parameters) {
      EXPECT_TRUE(keys.insert(parameter.key).second) << type.name << "." << parameter.key;
      EXPECT_FALSE(parameter.title.empty() || parameter.help.empty()) << type.name << "." << parameter.key;
      EXPECT_FALSE(parameter.required && !parameter.defaultText.empty()) << type.name << "." << parameter.key;
    }
    for (const auto& [group, parts] : type.partGroups) {
      EXPECT_EQ(std::count(type.parts.begin(), type.parts.end(), group), 0) << group;
      for (const auto& part : parts) EXPECT_EQ(std::count(type.parts.begin(), type.parts.end(), part), 1) << part;
    }
  }
}

TEST_F(Registry, PartsCoverEveryFaceAndAreNamedAsPromised) {
  forEachSample([](const test::Sample&, const ObjectType& type, const Shape& shape) {
    ASSERT_FALSE(shape.partNames.empty());
    if (!type.parts.empty()) {
      EXPECT_EQ(shape.partNames, type.parts);
    }
    ASSERT_EQ(shape.mesh.parts.size(), shape.mesh.triangles.size());
    for (const auto part : shape.mesh.parts) ASSERT_LT(part, shape.partNames.size());
    for (const auto& patch : shape.patches) ASSERT_LT(patch.part, shape.partNames.size());
    for (const auto& t : shape.mesh.triangles) {
      for (const auto vertex : t) ASSERT_LT(vertex, shape.mesh.vertices.size());
      ASSERT_FALSE(isDegenerate(shape.mesh.vertices[t[0]], shape.mesh.vertices[t[1]], shape.mesh.vertices[t[2]]));
    }
  });
}

TEST_F(Registry, AreasAreThoseOfTheClosedForms) {
  forEachSample([](const test::Sample& sample, const ObjectType&, const Shape& shape) {
    EXPECT_NEAR(area(shape), sample.area, sample.tolerance * sample.area);
    EXPECT_NEAR(area(shape, placed(0.01, false)), 1e-4 * sample.area,
                1e-4 * sample.tolerance * sample.area + 1e-15 * sample.area);
    EXPECT_NEAR(area(shape, placed(2, true)), 4 * sample.area, 10 * sample.tolerance * sample.area);
  });
}

TEST_F(Registry, ClosedShapesEncloseTheirVolumeAndFaceOutward) {
  forEachSample([](const test::Sample& sample, const ObjectType& type, const Shape& shape) {
    EXPECT_EQ(shape.closed, sample.volume > 0);
    if (type.isClosed) {
      EXPECT_TRUE(shape.closed);
    }
    if (!shape.closed) return;
    EXPECT_NEAR(volume(shape), sample.volume, sample.tolerance * sample.volume);
    EXPECT_NEAR(volume(shape, placed(2, true)), 8 * sample.volume, 10 * sample.tolerance * sample.volume);
    EXPECT_LT(glm::length(vectorArea(shape)), sample.tolerance * sample.area);
    EXPECT_LT(glm::length(vectorArea(shape, placed(3, true))), 10 * sample.tolerance * sample.area);
    if (shape.patches.empty()) {
      EXPECT_TRUE(checkEdges(shape.mesh).watertight());
    }
  });
}

TEST_F(Registry, BoundsHoldEveryPointOfTheSurface) {
  forEachSample([](const test::Sample&, const ObjectType&, const Shape& shape) {
    const Mat4 map = placed(1.5, true);
    const Bounds box = bounds(shape, map);
    const auto expectInside = [&](const Vec3& p) {
      EXPECT_TRUE(box.contains(Vec3(map * glm::dvec4(p, 1)), 1e-12)) << p.x << ' ' << p.y << ' ' << p.z;
    };
    for (const auto& t : shape.mesh.triangles) {
      for (const auto vertex : t) expectInside(shape.mesh.vertices[vertex]);
    }
    for (const auto& patch : shape.patches) {
      for (const Vec3& p : tessellate(patch, 32).vertices) expectInside(p);
    }
  });
}

TEST_F(Registry, TheShareOfRandomPointsInsideIsTheShareOfVolume) {
  forEachSample([](const test::Sample& sample, const ObjectType&, const Shape& shape) {
    const Mat4 map = placed(1, true);
    const InsideTest inside(shape, map);
    const Bounds box = bounds(shape, map);
    constexpr int count = 20'000;
    int found = 0;
    // Kronecker sequence with the plastic number: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences"
    // (2018).
    for (int i = 0; i < count; ++i) {
      const double a = 0.8191725133961645, b = 0.6710436067037893, c = 0.5497004779019703;
      const Vec3 unit(std::fmod(0.5 + a * i, 1.0), std::fmod(0.5 + b * i, 1.0), std::fmod(0.5 + c * i, 1.0));
      found += inside.contains(box.min + unit * box.extent());
    }
    const Vec3 extent = box.extent();
    const double whole = extent.x * extent.y * extent.z, share = sample.volume / whole;
    // Independent points would scatter by one sigma = sqrt(p (1 - p) / n); five of them is ample for a sequence.
    EXPECT_NEAR(found / double(count), share, 5 * std::sqrt(share * (1 - share) / count));
  });
}

}  // namespace
}  // namespace goniolux::geometry
