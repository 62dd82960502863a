#include "reflection/bsdf.h"

#include <algorithm>

namespace goniolux::reflection {

void Bsdf::mirrorReflectance(double, float* values) const {
  std::fill_n(values, nodes(), 0.0f);
}

void Bsdf::straightTransmittance(double, float* values) const {
  std::fill_n(values, nodes(), 0.0f);
}

void Bsdf::diffuseReflectance(float* values) const {
  std::fill_n(values, nodes(), 0.0f);
}

}  // namespace goniolux::reflection
