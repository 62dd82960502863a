// The paper's Figure 8: two overlapping filters, their overlap calculated with few samples and with every nanometre.
// Prints the tables of docs/methods/spectra.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_difference.h"
#include "spectrum/schemes.h"

namespace goniolux::spectrum {
namespace {

using Curve = std::function<double(double)>;

SpectralDistribution sampledAt(double step, const Curve& f) {
  std::vector<SpectralDistribution::Sample> samples;
  const int count = static_cast<int>(std::lround(470 / step));
  for (int i = 0; i <= count; ++i) samples.push_back({360 + i * step, f(360 + i * step)});
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
}

double rise(double wavelength, double centre, double width) {
  return 1 / (1 + std::exp(-(wavelength - centre) / width));
}

struct Pair {
  SpectralDistribution first, second;
};

// Falls at 565 nm and rises at 515 nm, both between 0.05 and 0.9.
Pair figureEight() {
  return {sampledAt(0.5, [](double w) { return 0.05 + 0.85 * (1 - rise(w, 565, 8)); }),
          sampledAt(0.5, [](double w) { return 0.05 + 0.85 * rise(w, 515, 8); })};
}

// Edges, bands, notches and combs.
SpectralDistribution randomFilter(std::mt19937& random) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const double low = uniform(0, 0.1), high = uniform(0.7, 0.95), centre = uniform(440, 650);
  switch (std::uniform_int_distribution<int>(0, 3)(random)) {
    case 0: {
      const double width = uniform(5, 25), side = uniform(0, 1) < 0.5 ? -1 : 1;
      return sampledAt(1, [=](double w) { return low + (high - low) * rise(side * w, side * centre, width); });
    }
    case 1: {
      const double width = uniform(20, 60);
      return sampledAt(1, [=](double w) { return low + (high - low) * std::exp(-std::pow((w - centre) / width, 2)); });
    }
    case 2: {
      const double width = uniform(15, 40);
      return sampledAt(1, [=](double w) { return high - (high - low) * std::exp(-std::pow((w - centre) / width, 2)); });
    }
    default: {
      const double period = uniform(80, 200);
      return sampledAt(1, [=](double w) {
        return low + (high - low) * (0.5 + 0.5 * std::cos(2 * 3.14159265358979 * (w - centre) / period));
      });
    }
  }
}

std::vector<double> overlap(const Pair& pair, const SpectralQuadrature& quadrature) {
  auto values = atNodes(pair.first, quadrature);
  const auto second = atNodes(pair.second, quadrature);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] *= second[k];
  return values;
}

std::vector<LightPath> pathsOf(const Pair& pair, const SpectralQuadrature& control) {
  constexpr Response tolerance{0.01, 0.01, 0.025, 0.05};
  return {{atNodes(pair.first, control), tolerance},
          {atNodes(pair.second, control), tolerance},
          {overlap(pair, control), tolerance}};
}

double difference(const Response& found, const Response& exact, const Response& white) {
  const Xyz light{white[0], white[1], white[2]};
  return deltaE2000(lab({found[0], found[1], found[2]}, light), lab({exact[0], exact[1], exact[2]}, light));
}

// One source with its control.
struct Light {
  std::vector<SpectralDistribution> sources;
  SpectralQuadrature control;
  Response white{};
  explicit Light(SpectralDistribution source) : sources{std::move(source)}, control(controlQuadrature(sources)) {
    white = responseOf(control.weights[0], std::vector<double>(control.wavelengths.size(), 1.0));
  }
  [[nodiscard]] double error(const SpectralQuadrature& quadrature, const Pair& pair) const {
    return difference(responseOf(quadrature.weights[0], overlap(pair, quadrature)),
                      responseOf(control.weights[0], overlap(pair, control)), white);
  }
};

// A weak continuum under five lines 1 nm wide.
SpectralDistribution fiveLines() {
  const std::map<int, double> lines{{405, 15}, {436, 40}, {546, 60}, {578, 30}, {611, 70}};
  return sampledAt(0.5, [&](double w) {
    double power = 0.3;
    for (const auto& [centre, height] : lines) power += height * std::max(0.0, 1 - std::abs(w - centre));
    return power;
  });
}

TEST(FigureEight, EachSchemeMissesTheOverlapByWhatAnIndependentCalculationSays) {
  // CIEDE2000 of the overlap under D65 and FL11, calculated at 1 nm by a program that is not ours, for the schemes that
  // it has too.
  struct Row {
    const char* scheme;
    int count;
    double underD65, underFL11;
  };
  const std::vector<Row> rows{{"rgb", 3, 6.975, 11.093},   {"xyz", 3, 8.919, 5.441},    {"meyer", 4, 14.503, 18.738},
                              {"paper", 9, 1.541, 14.60},  {"point", 9, 1.701, 8.475},  {"bins", 9, 0.838, 0.773},
                              {"gauss", 9, 7.193, 8.374},  {"paper", 16, 0.225, 13.49}, {"bins", 16, 0.385, 0.242},
                              {"point", 31, 0.0195, 0.927}};
  const Light d65(illuminant("CIE D65").value()), fl11(illuminant("CIE FL11").value());
  const Pair pair = figureEight();
  std::printf("CIEDE2000 of the overlap          D65     FL11\n");
  for (const Row& row : rows) {
    const SpectralScheme* scheme = findSpectralScheme(row.scheme);
    ASSERT_NE(scheme, nullptr) << row.scheme;
    double found[2];
    int i = 0;
    for (const Light* light : {&d65, &fl11}) {
      const auto paths = pathsOf(pair, light->control);
      found[i++] = light->error(scheme->make({row.count, light->sources, light->control, paths}), pair);
    }
    std::printf("  %-8s %3d  %14.3f %8.3f\n", row.scheme, row.count, found[0], found[1]);
    // 1 %: theirs are sums at 1 nm, ours integrals between the nanometres.
    EXPECT_NEAR(found[0], row.underD65, 0.01 * row.underD65 + 0.005) << row.scheme << row.count;
    EXPECT_NEAR(found[1], row.underFL11, 0.01 * row.underFL11 + 0.005) << row.scheme << row.count;
  }
  for (const int count : {3, 4, 5, 6, 9}) {
    double found[2];
    int i = 0;
    for (const Light* light : {&d65, &fl11})
      found[i++] = light->error(adaptedQuadrature(count, light->control, pathsOf(pair, light->control)), pair);
    std::printf("  %-8s %3d  %14.3f %8.3f\n", "adapted", count, found[0], found[1]);
    if (count >= 5) {
      EXPECT_LT(found[0], 0.2);
      EXPECT_LT(found[1], 0.2);
    }
  }
}

struct Statistics {
  double mean, high;
};

Statistics statisticsOf(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  double sum = 0;
  for (const double e : errors) sum += e;
  return {sum / static_cast<double>(errors.size()), errors[errors.size() * 95 / 100]};
}

TEST(FigureEight, NineAdaptedSamplesAreWithinHalfACiede2000OnFourHundredFilterPairs) {
  constexpr int pairs = 400;
  std::mt19937 random(8);
  std::vector<Pair> filters, others;
  for (int i = 0; i < pairs; ++i) filters.push_back({randomFilter(random), randomFilter(random)});
  for (int i = 0; i < 80; ++i) others.push_back({randomFilter(random), randomFilter(random)});
  struct Row {
    const char* scheme;
    int count;
  };
  const std::vector<Row> rows{{"rgb", 3},      {"xyz", 3},     {"meyer", 4},  {"paper", 9}, {"point", 9},
                              {"bins", 9},     {"uniform", 9}, {"gauss", 9},  {"hero", 9},  {"paper", 31},
                              {"uniform", 31}, {"adapted", 4}, {"adapted", 9}};
  std::map<std::string, std::vector<Statistics>> table;
  std::vector<std::string> order;
  for (const Row& row : rows) order.push_back(std::string(row.scheme) + ":" + std::to_string(row.count));
  for (const int count : {6, 9}) order.push_back("adapted to other pairs:" + std::to_string(count));
  for (const SpectralDistribution& source :
       {illuminant("CIE D65").value(), illuminant("CIE FL11").value(), fiveLines()}) {
    const Light light(source);
    for (const Row& row : rows) {
      const SpectralScheme* scheme = findSpectralScheme(row.scheme);
      const bool same = std::string(row.scheme) != "adapted";
      SpectralQuadrature quadrature;
      std::vector<double> errors;
      for (const Pair& pair : filters) {
        if (errors.empty() || !same) {
          const auto paths = pathsOf(pair, light.control);
          quadrature = scheme->make({row.count, light.sources, light.control, paths});
        }
        errors.push_back(light.error(quadrature, pair));
      }
      table[quadrature.scheme].push_back(statisticsOf(std::move(errors)));
    }
    // What nodes can do that know filters of the kind, but not these.
    std::vector<LightPath> known;
    for (const Pair& pair : others)
      for (const LightPath& path : pathsOf(pair, light.control)) known.push_back(path);
    for (const int count : {6, 9}) {
      const SpectralQuadrature quadrature = adaptedQuadrature(count, light.control, known);
      std::vector<double> errors;
      for (const Pair& pair : filters) errors.push_back(light.error(quadrature, pair));
      table["adapted to other pairs:" + std::to_string(count)].push_back(statisticsOf(std::move(errors)));
    }
  }
  std::printf("CIEDE2000, mean (95 %% below)            D65            FL11          5 lines\n");
  for (const std::string& name : order) {
    std::printf("  %-26s", name.c_str());
    for (const Statistics& s : table[name]) std::printf("  %6.2f (%5.1f)", s.mean, s.high);
    std::printf("\n");
  }
  for (const Statistics& s : table["adapted:9"]) EXPECT_LE(s.mean, 0.5);
  for (const Statistics& s : table["paper:9"]) EXPECT_GT(s.mean, 1) << "else the comparison says nothing";
}

TEST(FigureEight, SodiumThroughANotchIsRightWhereTheLineHasItsOwnWavelength) {
  auto sodium = SpectralDistribution::flat(0);
  sodium.addLine({589.3, 1});
  const auto notch = sampledAt(0.1, [](double w) { return 1 - 0.95 * std::exp(-std::pow((w - 589.3) / 5, 2)); });
  const Light light(sodium);
  const std::vector<LightPath> paths{{atNodes(notch, light.control), {0.01, 0.01, 0.025, 0.05}}};
  std::printf("transmittance of the notch for sodium light, exactly 0.05:\n");
  for (const auto& [name, count] : std::vector<std::pair<std::string, int>>{{"bins", 9},
                                                                            {"bins", 31},
                                                                            {"uniform", 9},
                                                                            {"uniform", 81},
                                                                            {"adapted", 1},
                                                                            {"adapted", 9},
                                                                            {"control", 471}}) {
    const auto quadrature = findSpectralScheme(name)->make({count, light.sources, light.control, paths});
    const double T = responseOf(quadrature.weights[0], atNodes(notch, quadrature))[1];
    std::printf("  %-8s %3d  %.4f\n", name.c_str(), count, T);
    if (name == "adapted" || name == "control") {
      EXPECT_NEAR(T, 0.05, 2e-4) << name;
    } else if (name == "bins" && count == 9) {
      EXPECT_GT(T, 0.7) << "the known failure of even samples";
    }
  }
}

TEST(FigureEight, HeroWavelengthsConvergeToTheControl) {
  // Root mean square CIEDE2000 of the overlap under D65 with 4 wavelengths per path; in brackets an independent
  // program's, whose paths are spread less evenly over the strata.
  const std::map<int, double> known{{1, 10.36}, {4, 5.01}, {16, 1.096}, {64, 0.140}};
  const Light light(illuminant("CIE D65").value());
  const Pair pair = figureEight();
  const std::vector<LightPath> none;
  std::mt19937 random(2014);
  for (const auto& [paths, expected] : known) {
    double squares = 0;
    constexpr int runs = 200;
    for (int run = 0; run < runs; ++run) {
      Response mean{};
      for (int path = 0; path < paths; ++path) {
        const double offset = (path + std::uniform_real_distribution<double>(0, 1)(random)) / paths;
        const auto q = findSpectralScheme("hero")->make({4, light.sources, light.control, none, offset});
        const Response one = responseOf(q.weights[0], overlap(pair, q));
        for (std::size_t c = 0; c < 4; ++c) mean[c] += one[c] / paths;
      }
      const double e =
          difference(mean, responseOf(light.control.weights[0], overlap(pair, light.control)), light.white);
      squares += e * e;
    }
    const double rms = std::sqrt(squares / runs);
    std::printf("  hero, %3d paths of 4: %.3f (%.3f)\n", paths, rms, expected);
    EXPECT_LT(rms, 1.1 * expected);
    if (paths == 1) {
      EXPECT_GT(rms, 0.8 * expected) << "one path has nothing to be spread over";
    }
  }
}

TEST(SpectralSchemes, WhiteIsExactInAllThatDoNotDistort) {
  const Light light(illuminant("CIE FL11").value());
  const auto paths = pathsOf(figureEight(), light.control);
  for (const SpectralScheme& scheme : spectralSchemes()) {
    if (scheme.name == "paper") continue;  // its purpose
    // Hero wavelengths are right on average: so are many offsets together.
    const int offsets = scheme.name == "hero" ? 2000 : 1;
    Response mean{};
    for (int i = 0; i < offsets; ++i) {
      const auto quadrature =
          scheme.make({scheme.defaultCount, light.sources, light.control, paths, (i + 0.5) / offsets});
      const auto white = responseOf(quadrature.weights[0], std::vector<double>(quadrature.wavelengths.size(), 1.0));
      for (std::size_t c = 0; c < 4; ++c) mean[c] += white[c] / offsets;
      EXPECT_EQ(quadrature.scheme, scheme.name + ":" + std::to_string(quadrature.wavelengths.size()));
    }
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_NEAR(mean[c], light.white[c], (offsets > 1 ? 2e-3 : 1e-9) * light.white[c]) << scheme.name << " " << c;
  }
}

}  // namespace
}  // namespace goniolux::spectrum
