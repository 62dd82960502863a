// The registry of photometric quantities that a grid can ask for.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solver/receiver.h"

namespace goniolux::analysis {

/// A quantity is what a receiver of some shape gets, weighted by a response channel (spectrum/spectral_quadrature.h).
struct Quantity {
  std::string name;   ///< as in the project file
  std::string title;  ///< CIE S 017 term
  std::string help;
  solver::ReceiverBody body = solver::ReceiverBody::plane;
  std::size_t channel = 1;  ///< of a Response
  double factor = 1;        ///< from that channel to `unit`
  std::string unit = "lx";
  bool hasAxis = false;  ///< the project's "axis" matters
};

const std::vector<Quantity>& quantities();
/// nullptr when there is none of that name.
const Quantity* findQuantity(const std::string& name);
std::vector<std::string> quantityNames();

}  // namespace goniolux::analysis
