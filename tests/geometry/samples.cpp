#include "geometry/samples.h"

#include <cmath>
#include <fstream>
#include <vector>

namespace goniolux::geometry::test {

using core::pi;
using core::Vec3;

std::vector<Sample> samples(const std::filesystem::path& folder) {
  std::vector<Sample> list;
  list.push_back({"box", "office", {{"min", Vec3(0)}, {"max", Vec3(6, 4, 3)}}, 2 * (24 + 18 + 12), 72});
  list.push_back(
      {"rectangle", "tilted", {{"origin", Vec3(1, 2, 3)}, {"u", Vec3(0, 3, 4)}, {"v", Vec3(2, 0, 0)}}, 10, 0});
  list.push_back(
      {"disc", "tilted", {{"center", Vec3(1, 2, 3)}, {"normal", Vec3(1, 1, 1)}, {"radius", 2.0}}, 4 * pi, 0});
  list.push_back({"sphere", "globe", {{"center", Vec3(3, 2, 1)}, {"diameter", 1.0}}, pi, pi / 6});
  list.push_back({"cylinder",
                  "column",
                  {{"base", Vec3(1, 1, 0)}, {"height", 3.0}, {"radius", 0.5}, {"caps", std::string("both")}},
                  2 * pi * 0.5 * 3 + 2 * pi * 0.25,
                  pi * 0.25 * 3});
  list.push_back({"cylinder",
                  "open tube",
                  {{"base", Vec3(0)}, {"top", Vec3(1, 2, 2)}, {"radius", 0.1}, {"caps", std::string("none")}},
                  2 * pi * 0.1 * 3,
                  0});
  list.push_back({"cone",
                  "lampshade, solid",
                  {{"base", Vec3(0, 0, 1)}, {"top", Vec3(0, 0, 5)}, {"radius", 1.0}, {"top_radius", 4.0}},
                  pi * (1 + 4) * 5 + pi * (1 + 16),
                  pi * 4 / 3 * (1 + 4 + 16)});
  list.push_back({"cone",
                  "pointed",
                  {{"base", Vec3(1)}, {"height", 4.0}, {"axis", Vec3(1, 0, 0)}, {"radius", 3.0}, {"top_radius", 0.0}},
                  pi * 3 * 5 + pi * 9,
                  pi * 9 * 4 / 3});
  list.push_back({"torus",
                  "ring lamp",
                  {{"center", Vec3(1, 2, 3)}, {"axis", Vec3(1, 2, 2)}, {"ring_radius", 0.5}, {"tube_radius", 0.1}},
                  4 * pi * pi * 0.5 * 0.1,
                  2 * pi * pi * 0.5 * 0.01});
  // Prolate spheroid with half-axes 1, 1, 2, in units of 0.5 m: area 2 pi a^2 (1 + c / (a e) asin e), e^2 = 1 -
  // a^2/c^2.
  const double e = std::sqrt(0.75);
  list.push_back({"quadric",
                  "spheroid",
                  {{"xx", 4.0},
                   {"yy", 4.0},
                   {"zz", 1.0},
                   {"constant", -4.0},
                   {"size", 0.5},
                   {"center", Vec3(3, 0, 0)},
                   {"min", Vec3(2, -1, -2)},
                   {"max", Vec3(4, 1, 2)}},
                  0.25 * 2 * pi * (1 + 2 / e * std::asin(e)),
                  0.125 * 4 * pi / 3 * 2,
                  1e-3});
  // Paraboloid z = x^2 + y^2 up to z = 1: area pi/6 (5^1.5 - 1).
  list.push_back(
      {"quadric",
       "reflector, open",
       {{"xx", 1.0}, {"yy", 1.0}, {"z", -1.0}, {"size", 1.0}, {"min", Vec3(-2, -2, -1)}, {"max", Vec3(2, 2, 1)}},
       pi / 6 * (std::pow(5, 1.5) - 1),
       0,
       1e-3});
  list.push_back(
      {"parametric",
       "flat, of degree 3 x 1",
       {{"control",
         std::vector<std::vector<Vec3>>{
             {{0, 0, 0}, {0, 2, 0}}, {{1, 0, 0}, {1, 2, 0}}, {{2, 0, 0}, {2, 2, 0}}, {{3, 0, 0}, {3, 2, 0}}}}},
       6,
       0});
  // Areas and volumes of revolution by Pappus: length or area of the profile times the way of its centroid.
  list.push_back({"revolution",
                  "lens",
                  {{"profile", std::vector<core::Vec2>{{0, 0}, {3, 4}, {0, 8}}},
                   {"center", Vec3(1, 2, 3)},
                   {"axis", Vec3(0, 3, 4)}},
                  2 * pi * 3 * 5,
                  pi * 9 * 8 / 3});
  list.push_back({"revolution",
                  "ring of square section, written clockwise",
                  {{"profile", std::vector<core::Vec2>{{1, 0}, {1, 0.5}, {1.5, 0.5}, {1.5, 0}, {1, 0}}}},
                  2 * pi * 1.25 * 2,
                  2 * pi * 1.25 * 0.25});
  list.push_back({"revolution",
                  "bowl with a flat foot and a thick wall",
                  {{"profile", std::vector<core::Vec2>{{0, 0}, {1, 0}, {3, 2}, {2.5, 2}, {0.5, 0.5}, {0, 0.5}}}},
                  pi * (1 + 4 * std::sqrt(8.0) + (9 - 6.25) + 3 * 2.5 + 0.25),
                  pi * 2 / 3 * (1 + 3 + 9) - pi * 1.5 / 3 * (0.25 + 1.25 + 6.25)});
  list.push_back({"revolution",
                  "reflector, open",
                  {{"profile", std::vector<core::Vec2>{{0.1, 0}, {0.4, 0.4}, {0.4, 0.6}}}, {"axis", Vec3(0, 0, -1)}},
                  pi * 0.5 * 0.5 + 2 * pi * 0.4 * 0.2,
                  0});
  list.push_back({"polygon",
                  "wall with a window, upright",
                  {{"vertices", std::vector<Vec3>{{0, 1, 0}, {5, 1, 0}, {5, 1, 3}, {2, 1, 3}, {2, 1, 2}, {0, 1, 2}}},
                   {"holes", std::vector<std::vector<Vec3>>{{{3, 1, 1}, {4, 1, 1}, {4, 1, 2}, {3, 1, 2}}}}},
                  5 * 3 - 2 - 1,
                  0});
  // A wedge, two faces of which turn the wrong way: the shape puts them right.
  list.push_back(
      {"polyhedron",
       "roof",
       {{"vertices", std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {4, 6, 0}, {0, 6, 0}, {2, 0, 1.5}, {2, 6, 1.5}}},
        {"faces", std::vector<std::vector<int>>{{0, 3, 2, 1}, {0, 1, 4}, {2, 5, 3}, {1, 2, 5, 4}, {0, 3, 5, 4}}}},
       24 + 2 * 3 + 2 * 15,
       18});
  std::ofstream(folder / "box.obj") << "v 0 0 0\nv 100 0 0\nv 100 200 0\nv 0 200 0\nv 0 0 300\nv 100 0 300\n"
                                       "v 100 200 300\nv 0 200 300\n"
                                       "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n";
  list.push_back({"mesh",
                  "box in centimetres",
                  {{"file", (folder / "box.obj").string()}, {"units", std::string("cm")}},
                  2 * (2 + 3 + 6),
                  6});
  return list;
}

}  // namespace goniolux::geometry::test
