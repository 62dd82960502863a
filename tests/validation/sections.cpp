#include "validation/sections.h"

namespace goniolux::validation {

const std::vector<Section>& sections() {
  static const std::vector<Section> all{
      cie171Section(),   nearFieldSection(), quantitySection(), interreflectionSection(), roomSection(),
      fresnelSection(),  roughSection(),     bodySection(),     mirrorSection(),          colourSection(),
      spectralSection(), glareSection(),     treeSection()};
  return all;
}

}  // namespace goniolux::validation
