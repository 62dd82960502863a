// What the paper's three models share, and the entries of the registry of local shading models.
#pragma once

#include <algorithm>
#include <memory>

#include "reflection/paper_terms.h"
#include "reflection/shading.h"

namespace goniolux::reflection {

class PaperShading : public LocalShading {
 public:
  PaperShading(const material::Material& material, const spectrum::SpectralQuadrature& quadrature, bool asPrinted)
      : terms_(material, quadrature), asPrinted_(asPrinted) {}
  [[nodiscard]] bool transmits() const override { return !terms_.opaque; }
  [[nodiscard]] const Medium* medium() const override { return terms_.opaque ? nullptr : &terms_.inside; }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return terms_.kdRd.size(); }
  void none(float* values) const { std::fill_n(values, nodes(), 0.0f); }
  /// As meant, I_a has the object's colour; as printed in two of the models it has none.
  void ambientColour(float* values) const {
    if (asPrinted_)
      std::fill_n(values, nodes(), 1.0f);
    else
      std::copy(terms_.kdRd.begin(), terms_.kdRd.end(), values);
  }

  PaperTerms terms_;
  bool asPrinted_;
};

template <typename Model>
std::unique_ptr<LocalShading> makePaperShading(const material::Material& material,
                                               const spectrum::SpectralQuadrature& quadrature, bool asPrinted) {
  const auto own = material.numbers.find("as_printed");
  return std::make_unique<Model>(material, quadrature, asPrinted || (own != material.numbers.end() && own->second > 0));
}

ShadingModel phongModel();
ShadingModel whittedModel();
ShadingModel hallModel();

}  // namespace goniolux::reflection
