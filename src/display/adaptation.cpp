#include "display/adaptation.h"

#include <fmt/format.h>

#include <array>

#include "core/closest_name.h"
#include "core/diagnostics.h"

namespace goniolux::display {
namespace {

using core::Mat3;
using core::Vec3;

struct Space {
  const char* name;
  Mat3 rows;  // as printed; GLM takes columns
};

const std::array<Space, 3>& spaces() {
  static const std::array<Space, 3> list{
      {{"cat16", Mat3(0.401288, 0.650173, -0.051461, -0.250268, 1.204414, 0.045854, -0.002079, 0.048952, 0.953127)},
       {"cat02", Mat3(0.7328, 0.4296, -0.1624, -0.7036, 1.6975, 0.0061, 0.0030, 0.0136, 0.9834)},
       {"bradford", Mat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296)}}};
  return list;
}

Vec3 xyzOf(const spectrum::Chromaticity& colour) {
  return {colour.x / colour.y, 1, (1 - colour.x - colour.y) / colour.y};
}

}  // namespace

std::vector<std::string> adaptationNames() {
  std::vector<std::string> names;
  for (const Space& space : spaces()) names.emplace_back(space.name);
  return names;
}

Adaptation adaptationNamed(const std::string& name) {
  for (std::size_t i = 0; i < spaces().size(); ++i)
    if (spaces()[i].name == name) return static_cast<Adaptation>(i);
  throw core::InputError({}, "adaptation",
                         fmt::format("there is no adaptation '{}'{}", name, core::suggestion(name, adaptationNames())));
}

Mat3 adaptation(const spectrum::Chromaticity& from, const spectrum::Chromaticity& to, Adaptation space) {
  const Mat3 cones = glm::transpose(spaces()[static_cast<std::size_t>(space)].rows);
  const Vec3 gain = (cones * xyzOf(to)) / (cones * xyzOf(from));
  return glm::inverse(cones) * Mat3({gain.x, 0, 0}, {0, gain.y, 0}, {0, 0, gain.z}) * cones;
}

}  // namespace goniolux::display
