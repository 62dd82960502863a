// A new room: the lumen method against closed forms, and the project that it writes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "photometry/intensity_distribution.h"
#include "pipeline/lumen_method.h"
#include "pipeline/stages.h"
#include "project/project.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

RoomForLayout office() {
  RoomForLayout room;
  room.length = 6, room.width = 4, room.height = 3;
  room.mounting = 3;
  room.flux_lm = 4000;
  return room;
}

TEST(LumenMethod, FormFactorOfOppositeSquaresIsThatOfTheTables) {
  // Cubes: 0.19982 (Howell, C-11); far away: area over pi times distance squared.
  EXPECT_NEAR(oppositeRectangles(1, 1, 1), 0.199825, 1e-6);
  EXPECT_NEAR(oppositeRectangles(1, 1, 100) / (1 / (std::numbers::pi * 1e4)), 1, 1e-3);
}

TEST(LumenMethod, InABlackRoomUtilisationIsTheDirectShareOfTheClosedForm) {
  RoomForLayout room = office();
  room.ceiling = room.walls = room.floor = 0;
  // A ceiling wholly covered by luminaires that emit by Lambert's law: the form factor from ceiling to work plane.
  const photometry::CosinePowerDistribution cosine(1000, 1);
  EXPECT_NEAR(lumenMethod(room, cosine, 12, 8).utilisation, oppositeRectangles(6, 4, 2.2), 2e-3);
}

TEST(LumenMethod, AShallowRoomIsTwoPlanesBetweenWhichLightGoesToAndFro) {
  RoomForLayout room = office();
  room.length = room.width = 300;
  room.ceiling = 0.8, room.walls = 0, room.floor = 0.5;
  room.workPlane = 0, room.height = room.mounting = 1;
  // Far from the walls: all flux falls on the floor, and again after each pair of reflections: 1 / (1 - 0.8 * 0.5).
  const photometry::CosinePowerDistribution cosine(1000, 4);
  EXPECT_NEAR(lumenMethod(room, cosine, 150, 150).utilisation, 1 / (1 - 0.8 * 0.5), 0.05);
}

TEST(LumenMethod, TheLayoutReachesItsTargetAndOneLuminaireLessDoesNot) {
  const photometry::CosinePowerDistribution cosine(4000 / std::numbers::pi, 1);
  const Layout layout = layoutFor(office(), cosine, 500);
  EXPECT_GE(layout.meanIlluminance_lx, 500);
  EXPECT_LT(layout.meanIlluminance_lx * (layout.along * layout.across - 1) / (layout.along * layout.across), 520);
  EXPECT_GE(layout.along, layout.across) << "more along the longer side";
  EXPECT_LE(layout.spacingToHeight, 1.5);
}

StageReport newRoom(const std::map<std::string, std::string>& options, const std::string& folder) {
  core::SilentProgress silent;
  StageRequest request;
  request.inputs = {"room"};
  request.options = options;
  request.common.output = folder;
  return newStage().run(request, silent);
}

TEST(NewStage, TheProjectThatItWritesIsWithoutErrorsAndHasItsLuminaires) {
  const test::TemporaryFolder folder;
  const StageReport report =
      newRoom({{"size", "7.2x5x2.8"}, {"reflectances", ".7/.5/.2"}, {"luminaire", "panel-600.ies"}, {"target", "500"}},
              (folder.path() / "office").string());
  const project::Project project = project::readProject((folder.path() / "office").string());
  EXPECT_TRUE(project.warnings.all().empty());
  EXPECT_EQ(double(project.environment.luminaires.size()), report.json.find("luminaires")->number());
  EXPECT_EQ(project.requirements.size(), 1U);
  EXPECT_GE(report.json.find("expected_mean_lx")->number(), 500);
  for (const auto& luminaire : project.environment.luminaires) EXPECT_NEAR(luminaire.center.z, 2.8, 0.2);
  EXPECT_THROW(newRoom({{"size", "6x4x3"}, {"luminaire", "panel-600.ies"}}, (folder.path() / "office").string()),
               core::InputError)
      << "an existing project is not overwritten";
}

TEST(NewStage, WhatShinesUpIsHungBelowTheCeiling) {
  const test::TemporaryFolder folder;
  const auto heightOf = [&](const std::string& name, std::map<std::string, std::string> options) {
    options.insert({{"size", "6x4x3"}, {"luminaire", name}});
    const std::string path = (folder.path() / (name + std::to_string(options.size()))).string();
    newRoom(options, path);
    return project::readProject(path).environment.luminaires.front().center.z;
  };
  EXPECT_NEAR(heightOf("tube-pendant.ies", {}), 2.5, 0.05);
  EXPECT_NEAR(heightOf("batten-t8.ldt", {}), 3, 0.05) << "some of its light goes up";
  EXPECT_NEAR(heightOf("tube-pendant.ies", {{"suspension", "0.3"}}), 2.7, 0.05);
}

TEST(NewStage, BadOptionsAreRefusedAndNothingIsWritten) {
  const test::TemporaryFolder folder;
  const std::string office = (folder.path() / "office").string();
  for (const std::map<std::string, std::string>& options : std::vector<std::map<std::string, std::string>>{
           {{"size", "6x4"}, {"luminaire", "panel-600.ies"}},
           {{"size", "6x4x-3"}, {"luminaire", "panel-600.ies"}},
           {{"size", "6x4x3"}, {"luminaire", "no-such-file.ies"}},
           {{"size", "6x4x3"}, {"luminaire", "panel-600.ies"}, {"reflectances", "7/5/2"}},
           {{"size", "6x4x3"}, {"luminaire", "panel-600.ies"}, {"target", "bright"}}}) {
    EXPECT_THROW(newRoom(options, office), core::InputError);
  }
  EXPECT_FALSE(std::filesystem::exists(office));
}

}  // namespace
}  // namespace goniolux::pipeline
