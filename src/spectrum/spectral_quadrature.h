// SpectralQuadrature: the wavelengths that rays carry, and for each source spectrum the weights that turn what arrives at those
// wavelengths into X, Y, Z (and the melanopic response).
//
// Transport is linear in the transmittance T(lambda) of a light path (the product of its reflectances). T is sampled at the nodes
// only; the source's spectrum times the observer is integrated exactly against the linear interpolation of T between nodes
// ("hat" weights). So a white scene is exact for any source, lines included, with any number of nodes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

/// Response channels that a light path's spectrum is reduced to: X, Y, Z and melanopic, per unit of luminous flux, so that the
/// weights of channel Y sum to 1 for every source.
inline constexpr int responseChannels = 4;
using Response = std::array<double, responseChannels>;

struct SpectralQuadrature {
  std::string scheme;                            ///< e.g. "flat:1", "uniform:9"
  std::vector<double> wavelengths;               ///< nm, ascending; size N >= 1
  std::vector<std::vector<Response>> weights;    ///< [source][node]
};

/// One node for scenes in which every reflectance and transmittance is flat; otherwise `count` equally spaced nodes over
/// 400-700 nm (360-830 nm from 81 nodes on). `sources`: relative spectral power of each source; a source without any luminous
/// power is a precondition error (readers refuse it).
SpectralQuadrature flatQuadrature(const std::vector<SpectralDistribution>& sources);
SpectralQuadrature uniformQuadrature(int count, const std::vector<SpectralDistribution>& sources);

/// Reflectance or transmittance at the nodes: the mean under each node's hat, so that narrow features are not stepped over.
std::vector<double> atNodes(const SpectralDistribution& distribution, const SpectralQuadrature& quadrature);

}  // namespace goniolux::spectrum
