// What `check` finds in a scene's geometry, each on a room in which just that is wrong, and nothing in a good room.
#include <gtest/gtest.h>

#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

std::string roomWith(const std::string& objects, const std::string& luminaire = "[2,1.5,2.4]",
                     const std::string& room = "\"min\": [0,0,0], \"max\": [4,3,2.5]") {
  return "{ \"format\": \"goniolux-project\", \"version\": 1,\n\"materials\": { \"grey\": { \"model\": \"lambert\", "
         "\"diffuse\": 0.5 }, \"red\": { \"model\": \"lambert\", \"diffuse\": 0.3 } },\n\"objects\": [ { \"name\": "
         "\"room\", \"shape\": \"box\", " +
         room + ", \"facing\": \"inward\", \"material\": \"grey\" }\n" + objects +
         " ],\n\"luminaires\": [ { \"name\": \"L\", \"photometry\": \"isotropic\", \"flux\": 1000, \"position\": " +
         luminaire +
         " } ],\n\"grids\": [ { \"name\": \"plane\", \"origin\": [0,0,0.8], \"u\": [4,0,0], \"v\": [0,3,0], "
         "\"counts\": [4,3] } ] }\n";
}

// All warnings of `goniolux check`, one a line as "RULE LINE MESSAGE".
std::string findings(const std::string& project, const std::string& model = "") {
  const test::TemporaryFolder folder;
  folder.write("project.json", project);
  if (!model.empty()) folder.write("model.obj", model);
  core::SilentProgress silent;
  StageRequest request;
  request.inputs = {folder.path().string()};
  const StageReport report = checkStage().run(request, silent);
  EXPECT_FALSE(report.inputFailed) << report.text;
  std::string text;
  for (const core::Diagnostic& d : report.warnings.all())
    text += d.rule + " " + std::to_string(d.position.line) + " " + d.message + "\n";
  return text;
}

std::string object(const std::string& keys, const std::string& material = "red") {
  return ", { \"name\": \"thing\", \"material\": \"" + material + "\", " + keys + " }\n";
}

TEST(Findings, AGoodFurnishedRoomHasNone) {
  EXPECT_EQ(findings(roomWith(object("\"shape\": \"box\", \"min\": [1,1,0], \"max\": [2,2,0.7]") +
                              object("\"shape\": \"cylinder\", \"base\": [3,1,0], \"radius\": 0.2, \"height\": 1"))),
            "")
      << "standing on the floor is no coincidence";
  for (const char* project : {"small-office", "gallery", "corridor-fluorescent"}) {
    core::SilentProgress silent;
    StageRequest request;
    request.inputs = {std::string(GONIOLUX_SOURCE_DIR) + "/projects/" + project};
    const StageReport report = checkStage().run(request, silent);
    for (const core::Diagnostic& d : report.warnings.all())
      EXPECT_TRUE(d.rule != "coincident" && d.rule != "open-room" && d.rule != "blocked" && d.rule != "scale")
          << project << ": " << d.message;
  }
}

TEST(Findings, ARugInTheFloorIsCoincidentAtItsPlace) {
  const std::string found =
      findings(roomWith(object("\"shape\": \"rectangle\", \"origin\": [1,1,0], \"u\": [1,0,0], \"v\": [0,1,0]")));
  EXPECT_NE(found.find("coincident 4 \"thing\" lies in the same plane as \"room\" (line 3)"), std::string::npos)
      << found;
  EXPECT_NE(found.find(", 0) m"), std::string::npos) << found;
  EXPECT_EQ(
      findings(roomWith(object("\"shape\": \"rectangle\", \"origin\": [1,1,0.001], \"u\": [1,0,0], \"v\": [0,1,0]"))),
      "");
}

TEST(Findings, TwoBoxesWithACommonTopAreCoincidentAndStackedOnesAreNot) {
  const std::string first = object("\"shape\": \"box\", \"min\": [1,1,0], \"max\": [2,2,0.7]");
  EXPECT_NE(
      findings(roomWith(first + object("\"shape\": \"box\", \"min\": [1.5,1.5,0.2], \"max\": [2.5,2.5,0.7]", "grey")))
          .find("coincident"),
      std::string::npos);
  EXPECT_EQ(findings(roomWith(first + object("\"shape\": \"box\", \"min\": [1.2,1.2,0.7], \"max\": [1.8,1.8,0.75]"))),
            "");
}

TEST(Findings, AHoleInAWallIsFoundWithThePlaceThatLightEscapesThrough) {
  // Five walls as rectangles; the sixth, at y = 3, has a window without a pane.
  const auto wall = [](const char* o, const char* u, const char* v) {
    return std::string("{ \"shape\": \"rectangle\", \"material\": \"grey\", \"origin\": ") + o + ", \"u\": " + u +
           ", \"v\": " + v + " },\n";
  };
  const std::string walls = wall("[0,0,0]", "[4,0,0]", "[0,3,0]") + wall("[0,0,2.5]", "[4,0,0]", "[0,3,0]") +
                            wall("[0,0,0]", "[4,0,0]", "[0,0,2.5]") + wall("[0,0,0]", "[0,3,0]", "[0,0,2.5]") +
                            wall("[4,0,0]", "[0,3,0]", "[0,0,2.5]");
  const auto project = [&](const std::string& hole) {
    std::string text = roomWith("");
    const std::size_t begin = text.find("[ { \"name\": \"room\""), end = text.find(" ],\n\"luminaires\"");
    return text.replace(begin, end - begin,
                        "[ " + walls +
                            "{ \"shape\": \"polygon\", \"material\": \"grey\", \"vertices\": "
                            "[[0,3,0],[4,3,0],[4,3,2.5],[0,3,2.5]]" +
                            hole + " }");
  };
  EXPECT_EQ(findings(project("")), "");
  const std::string found = findings(project(", \"holes\": [ [[1,3,1],[2,3,1],[2,3,2],[1,3,2]] ]"));
  EXPECT_NE(found.find("open-room"), std::string::npos) << found;
  EXPECT_NE(found.find(", 3, "), std::string::npos) << "through the plane y = 3: " << found;
}

TEST(Findings, ALuminaireInAnObjectAndOneBehindTheCeilingAreFound) {
  EXPECT_NE(findings(roomWith(object("\"shape\": \"box\", \"min\": [1,1,2], \"max\": [3,2,2.45]")))
                .find("the luminaire \"L\" at (2, 1.5, 2.4) m is inside \"thing\""),
            std::string::npos);
  const std::string behind =
      findings(roomWith(object("\"shape\": \"rectangle\", \"origin\": [1,1,2.39], \"u\": [2,0,0], \"v\": [0,1,0]")));
  EXPECT_NE(behind.find("blocked"), std::string::npos) << behind;
  EXPECT_NE(behind.find("\"thing\" (line 4) is 0.0"), std::string::npos) << behind;
}

TEST(Findings, GridPointsInFurnitureAreCounted) {
  const std::string found =
      findings(roomWith(object("\"shape\": \"box\", \"min\": [0.1,0.1,0], \"max\": [1.2,1.2,1]")));
  EXPECT_NE(found.find("1 of 12 points of the grid \"plane\" are inside \"thing\""), std::string::npos) << found;
}

TEST(Findings, WhatReachesOutOfTheRoomIsNamedWithThePlane) {
  const std::string found = findings(roomWith(object("\"shape\": \"box\", \"min\": [3,1,0], \"max\": [4.5,2,1]")));
  EXPECT_NE(found.find("reaches 0.5 m out of the room through x = 4 m"), std::string::npos) << found;
}

TEST(Findings, AnAbsurdScaleIsFound) {
  EXPECT_NE(findings(roomWith("", "[2000,1500,2400]", "\"min\": [0,0,0], \"max\": [4000,3000,2500]")).find("scale"),
            std::string::npos);
  const std::string model = "v 0 0 0\nv 900 0 0\nv 0 900 0\nf 1 2 3\n";
  EXPECT_NE(findings(roomWith(object("\"shape\": \"mesh\", \"file\": \"model.obj\"")), model).find("scale 4"),
            std::string::npos);
}

TEST(Findings, SliversAreCountedWithThePlaceOfTheFirst) {
  const std::string model = "v 1 1 0.5\nv 2 1 0.5\nv 1.5 1.00001 0.5\nv 1.5 2 0.5\nf 1 2 3\nf 1 3 4\n";
  const std::string found = findings(roomWith(object("\"shape\": \"mesh\", \"file\": \"model.obj\"")), model);
  EXPECT_NE(found.find("\"thing\" has 1 sliver triangle"), std::string::npos) << found;
  EXPECT_NE(found.find("(1.5, 1, 0.5) m"), std::string::npos) << found;
}

TEST(Findings, GridPointsInASideFaceAreNamedAndThoseOnATopAreNot) {
  // The grid's points are at x = 0.5, 1.5, 2.5, 3.5 and y = 0.5, 1.5, 2.5, z = 0.8.
  const std::string found = findings(roomWith(object("\"shape\": \"box\", \"min\": [1.5,1,0], \"max\": [2,2,1.2]")));
  EXPECT_NE(found.find("on-face"), std::string::npos) << found;
  EXPECT_NE(found.find("1 of 12 points"), std::string::npos) << found;
  EXPECT_NE(found.find("(1.5, 1.5, 0.8) m"), std::string::npos) << found;
  EXPECT_EQ(findings(roomWith(object("\"shape\": \"box\", \"min\": [1.4,1,0], \"max\": [1.9,2,0.8]"))), "")
      << "a grid on a desk";
}

TEST(Findings, SurfacesThatRunThroughEachOtherAreNamedAndThoseThatTouchAreNot) {
  const std::string box = object("\"shape\": \"box\", \"min\": [1,1,0], \"max\": [2,2,0.7]");
  const std::string through =
      findings(roomWith(box + object("\"shape\": \"box\", \"min\": [1.3,1.3,0.5], \"max\": [1.6,1.6,1]", "grey")));
  EXPECT_NE(through.find("intersecting"), std::string::npos) << through;
  EXPECT_NE(through.find("0.7) m"), std::string::npos) << "where the upright edges meet the top: " << through;
  EXPECT_NE(findings(roomWith(box + object("\"shape\": \"sphere\", \"center\": [2,1.5,0.7], \"radius\": 0.2", "grey")))
                .find("intersecting"),
            std::string::npos);
  EXPECT_EQ(findings(roomWith(box + object("\"shape\": \"cylinder\", \"base\": [1.2,1.2,0.7], \"radius\": 0.1, "
                                           "\"height\": 0.3"))),
            "");
}

}  // namespace
}  // namespace goniolux::pipeline
