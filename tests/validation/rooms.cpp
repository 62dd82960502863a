// Whole rooms: the validation projects against other programs and other methods.
#include <fmt/format.h>

#include "validation/projects.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

// Quarter of a 9 x 9 work plane, i along x, j along y.
using Quarter = double[5][5];

std::vector<Number> room(const char* project, const Quarter& quarter, double mean, const char* accuracy) {
  const auto results = calculateProject(std::string("validation/") + project, accuracy);
  const project::GridResult& grid = results.grids.at(0);
  std::vector<Number> numbers{numberOf("mean", mean, grid.mean, 1e-4 * mean)};
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j)
      numbers.push_back(
          numberAt(fmt::format("i {}, j {}", i, j), quarter[i][j], grid, j * 9 + i, 2e-4 * quarter[i][j]));
  return numbers;
}

constexpr Quarter roomA = {{240.202, 278.267, 301.303, 309.672, 310.845},
                           {316.087, 372.749, 404.204, 409.744, 407.574},
                           {350.029, 414.305, 449.239, 453.687, 450.193},
                           {324.449, 376.064, 406.691, 415.989, 416.349},
                           {303.118, 346.236, 373.780, 385.616, 388.144}};
constexpr Quarter roomB = {{1174.56, 1216.44, 1241.17, 1250.13, 1251.40},
                           {1257.20, 1309.70, 1337.82, 1341.68, 1339.02},
                           {1295.07, 1352.40, 1381.79, 1383.35, 1379.01},
                           {1267.76, 1312.84, 1338.53, 1345.17, 1344.73},
                           {1244.58, 1281.76, 1305.09, 1314.62, 1316.43}};
constexpr Quarter roomC = {{143.998, 166.560, 181.609, 189.834, 192.388},
                           {175.267, 203.172, 221.458, 231.209, 234.173},
                           {191.882, 222.358, 242.230, 252.789, 255.992},
                           {195.045, 225.093, 245.143, 256.094, 259.490},
                           {194.154, 223.473, 243.355, 254.415, 257.893}};

std::vector<Number> cube() {
  const double expected[] = {4207.19, 3622.38, 3235.98, 2662.8, 2461.9, 1830.5};
  const double uncertainty[] = {0.8, 0.7, 0.8, 3, 3, 6};
  const char* names[] = {"A, middle", "B", "C", "D, middle of an edge", "E, on an edge", "F, corner"};
  const auto results = calculateProject("validation/cube", "0.5 %");
  std::vector<Number> numbers;
  for (const auto& grid : results.grids)
    for (std::size_t i = 0; i < 6; ++i)
      numbers.push_back(numberAt(fmt::format("{}{}", names[i], &grid == &results.grids[0] ? " (floor)" : " (wall)"),
                                 expected[i], grid, i, uncertainty[i]));
  return numbers;
}

// Means over all points by an independent path tracer (4e-4), with points of a line of the grid.
std::vector<Number> referenceRoom(const char* name, double mean) {
  const auto results = calculateProject(std::string("validation/") + name, "1 %");
  return {numberOf("mean", mean, results.grids.at(0).mean, 4e-4 * mean)};
}

std::vector<Number> referenceRooms() {
  std::vector<Number> numbers;
  const struct {
    const char *name, *what;
    double mean;
  } rooms[] = {{"R1", "R1, empty: mean of 600 points", 578.370},
               {"R2", "R2, furnished: mean of 588 points", 526.227},
               {"R4", "R4, one wall a mirror: mean of 600 points", 625.443}};
  for (const auto& room : rooms)
    for (Number number : referenceRoom(room.name, room.mean)) {
      number.what = room.what;
      numbers.push_back(number);
    }
  return numbers;
}

std::vector<Number> openOffice() {
  auto numbers = referenceRoom("R3", 853.197);
  numbers[0].what = "R3, open office: mean of 960 points";
  return numbers;
}

}  // namespace

Section roomSection() {
  Section section;
  section.title = "Rooms";
  section.introduction =
      "Projects of `projects/validation` against other programs. Points of rooms A to C count from a corner, 9 × 9 "
      "over "
      "6 m × 4 m at 0.8 m.";
  const std::string nystroem =
      "integral equation by Nyström's method, steps of 0.2, 0.1 and 0.05 m extrapolated (6·10⁻⁵), and a random walk "
      "that "
      "agrees; calculated by another program";
  section.cases = {
      {"3.5A", "Room A: four downlights", "lx", "`validation/room-a`, reflectances 0.7 / 0.5 / 0.2", nystroem,
       "zonal-cavity method by hand: −0.9 % of the mean", 1.2e-2, 0, false,
       [] { return room("room-a", roomA, 366.251, "1 %"); }},
      {"3.5B", "Room B: all surfaces 0.9", "lx", "`validation/room-b`", nystroem, "", 6e-2, 0, false,
       [] { return room("room-b", roomB, 1301.97, "5 %"); }},
      {"3.5C", "Room C: indirect light only", "lx", "`validation/room-c`", nystroem, "", 1.2e-2, 0, false,
       [] { return room("room-c", roomC, 214.170, "1 %"); }},
      {"3.9", "The CUBE of Khodulev and Kopylov", "lx", "`validation/cube`: ρ 2/3, a lamp in the middle",
       "radiosity with exact point-to-patch factors, extrapolated (`tests/references/cube_radiosity.py`); agrees with "
       "the "
       "published A, B, C; at edges and corners the published values had not converged",
       "a commercial radiosity program after 40 minutes: −10.7 % of the mean", 7e-3, 0, false, cube},
      {"3.10", "Reference rooms R1, R2, R4", "lx", "`validation/R1`, `R2`, `R4`",
       "long runs of an independent path tracer (4·10⁻⁴ of a mean)",
       "Radiance (pure Monte Carlo) −0.02 %, pbrt-v4 0.01 %", 1e-2, 0, false, referenceRooms},
      {"3.10o", "Reference room R3", "lx", "`validation/R3`: 60 panels, 200 boxes", "the same", "", 1e-2, 0, false,
       openOffice},
  };
  return section;
}

}  // namespace goniolux::validation
