#include "display/mapping_types.h"

namespace goniolux::display {

core::Parameter mappingNumber(const char* key, const char* standard, double minimum, bool minimumIsAllowed,
                              const char* help) {
  core::Parameter p;
  p.key = key;
  p.kind = core::ParameterKind::number;
  p.defaultText = standard;
  p.minimum = minimum;
  p.minimumIsAllowed = minimumIsAllowed;
  p.help = help;
  return p;
}

core::Parameter mappingText(const char* key, const char* standard, const char* help) {
  core::Parameter p;
  p.key = key;
  p.kind = core::ParameterKind::text;
  p.defaultText = standard;
  p.help = help;
  return p;
}

core::Parameter mappingSwitch(const char* key, const char* help) {
  core::Parameter p;
  p.key = key;
  p.kind = core::ParameterKind::boolean;
  p.defaultText = "no";
  p.help = help;
  return p;
}

}  // namespace goniolux::display
