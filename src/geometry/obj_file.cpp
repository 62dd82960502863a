#include "geometry/obj_file.h"

#include <fmt/format.h>

namespace goniolux::geometry {

std::string objText(const Mesh& mesh, const std::vector<std::string>& partNames) {
  std::string text = "# metres, z up\n";
  for (const core::Vec3& v : mesh.vertices) text += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
  for (const auto& corners : mesh.coordinates)
    for (const glm::vec2& uv : corners) text += fmt::format("vt {} {}\n", uv.x, uv.y);
  for (std::uint32_t part = 0; part < partNames.size(); ++part) {
    bool named = false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (mesh.parts[i] != part) continue;
      if (!named) text += fmt::format("usemtl {}\n", partNames[part]);
      named = true;
      const auto& t = mesh.triangles[i];
      if (mesh.coordinates.empty())
        text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
      else
        text += fmt::format("f {}/{} {}/{} {}/{}\n", t[0] + 1, 3 * i + 1, t[1] + 1, 3 * i + 2, t[2] + 1, 3 * i + 3);
    }
  }
  return text;
}

}  // namespace goniolux::geometry
