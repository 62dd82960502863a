// The sections of the validation suite, in the order of the page.
#pragma once

#include <vector>

#include "validation/case.h"

namespace goniolux::validation {

Section cie171Section();
Section nearFieldSection();
Section quantitySection();
Section interreflectionSection();
Section roomSection();
Section fresnelSection();
Section roughSection();
Section bodySection();
Section mirrorSection();
Section colourSection();
Section spectralSection();
Section glareSection();
Section treeSection();

const std::vector<Section>& sections();

}  // namespace goniolux::validation
