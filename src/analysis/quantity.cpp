#include "analysis/quantity.h"

namespace goniolux::analysis {
namespace {

using solver::ReceiverBody;

// CIE S 026:2018: melanopic efficacy of luminous radiation for daylight (D65), and the luminous efficacy constant.
constexpr double melanopicEfficacyOfDaylight = 1.3262e-3, maximumEfficacy = 683.002;

}  // namespace

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = {
      {"illuminance", "illuminance", "on the plane with the normal given"},
      {"cylindrical", "cylindrical illuminance",
       "mean on the curved surface of a small upright cylinder (or about \"axis\")", ReceiverBody::cylinder, 1, 1, "lx",
       true},
      {"semi-cylindrical", "semi-cylindrical illuminance",
       "mean on the curved surface of a small upright half cylinder that faces \"normal\"", ReceiverBody::halfCylinder,
       1, 1, "lx", true},
      {"hemispherical", "hemispherical illuminance",
       "mean on the curved surface of a small hemisphere about \"normal\"", ReceiverBody::hemisphere},
      {"spherical", "mean spherical illuminance", "mean on the surface of a small sphere (scalar illuminance)",
       ReceiverBody::sphere},
      {"melanopic-edi", "melanopic equivalent daylight illuminance", "CIE S 026, on the plane with the normal given",
       ReceiverBody::plane, 3, 1 / (maximumEfficacy * melanopicEfficacyOfDaylight)}};
  return all;
}

const Quantity* findQuantity(const std::string& name) {
  for (const Quantity& quantity : quantities())
    if (quantity.name == name) return &quantity;
  return nullptr;
}

std::vector<std::string> quantityNames() {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities()) names.push_back(quantity.name);
  return names;
}

}  // namespace goniolux::analysis
