// Outline: the scene as lines, kept as outline.json beside the results so that a plot can be drawn from the results
// folder alone. World frame of the project, metres.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"
#include "core/vector.h"
#include "pipeline/feature_edges.h"
#include "project/project.h"

namespace goniolux::pipeline {

struct ObjectOutline {
  std::string name;
  bool isRoom = false;  ///< faces inward, or spreads over more than half of the plan: drawn as the room, hides nothing
  std::vector<Segment> edges;  ///< feature edges in space
  std::vector<Segment> plan;   ///< those parts of them that show when looked at from straight above
};

struct LuminaireOutline {
  std::string name, type;  ///< "L[0,1]" of the entry "L"
  core::Vec3 position{0}, aim{0, 0, -1};
  std::vector<core::Vec3> footprint;  ///< closed polygon of the opening; two points for a line, none for a point
};

struct Outline {
  std::string project, projectHash;
  core::Vec3 low{0}, high{0};  ///< corners of the box around all objects
  std::vector<ObjectOutline> objects;
  std::vector<LuminaireOutline> luminaires;
};

Outline outlineOf(const project::Project& project);
/// One luminaire's part of it.
LuminaireOutline outlineOf(const scene::Luminaire& luminaire);

/// The document outline.json (format "goniolux-outline", version 1). Lengths are rounded to micrometres.
core::Value toJson(const Outline& outline);
/// Throws core::InputError on a damaged document.
Outline outlineFromJson(const core::Value& document);

inline constexpr const char* outlineFileName = "outline.json";

}  // namespace goniolux::pipeline
