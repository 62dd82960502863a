// Colour of light: the CIE illuminants against independent programs, colour temperature and colour difference.
#include <fmt/format.h>

#include <cmath>

#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_difference.h"
#include "spectrum/colour_rendering.h"
#include "spectrum/tm30.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using spectrum::illuminant;

// CIE 015 tables of 5 nm: chromaticity, nearest colour temperature, R_a, melanopic ratio by one independent program,
// R_f and R_g by another.
constexpr struct {
  const char* name;
  double x, y, kelvin, duv, ra, rf, rg, melanopic;
} illuminants[] = {
    {"A", 0.447575, 0.407446, 2855.57, 2.3e-6, 99.999, 100, 100, 0.495745},
    {"D65", 0.312721, 0.329031, 6503.00, 0.00321259, 99.997, 100, 100, 1.0},
    {"FL1", 0.313062, 0.337106, 6428.18, 0.00712682, 75.821, 80.6, 89.8, 0.869609},
    {"FL2", 0.372068, 0.375123, 4224.50, 0.001789, 64.157, 70.1, 86.4, 0.569904},
    {"FL3", 0.409090, 0.394117, 3446.08, 0.00066799, 56.684, 63.1, 84.4, 0.418409},
    {"FL4", 0.440181, 0.403091, 2937.96, -0.000818721, 51.353, 56.7, 83.5, 0.315514},
    {"FL5", 0.313757, 0.345161, 6345.25, 0.010749, 71.663, 77.8, 87.4, 0.83989},
    {"FL6", 0.377878, 0.388194, 4148.50, 0.0060378, 59.020, 66.5, 83.5, 0.519858},
    {"FL7", 0.312852, 0.329174, 6494.77, 0.00321963, 90.185, 91.5, 98.9, 0.923375},
    {"FL8", 0.345806, 0.358618, 4997.23, 0.00320906, 95.504, 95.5, 101.7, 0.805207},
    {"FL9", 0.374099, 0.372684, 4149.01, -6.2962e-06, 90.295, 91.0, 99.7, 0.663389},
    {"FL10", 0.345788, 0.358758, 4998.35, 0.00328521, 80.964, 79.5, 99.3, 0.683402},
    {"FL11", 0.380537, 0.376915, 3998.64, 5.03702e-05, 82.834, 80.0, 101.1, 0.563597},
    {"FL12", 0.437024, 0.404215, 2999.63, 4.34421e-05, 83.059, 77.6, 102.4, 0.404199},
    {"HP1", 0.533001, 0.414953, 1959.24, 0.000782138, 8.071, 34.2, 54.0, 0.154303},
    {"LED-B3", 0.375615, 0.372289, 4102.53, -0.000662899, 84.835, 85.3, 97.9, 0.632566},
    {"LED-RGB1", 0.455746, 0.421121, 2839.83, 0.00426777, 57.113, 71.0, 107.0, 0.577712},
};

spectrum::SpectralDistribution source(const char* name) {
  return illuminant(std::string("CIE ") + name).value();
}

std::vector<Number> chromaticities() {
  std::vector<Number> numbers;
  for (const auto& row : illuminants) {
    const auto [x, y] = spectrum::chromaticity(spectrum::tristimulus(source(row.name)));
    numbers.push_back({std::string(row.name) + " x", row.x, x, 0});
    numbers.push_back({std::string(row.name) + " y", row.y, y, 0});
  }
  return numbers;
}

std::vector<Number> temperatures() {
  std::vector<Number> numbers;
  for (const auto& row : illuminants)
    numbers.push_back(
        {row.name, row.kelvin, spectrum::colourTemperature(spectrum::tristimulus(source(row.name))).kelvin, 0});
  // Far from the locus: CIE 1960 u, v; x = 3u / (2u - 8v + 4), y = 2v / (2u - 8v + 4).
  const struct {
    double u, v, kelvin;
  } far[] = {{.1978, .3122, 6507.5}, {.4328, .2883, 1041.86}, {.2927, .2722, 2445.01}};
  for (const auto& row : far) {
    const double n = 2 * row.u - 8 * row.v + 4, x = 3 * row.u / n, y = 2 * row.v / n;
    numbers.push_back({fmt::format("(u, v) = ({:g}, {:g})", row.u, row.v), row.kelvin,
                       spectrum::colourTemperature({x / y, 1, (1 - x - y) / y}).kelvin, 0});
  }
  return numbers;
}

std::vector<Number> distances() {
  std::vector<Number> numbers;
  for (const auto& row : illuminants)
    numbers.push_back({row.name, row.duv, spectrum::colourTemperature(spectrum::tristimulus(source(row.name))).duv, 0});
  return numbers;
}

std::vector<Number> renderingIndices() {
  std::vector<Number> numbers;
  for (const auto& row : illuminants)
    numbers.push_back({row.name, row.ra, spectrum::colourRendering(source(row.name)).ra, 0});
  return numbers;
}

std::vector<Number> fidelities() {
  std::vector<Number> numbers;
  for (const auto& row : illuminants) {
    const auto fidelity = spectrum::colourFidelity(source(row.name));
    numbers.push_back({std::string(row.name) + " R_f", row.rf, fidelity.rf, 0});
    numbers.push_back({std::string(row.name) + " R_g", row.rg, fidelity.rg, 0});
  }
  return numbers;
}

std::vector<Number> melanopicRatios() {
  std::vector<Number> numbers;
  for (const auto& row : illuminants)
    numbers.push_back({row.name, row.melanopic, spectrum::melanopicDer(source(row.name)), 0});
  numbers.push_back({"E", .9058, spectrum::melanopicDer(source("E")), 0});
  return numbers;
}

// Sharma, Wu, Dalal 2005, table 1: pairs at the formula's turns.
std::vector<Number> differences() {
  const struct {
    int pair;
    spectrum::Lab first, second;
    double difference;
  } rows[] = {{1, {50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
              {4, {50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
              {7, {50, 0, 0}, {50, -1, 2}, 2.3669},
              {9, {50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
              {13, {50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
              {16, {50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
              {17, {50, 2.5, 0}, {73, 25, -18}, 27.1492},
              {20, {50, 2.5, 0}, {58, 24, 15}, 19.4535},
              {25, {60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
              {29, {22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
              {31, {90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
              {34, {2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};
  std::vector<Number> numbers;
  for (const auto& row : rows)
    numbers.push_back(
        {fmt::format("pair {}", row.pair), row.difference, spectrum::deltaE2000(row.first, row.second), 0});
  return numbers;
}

}  // namespace

Section colourSection() {
  Section section;
  section.title = "Colour of light";
  section.introduction =
      "Seventeen illuminants of CIE 015 with independent programs' figures; chromaticities and R_a agree with the "
      "published ones.";
  section.cases = {
      {"5.1", "Chromaticity", "", "CIE 1931 x, y by sums over 5 nm", "another program, and CIE 015", "", 5e-5, 1, false,
       chromaticities},
      {"5.1t", "Correlated colour temperature", "K", "nearest Planckian radiator in CIE 1960 u, v",
       "another program, by an exact search", "", 2e-4, 0, false, temperatures},
      {"5.1d", "Distance from the Planckian locus", "", "D_uv", "another program", "", 2e-5, 1, false, distances},
      {"5.1r", "Colour rendering index R_a", "", "CIE 13.3", "another program, and CIE 015 to the whole number", "",
       1e-3, 100, false, renderingIndices},
      {"5.1f", "Fidelity and gamut", "", "R_f and R_g of TM-30-20",
       "an open library of others; the workbook of TM-30 gives 70 and 86 for FL2", "", 5e-3, 100, false, fidelities},
      {"5.1m", "Melanopic daylight efficacy ratio", "", "CIE S 026", "another program", "", 5e-4, 1, false,
       melanopicRatios},
      {"5.1e", "CIEDE2000", "", "pairs of Sharma, Wu and Dalal", "their table 1 (2005)", "", 5e-5, 1, false,
       differences},
  };
  return section;
}

}  // namespace goniolux::validation
