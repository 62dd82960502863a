// What must hold whatever the answer is: energy balance, reciprocity, scale, place, rotation, symmetry, superposition,
// splitting. Runs are compared by Welch's test at each point and at the means, wrong by chance once in 10 000.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/parallel.h"
#include "pipeline/cross_check.h"
#include "stability/room_text.h"

namespace goniolux::stability {
namespace {

using project::GridResult;
using project::Results;

constexpr double falseAlarms = 1e-4;
constexpr double stretch = 5.2391 / 2.1314;  // of a 95 % interval to that rate: Student's t, 15 degrees of freedom

void expectAgreement(const Results& one, const Results& other, const std::string& what) {
  const pipeline::CrossCheck check = pipeline::compareSolvers(one, other, falseAlarms);
  EXPECT_TRUE(check.agrees()) << what << "\n" << pipeline::textOf(check);
}

const char* const faces[][3] = {{R"("origin": [0,0,0], "u": [4,0,0], "v": [0,3,0])", "[0,0,1]", "12"},
                                {R"("origin": [0,0,2.5], "u": [4,0,0], "v": [0,3,0])", "[0,0,-1]", "12"},
                                {R"("origin": [0,0,0], "u": [4,0,0], "v": [0,0,2.5])", "[0,1,0]", "10"},
                                {R"("origin": [0,3,0], "u": [4,0,0], "v": [0,0,2.5])", "[0,-1,0]", "10"},
                                {R"("origin": [0,0,0], "u": [0,3,0], "v": [0,0,2.5])", "[1,0,0]", "7.5"},
                                {R"("origin": [4,0,0], "u": [0,3,0], "v": [0,0,2.5])", "[-1,0,0]", "7.5"}};

/// Flux that arrives at the faces of the room, each times `taken`, and its half-width (95 %).
core::Estimate fluxAt(const Results& results, const std::vector<double>& taken) {
  core::Estimate sum;
  double squares = 0;
  for (std::size_t f = 0; f < 6; ++f) {
    const double area = std::stod(faces[f][2]) * taken[f];
    const core::Estimate& mean = results.grids[f].mean;
    sum.value += area * mean.value;
    squares += std::pow(area * mean.statistical, 2);
    sum.systematic["all"] += area * (mean.halfWidth() - mean.statistical);
  }
  sum.statistical = std::sqrt(squares);
  return sum;
}

/// How far an estimate may be off, once in 10 000.
double roomFor(const core::Estimate& e) {
  return stretch * e.statistical + e.halfWidth() - e.statistical;
}

RoomText roomWithMetersOnItsFaces(const std::string& material) {
  RoomText room;
  room.objects = {
      fmt::format(R"({{ "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward",
                                    "material": "{}" }})",
                  material)};
  room.luminaires = {lampAt("[1.7,1.4,1.3]", 1000)};
  for (std::size_t f = 0; f < 6; ++f)
    room.grids.push_back(plane(std::to_string(f), faces[f][0], "[12,9]", faces[f][1]));
  room.accuracy = "10 %";
  return room;
}

// Flux emitted = flux absorbed, in a closed room; and = absorbed + escaped, where a face lets everything out (black).
TEST(Invariants, FluxEmittedIsAbsorbedOrEscapes) {
  // How well the mean of 12 x 9 points stands for a face: direct light has no noise, and the sum is known exactly.
  const double grids =
      std::abs(fluxAt(resultsOf(roomWithMetersOnItsFaces("black"), "path"), {1, 1, 1, 1, 1, 1}).value - 1000);
  EXPECT_LT(grids, 5);
  for (const std::string& solver : interreflectingSolvers())
    for (const auto& [material, absorbs] : {std::pair{"grey", 0.5}, std::pair{"white", 0.2}}) {
      RoomText room = roomWithMetersOnItsFaces(material);
      const core::Estimate closed = fluxAt(resultsOf(room, solver), std::vector<double>(6, absorbs));
      EXPECT_NEAR(closed.value, 1000, roomFor(closed) + 2 * grids) << solver;
      room.objects[0].insert(room.objects[0].rfind('}'), R"(, "materials": { "ceiling": "black" })");
      std::vector<double> taken(6, absorbs);
      taken[1] = 1;
      const core::Estimate open = fluxAt(resultsOf(room, solver, 2), taken);
      EXPECT_NEAR(open.value, 1000, roomFor(open) + 2 * grids) << solver;
    }
}

// Mean spherical illuminance at B from an isotropic lamp at A is that at A from the lamp at B, by any way of the light.
TEST(Invariants, LampAndSphericalReceiverMayChangePlaces) {
  for (const std::string& solver : interreflectingSolvers()) {
    RoomText there = furnishedRoom(), back = furnishedRoom();
    const auto receiver = [](const char* place) {
      return fmt::format(R"({{ "name": "g", "points": [{}], "quantity": "spherical" }})", place);
    };
    there.luminaires = {lampAt("[0.6,0.5,2.2]")};
    there.grids = {receiver("[3.4,2.4,0.5]")};
    back.luminaires = {lampAt("[3.4,2.4,0.5]")};
    back.grids = {receiver("[0.6,0.5,2.2]")};
    there.accuracy = back.accuracy = "2 %";
    Results one = resultsOf(there, solver, 1), other = resultsOf(back, solver, 2);
    expectAgreement(one, other, solver);
  }
}

TEST(Invariants, LightOfTwoLuminairesAddsUp) {
  for (const std::string& solver : everySolver()) {
    RoomText room = furnishedRoom();
    const std::string a = lampAt("[1,1,2.2]", 2000, "a"), b = panelAt("[3,2,2.49]", 0.6, 0.6, 3000, "b");
    room.luminaires = {a};
    Results sum = resultsOf(room, solver, 1);
    room.luminaires = {b};
    const Results second = resultsOf(room, solver, 2);
    room.luminaires = {a, b};
    const Results both = resultsOf(room, solver, 3);
    GridResult& grid = sum.grids[0];
    const GridResult& other = second.grids[0];
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      grid.values[i] += other.values[i];
      for (auto& [cause, part] : grid.parts) {
        const double more = other.parts.at(cause)[i];
        part[i] = cause == "statistical" ? std::hypot(part[i], more) : part[i] + more;
      }
      grid.halfWidths[i] = 0;
      for (const auto& [cause, part] : grid.parts) grid.halfWidths[i] += part[i];
    }
    grid.mean.value += other.mean.value;
    grid.mean.statistical = std::hypot(grid.mean.statistical, other.mean.statistical);
    for (auto& [cause, bound] : grid.mean.systematic) bound += other.mean.systematic.at(cause);
    expectAgreement(sum, both, solver);
  }
}

TEST(Invariants, SplittingAWallOrALuminaireChangesNothing) {
  for (const std::string& solver : everySolver()) {
    RoomText whole = furnishedRoom();
    whole.objects.push_back(
        R"({ "name": "screen", "shape": "rectangle", "origin": [1.5,0,0], "u": [0,2,0], "v": [0,0,1.6],
                                 "material": "white" })");
    whole.luminaires = {panelAt("[2,1.5,2.49]", 1.2, 0.3, 4000)};
    const Results before = resultsOf(whole, solver, 1);
    RoomText split = whole;
    split.objects.back() =
        R"({ "name": "screen", "shape": "rectangle", "origin": [1.5,0,0], "u": [0,0.7,0], "v": [0,0,1.6],
                                "material": "white" })";
    split.objects.push_back(
        R"({ "name": "more", "shape": "rectangle", "origin": [1.5,0.7,0], "u": [0,1.3,0], "v": [0,0,1.6],
                                 "material": "white" })");
    expectAgreement(before, resultsOf(split, solver, 2), solver + ", a wall in two");
    RoomText halves = whole;
    halves.luminaires = {panelAt("[1.7,1.5,2.49]", 0.6, 0.3, 2000, "a"),
                         panelAt("[2.3,1.5,2.49]", 0.6, 0.3, 2000, "b")};
    expectAgreement(before, resultsOf(halves, solver, 3), solver + ", a luminaire in two");
  }
}

/// The furnished room about the origin of another frame: turned about an axis, moved, scaled (flux with its square).
RoomText placed(double degrees, const core::Vec3& shift, double scale) {
  const core::Vec3 axis = glm::normalize(core::Vec3(1, 2, 3));
  const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](const core::Vec3& v) {  // Rodrigues
    return v * c + glm::cross(axis, v) * s + axis * glm::dot(axis, v) * (1 - c);
  };
  const auto text = [](const core::Vec3& v) { return fmt::format("[{:.12g},{:.12g},{:.12g}]", v.x, v.y, v.z); };
  const auto point = [&](double x, double y, double z) { return text(scale * turned({x, y, z}) + shift); };
  const auto vector = [&](double x, double y, double z) { return text(scale * turned({x, y, z})); };
  RoomText room = furnishedRoom();
  const std::string steps = fmt::format(
      R"(, "transform": [ {{ "rotate": {{ "axis": [1,2,3], "degrees": {} }} }}, {{ "scale": {} }}, {{ "translate": {} }} ])",
      degrees, scale, text(shift));
  for (std::string& object : room.objects) object.insert(object.rfind('}'), steps);
  room.luminaires = {fmt::format(
      R"({{ "name": "panel", "photometry": "cosine", "flux": {}, "position": {}, "aim": {}, "c0": {},
            "shape": {{ "rectangle": {{ "length": {}, "width": {} }} }} }})",
      4000 * scale * scale, point(1.5, 1.2, 2.49), vector(0, 0, -1), vector(1, 0, 0), 1.2 * scale, 0.3 * scale)};
  room.grids = {
      plane("g", fmt::format(R"("origin": {}, "u": {}, "v": {})", point(0, 0, 0.8), vector(4, 0, 0), vector(0, 3, 0)),
            "[8,6]", vector(0, 0, 1))};
  return room;
}

TEST(Invariants, PlaceScaleAndRotationChangeNothing) {
  for (const std::string& solver : everySolver()) {
    const Results before = resultsOf(placed(0, {0, 0, 0}, 1), solver, 1);
    expectAgreement(before, resultsOf(placed(0, {1e5, -1e5, 5e4}, 1), solver, 2), solver + ", moved by 1e5 m");
    expectAgreement(before, resultsOf(placed(0, {0, 0, 0}, 1e-3), solver, 3), solver + ", a thousandth");
    expectAgreement(before, resultsOf(placed(0, {0, 0, 0}, 1e3), solver, 4), solver + ", a thousand times");
    expectAgreement(before, resultsOf(placed(37, {0, 0, 0}, 1), solver, 5), solver + ", turned");
  }
}

// A room that is its own mirror image has light that is.
TEST(Invariants, SymmetricRoomHasSymmetricLight) {
  for (const std::string& solver : everySolver()) {
    RoomText room = furnishedRoom();
    room.objects = {
        R"({ "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward", "material": "grey" })"};
    room.luminaires = {panelAt("[2,1.5,2.4]", 1.2, 0.3, 4000)};
    const Results one = resultsOf(room, solver, 1);
    Results mirrored = resultsOf(room, solver, 2);
    GridResult& grid = mirrored.grids[0];
    const GridResult copy = grid;
    const auto from = [](std::size_t i) { return (i / 8) * 8 + 7 - i % 8; };
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      grid.values[i] = copy.values[from(i)];
      grid.halfWidths[i] = copy.halfWidths[from(i)];
      for (auto& [cause, part] : grid.parts) part[i] = copy.parts.at(cause)[from(i)];
    }
    expectAgreement(one, mirrored, solver);
  }
}

// Negative control: 3 % more light is seen at the mean, 20 % at a single point.
TEST(Invariants, AChangeWouldBeSeen) {
  RoomText room = furnishedRoom();
  room.luminaires = {lampAt("[2,1.5,2]")};
  const Results one = resultsOf(room, "path", 1);
  room.luminaires = {lampAt("[2,1.5,2]", 3090)};
  EXPECT_FALSE(pipeline::compareSolvers(one, resultsOf(room, "path", 2), falseAlarms).agrees());
  Results planted = one;
  planted.grids[0].values[20] *= 1.2;
  const pipeline::CrossCheck check = pipeline::compareSolvers(one, planted, falseAlarms);
  ASSERT_EQ(check.places.size(), 1u);
  EXPECT_EQ(check.places[0].point, 20u);
}

// Every number of the sample projects is a number, and the same on one thread and on two.
TEST(Invariants, SampleProjectsHaveNumbersThatNoThreadChanges) {
  namespace fs = std::filesystem;
  for (const char* name : {"small-office", "gallery", "corridor-fluorescent", "validation/R2"}) {
    pipeline::StageRequest request;
    request.inputs = {(fs::path(GONIOLUX_SOURCE_DIR) / "projects" / name).string()};
    request.common.accuracy = "10 %";
    project::Project project = pipeline::readProjectFor(request, pipeline::AccuracyOf::grids);
    project.settings.timeLimit_s.reset();  // where there is one, the clock has a say in how far points are refined
    std::vector<Results> runs;
    for (const int threads : {1, 2}) {
      core::setThreadCount(threads);
      const pipeline::Engine engine(project, false);
      core::SilentProgress silent;
      runs.push_back(pipeline::calculateGrids(project, engine, silent));
    }
    core::setThreadCount(0);
    for (std::size_t g = 0; g < runs[0].grids.size(); ++g) {
      const GridResult &one = runs[0].grids[g], &two = runs[1].grids[g];
      for (std::size_t i = 0, hidden = 0; i < one.values.size(); ++i) {
        if (hidden < one.excluded.size() && one.excluded[hidden] == i) {
          ++hidden;
          continue;
        }
        EXPECT_TRUE(std::isfinite(one.values[i]) && std::isfinite(one.halfWidths[i]))
            << name << " " << one.name << " " << i;
        EXPECT_GE(one.values[i], 0);
        EXPECT_EQ(one.values[i], two.values[i]) << name << " " << one.name << " " << i;
        EXPECT_EQ(one.halfWidths[i], two.halfWidths[i]) << name << " " << one.name << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace goniolux::stability
