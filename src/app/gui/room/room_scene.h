// RoomScene: what the 3-D view shows of a project, as data for VTK: surfaces coloured by their material, edges,
// luminaires. Made off the GUI thread, then read-only. World frame of the project, metres.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/room/surface_pieces.h"
#include "core/vector.h"
#include "geometry/bounds.h"
#include "plot/palette.h"
#include "project/project.h"

namespace goniolux::gui {

/// One luminaire as it is shown and picked.
struct LuminaireMark {
  std::string name;
  std::string pointer;  ///< of its entry in the document: an array's luminaires share it
  core::Vec3 position{0}, aim{0, 0, -1};
  std::vector<core::Vec3> footprint;  ///< closed polygon; a small square for a point, a thin one for a line
  photometry::LuminaireFrame frame;
  std::shared_ptr<const photometry::IntensityDistribution> distribution;  ///< null: uniform luminance of the opening
};

/// Where the objects of an entry of the document stand.
struct EntryPlace {
  geometry::Bounds box;  ///< around all of them
  core::Vec3 center{0};  ///< of the first one's box: an array turns about it
  bool isRoom = false;   ///< faces inward: not pulled about by the mouse
};

struct RoomScene {
  vtkSmartPointer<vtkPolyData> room;                ///< surfaces that are seen from inside only; cell array "object"
  std::vector<SurfacePiece> objects;                ///< all others, the largest first
  std::vector<vtkSmartPointer<vtkPolyData>> edges;  ///< feature edges, those of the largest objects first
  std::vector<LuminaireMark> luminaires;
  std::vector<std::string> objectPointers;    ///< by the number in the cell array "object"
  std::map<std::string, EntryPlace> entries;  ///< of objects, by pointer
  core::Vec3 low{0}, high{1};                 ///< box around everything
  [[nodiscard]] double size() const { return glm::length(high - low); }
  [[nodiscard]] core::Vec3 middle() const { return 0.5 * (low + high); }
};

/// `text` is what the project was read from: places in it become pointers.
RoomScene roomSceneOf(const project::Project& project, const std::string& text);

/// The colour of a finish in daylight on an sRGB display, or under another light, whose white becomes the display's.
plot::Rgb colourOf(const material::Material& material);
plot::Rgb colourOf(const material::Material& material, const spectrum::SpectralDistribution& light);

}  // namespace goniolux::gui
