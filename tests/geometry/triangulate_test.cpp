// Polygons with holes become triangles whose areas add up, whatever the order and direction of the rings; bad ones are
// named.
#include "geometry/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "geometry/polygon.h"
#include "geometry/polyhedron.h"
#include "geometry/queries.h"

namespace goniolux::geometry {
namespace {

using core::Vec2;
using core::Vec3;
using Rings = std::vector<std::vector<Vec2>>;

double signedArea(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

// Areas add up, every triangle is counter-clockwise, every vertex is used, inner edges pair up and outer ones are the
// rings'.
void expectTriangulated(const Rings& rings) {
  std::vector<Vec2> points;
  for (const auto& ring : rings) points.insert(points.end(), ring.begin(), ring.end());
  double expected = std::abs(signedArea(rings[0])), sum = 0;
  for (std::size_t r = 1; r < rings.size(); ++r) expected -= std::abs(signedArea(rings[r]));
  const auto triangles = triangulate(rings);
  EXPECT_EQ(triangles.size(), points.size() + 2 * (rings.size() - 1) - 2) << "Euler";
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> used;
  for (const auto& t : triangles) {
    const double area = signedArea({points[t[0]], points[t[1]], points[t[2]]});
    EXPECT_GT(area, 0);
    sum += area;
    for (unsigned k = 0; k < 3; ++k) {
      used.insert(t[k]);
      edges[std::minmax(t[k], t[(k + 1) % 3])] += 1;
    }
  }
  EXPECT_NEAR(sum, expected, 1e-12 * std::abs(signedArea(rings[0])));
  EXPECT_EQ(used.size(), points.size());
  const auto borders = std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second == 1; });
  const auto shared = std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second == 2; });
  EXPECT_EQ(static_cast<std::size_t>(borders), points.size());
  EXPECT_EQ(static_cast<std::size_t>(borders + shared), edges.size());
}

std::string refusal(const Rings& rings) {
  try {
    triangulate(rings);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

std::vector<Vec2> block(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

TEST(Triangulation, CutsConcaveOutlinesEitherWayRound) {
  std::vector<Vec2> comb;
  for (int i = 0; i < 20; ++i) comb.insert(comb.end(), {{2.0 * i, 0}, {2.0 * i + 1, 5}});
  comb.insert(comb.end(), {{40, 0}, {40, -1}, {0, -1}});
  expectTriangulated({comb});
  std::reverse(comb.begin(), comb.end());
  expectTriangulated({comb});
}

TEST(Triangulation, KeepsVerticesInTheMiddleOfStraightEdges) {
  expectTriangulated({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {0, 2}, {0, 1}}});
  expectTriangulated({{{0, 0}, {1, 0}, {2, 0}, {0, 2}}});
}

TEST(Triangulation, JoinsManyHolesAlsoInRowsAndBehindEachOther) {
  Rings rings{square};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) rings.push_back(block(1 + 2.25 * i, 1 + 2.25 * j, 1.2));
  }
  expectTriangulated(rings);
  std::reverse(rings[5].begin(), rings[5].end());
  expectTriangulated(rings);
}

TEST(Triangulation, HoldsForRandomStarsWithRandomHoles) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int round = 0; round < 300; ++round) {
    Rings rings(1);
    const int corners = 5 + round % 40;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * core::pi * (i + 0.8 * uniform(generator)) / corners,
                   radius = 6 + 20 * uniform(generator);
      rings[0].emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    // Holes in cells of a 3 x 3 grid well inside radius 6 - only where the star holds the disc of that size.
    if (corners >= 20) {
      for (int cell = 0; cell < 9; ++cell) {
        if (uniform(generator) < 0.3) continue;
        std::vector<Vec2> hole;
        const int sides = 3 + cell % 5;
        for (int i = 0; i < sides; ++i) {
          const double angle = 2 * core::pi * (i + 0.9 * uniform(generator)) / sides;
          hole.emplace_back(2.0 * (cell % 3 - 1) + 0.9 * std::cos(angle), 2.0 * (cell / 3 - 1) + 0.9 * std::sin(angle));
        }
        rings.push_back(hole);
      }
    }
    SCOPED_TRACE(round);
    expectTriangulated(rings);
    if (HasFailure()) return;
  }
}

TEST(Triangulation, SizeAndPlaceDoNotMatter) {
  for (const double size : {1e-4, 1.0, 1e5}) {
    Rings rings{square, block(2, 2, 3), block(6, 5, 2)};
    for (auto& ring : rings) {
      for (Vec2& p : ring) p = size * p + Vec2(1e6 * size, -3e5 * size);
    }
    double sum = 0;
    std::vector<Vec2> points;
    for (const auto& ring : rings) points.insert(points.end(), ring.begin(), ring.end());
    for (const auto& t : triangulate(rings)) sum += signedArea({points[t[0]], points[t[1]], points[t[2]]});
    EXPECT_NEAR(sum / (size * size), 100 - 9 - 4, 0.01)
        << "coordinates 1e5 times the size cost five digits in this sum";
  }
}

TEST(Triangulation, NamesWhatIsWrong) {
  EXPECT_NE(refusal({{{0, 0}, {1, 0}}}).find("at least 3 vertices"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0}, {1, 0}, {2, 0}}}).find("no area"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0}, {1, 1}, {1, 0}, {0, 2}}}).find("crosses or touches itself"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0}, {0, 0}, {1, 0}, {0, 1}}}).find("same point twice"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0}, {4, 0}, {2, 0}, {2, 3}}}).find("crosses or touches itself"), std::string::npos)
      << "spike";
  EXPECT_NE(refusal({square, block(20, 20, 1)}).find("hole 1 outside"), std::string::npos);
  EXPECT_NE(refusal({square, block(9, 9, 3)}).find("meets the edge"), std::string::npos);
  EXPECT_NE(refusal({square, block(0, 2, 1)}).find("meets the edge"), std::string::npos) << "touching counts";
  EXPECT_NE(refusal({square, block(2, 2, 5), block(3, 3, 1)}).find("hole 2 inside hole 1"), std::string::npos);
  EXPECT_NE(refusal({std::vector<Vec2>(6000, Vec2(0))}).find("5000 are the most"), std::string::npos);
}

TEST(Polygon, IsRefusedWhenNotFlatAndKeptWhenRoundedToMillimetres) {
  try {
    makePolygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("the polygon is not flat: vertex"), std::string::npos) << error.what();
  }
  EXPECT_NEAR(area(makePolygon({{0, 0, 0}, {5, 0, 1.667}, {5, 4, 1.667}, {0, 4, 0.001}})), 4 * std::hypot(5, 1.667),
              0.01);
  EXPECT_THROW(makePolygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(makePolygon({{0, 0, 0}, {1, 0, std::nan("")}, {2, 1, 0}}), std::invalid_argument);
}

TEST(Polygon, FacesWhereItsOutlineTurnsCounterClockwise) {
  const Vec3 up = vectorArea(makePolygon({{0, 0, 1}, {2, 0, 1}, {2, 3, 1}, {0, 3, 1}}));
  EXPECT_NEAR(glm::distance(up, Vec3(0, 0, 6)), 0, 1e-14);
  const Vec3 down = vectorArea(makePolygon({{0, 3, 1}, {2, 3, 1}, {2, 0, 1}, {0, 0, 1}}));
  EXPECT_NEAR(glm::distance(down, Vec3(0, 0, -6)), 0, 1e-14);
}

TEST(Polyhedron, NamesTheFaceAndTheVertexThatDoNotFit) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto refused = [&](const std::vector<std::vector<int>>& faces) {
    try {
      makePolyhedron(corners, faces);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused({{0, 1, 2}, {0, 1, 4}}).find("face 2 names vertex 4, but vertices count from 0 to 3"),
            std::string::npos);
  EXPECT_NE(refused({{0, 1, -1}}).find("vertex -1"), std::string::npos);
  EXPECT_NE(refused({{0, 1}}).find("face 1 needs at least 3"), std::string::npos);
  EXPECT_NE(refused({}).find("no faces"), std::string::npos);
  EXPECT_FALSE(makePolyhedron(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}).closed) << "one face is missing";
  EXPECT_TRUE(makePolyhedron(corners, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}).closed)
      << "turned ones are put right";
}

TEST(Polyhedron, IsClosedAlsoWhenCornersAreWrittenTwice) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  const Shape shape = makePolyhedron(corners, {{0, 2, 1}, {0, 4, 3}, {1, 5, 3}, {0, 3, 2}});
  EXPECT_TRUE(shape.closed);
  EXPECT_NEAR(volume(shape), 1.0 / 6, 1e-15);
}

}  // namespace
}  // namespace goniolux::geometry
