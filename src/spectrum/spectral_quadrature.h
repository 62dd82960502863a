// SpectralQuadrature: the wavelengths that rays carry, and for each source spectrum the weights that turn what arrives
// at those wavelengths into X, Y, Z (and the melanopic response).
//
// Transport is linear in the transmittance T(lambda) of a light path (the product of its reflectances). T is sampled at
// the nodes only; the source's spectrum times the observer is integrated exactly against the linear interpolation of T
// between nodes
// ("hat" weights). So a white scene is exact for any source, lines included, with any number of nodes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

/// Response channels that a light path's spectrum is reduced to: X, Y, Z and melanopic, all divided by the integral of
/// S ybar: per unit of luminous flux, so that the weights of channel Y sum to 1 for every source. Melanopic irradiance
/// in W/m2 is its channel times illuminance / 683.002; the melanopic equivalent daylight illuminance in lx is that
/// divided by 1.3262e-3 W/lm (CIE S 026).
inline constexpr int responseChannels = 4;
using Response = std::array<double, responseChannels>;

/// What stands for a reflectance at a node.
enum class NodeValues {
  fitted,   ///< least-squares fit of hats, see atNodes(): for weights that stand for linear interpolation
  sampled,  ///< its value at the node's wavelength: products of reflectances then are exact at the nodes
  weighed,  ///< its mean under the node's sensor: the "colour" of tristimulus schemes
};

/// What a node of NodeValues::weighed sees: sum of weights[i] times the value at wavelengths[i]; the weights sum to 1.
struct Sensor {
  std::vector<double> wavelengths, weights;
};

struct SpectralQuadrature {
  std::string scheme;                          ///< e.g. "flat:1", "uniform:9"
  std::vector<double> wavelengths;             ///< nm, ascending; size N >= 1
  std::vector<std::vector<Response>> weights;  ///< [source][node]
  NodeValues values = NodeValues::fitted;
  std::vector<Sensor> sensors;  ///< per node for NodeValues::weighed, else empty
};

/// Response of a light path whose transmittance at the nodes is given, to a source's weights.
Response responseOf(const std::vector<Response>& weights, const std::vector<double>& transmittance);

/// One node for scenes in which every reflectance and transmittance is flat; otherwise `count` equally spaced nodes
/// over 400-700 nm (360-830 nm from 81 nodes on). `sources`: relative spectral power of each source; a source without
/// any luminous power is a precondition error (readers refuse it).
SpectralQuadrature flatQuadrature(const std::vector<SpectralDistribution>& sources);
SpectralQuadrature uniformQuadrature(int count, const std::vector<SpectralDistribution>& sources);

/// The 1 nm control that other schemes are measured against: every nanometre of 360-830 nm, sampled, hat weights. A
/// nanometre that lies within half of one of a source's line moves onto it, so that a line sees what a filter does to
/// it and not the mean of its neighbours; two lines within one nanometre get a node each.
SpectralQuadrature controlQuadrature(const std::vector<SpectralDistribution>& sources);

/// Reflectance or transmittance at the nodes: its samples there for NodeValues::sampled, what the sensors see for
/// NodeValues::weighed (which can be negative for a sensor that can), else the values whose linear
/// interpolation comes closest to the distribution in the sense of least squares, weighted by what the observer sees
/// (xbar + ybar + zbar; ybar alone for a single node). A straight line is met exactly, narrow features are not stepped
/// over, and the seen mean is kept. Where the fit would leave [0, 1] it is drawn towards the means under the hats,
/// which cannot. (For one and two reflections of colour samples under D65, FL11 and LED-B3 this halves the error of
/// plain sampling at the nodes for 9 to 31 nodes.)
std::vector<double> atNodes(const SpectralDistribution& distribution, const SpectralQuadrature& quadrature);

}  // namespace goniolux::spectrum
