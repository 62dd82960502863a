// Small projects written as text and calculated by the engine, as `goniolux illuminate` does it.
#pragma once

#include <string>
#include <vector>

#include "core/vector.h"
#include "project/project.h"
#include "project/results.h"
#include "validation/case.h"

namespace goniolux::validation {

/// "[x,y,z]".
std::string list(const core::Vec3& v);

/// The parts of a project file; each call adds one entry, given as the members of its JSON object.
class ProjectText {
 public:
  void material(const std::string& name, const std::string& members);
  /// Diffuse, with reflectance `rho`; emits `exitance` lm/m2.
  void paint(const std::string& name, double rho, double exitance = 0);
  void object(const std::string& members);
  /// A closed room from the origin, or from `min`.
  void room(const core::Vec3& size, const std::string& material, const core::Vec3& min = core::Vec3(0));
  /// A black box about everything, `half` metres to each side of the origin: a grid must lie in a room.
  void surround(double half);
  void rectangle(const core::Vec3& origin, const core::Vec3& u, const core::Vec3& v, const std::string& material);
  /// `members` beside position: photometry, flux, shape, aim ...
  void luminaire(const core::Vec3& position, const std::string& members);
  void points(const std::string& name, const std::vector<core::Vec3>& points, const std::vector<core::Vec3>& normals,
              const std::string& members = "");
  void plane(const std::string& name, const core::Vec3& origin, const core::Vec3& u, const core::Vec3& v, int along,
             int across, const core::Vec3& normal);
  void observer(const std::string& name, const core::Vec3& eye, const core::Vec3& direction);
  [[nodiscard]] std::string text() const;

 private:
  std::string materials_, objects_, luminaires_, grids_, observers_;
};

/// Throws core::InputError where the text is no good project.
project::Project projectOf(const ProjectText& text);
/// `solver` "": the one that the planner chooses. Throws core::InputError where the text is no good project.
project::Results calculate(const ProjectText& project, const std::string& accuracy, const std::string& solver = "");
/// A project of the folder projects/.
project::Results calculateProject(const std::string& folder, const std::string& accuracy);

/// The number at a point of a grid.
Number numberAt(const std::string& what, double reference, const project::GridResult& grid, std::size_t index,
                double uncertainty = 0);
Number numberOf(const std::string& what, double reference, const core::Estimate& estimate, double uncertainty = 0);

}  // namespace goniolux::validation
