// The choice of wavelengths against rooms that the planner does not know: enclosures with random form factors and
// random light, solved at every nanometre and at the chosen nodes.
#include "planner/spectral_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>
#include <vector>

#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_difference.h"
#include "spectrum/dense_solve.h"
#include "spectrum/spectrum_files.h"

namespace goniolux::planner {
namespace {

using spectrum::Response;
using spectrum::SpectralDistribution;
using spectrum::SpectralQuadrature;

// Finishes of materials/ and the measured test colours of CIE 13.3.
const std::vector<SpectralDistribution>& reflectances() {
  static const std::vector<SpectralDistribution> list = [] {
    std::vector<std::string> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(GONIOLUX_SOURCE_DIR) / "materials"))
      if (entry.path().extension() == ".spd") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    std::vector<SpectralDistribution> all = spectrum::testColours();
    for (const std::string& file : files) all.push_back(spectrum::readSpectrumFile(file, spectrum::Role::reflectance));
    return all;
  }();
  return list;
}

struct Patch {
  std::size_t finish;
  double area;
  std::vector<double> direct;      // lx, per source
  std::vector<double> formFactor;  // to each patch; sums to 1
};

struct Enclosure {
  std::vector<SpectralDistribution> sources;
  std::vector<Finish> finishes;
  std::vector<Patch> patches;
};

Enclosure randomEnclosure(std::mt19937& random) {
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  const auto chosen = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  Enclosure room;
  const auto names = spectrum::illuminantNames();
  for (std::size_t s = 0, count = 1 + chosen(2); s < count; ++s)
    room.sources.push_back(spectrum::illuminant(names[chosen(names.size())]).value());
  const std::size_t finishes = 2 + chosen(6);
  double total = 0;
  for (std::size_t i = 0; i < finishes; ++i) {
    room.finishes.push_back({reflectances()[chosen(reflectances().size())], std::exp(uniform(-2.5, 0))});
    total += room.finishes.back().share;
  }
  for (auto& finish : room.finishes) finish.share /= total;
  for (std::size_t i = 0; i < finishes; ++i)
    for (int part = 0; part < 2; ++part) room.patches.push_back({i, room.finishes[i].share / 2, {}, {}});
  for (std::size_t p = 0; p < room.patches.size(); ++p) {
    Patch& patch = room.patches[p];
    for (std::size_t s = 0; s < room.sources.size(); ++s)
      patch.direct.push_back(uniform(0, 1) < 0.3 ? 0 : uniform(0.1, 1));
    double sum = 0;
    for (std::size_t q = 0; q < room.patches.size(); ++q) {
      patch.formFactor.push_back(p == q ? 0 : room.patches[q].area * std::exp(uniform(-1, 1)));
      sum += patch.formFactor.back();
    }
    for (double& f : patch.formFactor) f /= sum;
  }
  return room;
}

// Response of the illuminance on each patch: (1 - F rho) E = direct, at each node of the quadrature.
std::vector<Response> illuminances(const Enclosure& room, const SpectralQuadrature& quadrature,
                                   std::vector<Response>& exitances) {
  const std::size_t n = room.patches.size();
  std::vector<std::vector<double>> rho;
  for (const Finish& finish : room.finishes) rho.push_back(spectrum::atNodes(finish.reflectance, quadrature));
  std::vector<Response> result(n, Response{});
  exitances.assign(n, Response{});
  for (std::size_t s = 0; s < room.sources.size(); ++s) {
    for (std::size_t k = 0; k < quadrature.wavelengths.size(); ++k) {
      std::vector<double> system(n * (n + 1));
      for (std::size_t p = 0; p < n; ++p) {
        for (std::size_t q = 0; q < n; ++q)
          system[p * (n + 1) + q] = (p == q ? 1 : 0) - room.patches[p].formFactor[q] * rho[room.patches[q].finish][k];
        system[p * (n + 1) + n] = room.patches[p].direct[s];
      }
      EXPECT_TRUE(spectrum::solveDense(system, n));
      for (std::size_t p = 0; p < n; ++p) {
        const double E = system[p * (n + 1) + n];
        for (std::size_t c = 0; c < 4; ++c) {
          result[p][c] += quadrature.weights[s][k][c] * E;
          exitances[p][c] += quadrature.weights[s][k][c] * E * rho[room.patches[p].finish][k];
        }
      }
    }
  }
  return result;
}

struct TrueError {
  double illuminance = 0, colour = 0;
};

TrueError trueError(const Enclosure& room, const SpectralQuadrature& quadrature, const SpectralQuadrature& control) {
  std::vector<Response> exactLight, foundLight;
  const auto exact = illuminances(room, control, exactLight), found = illuminances(room, quadrature, foundLight);
  // White: the lamps' light together, at the mean direct illuminance.
  spectrum::Xyz white;
  for (const Patch& patch : room.patches) {
    for (std::size_t s = 0; s < room.sources.size(); ++s) {
      Response light{};
      for (const Response& w : control.weights[s])
        for (std::size_t c = 0; c < 4; ++c) light[c] += w[c];
      const double share = patch.direct[s] / static_cast<double>(room.patches.size());
      white.X += share * light[0], white.Y += share * light[1], white.Z += share * light[2];
    }
  }
  TrueError worst;
  for (std::size_t p = 0; p < exact.size(); ++p) {
    worst.illuminance = std::max(worst.illuminance, std::abs(found[p][1] - exact[p][1]) / exact[p][1]);
    const Response &a = exactLight[p], &b = foundLight[p];
    worst.colour = std::max(worst.colour, spectrum::deltaE2000(spectrum::lab({a[0], a[1], a[2]}, white),
                                                               spectrum::lab({b[0], b[1], b[2]}, white)));
  }
  return worst;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// The bound of an illuminance is wider than that of a colour: it supposes a point without direct light, and most points
// of these rooms have some.
TEST(SpectralChoice, BoundHoldsInTwoHundredRandomRooms) {
  std::mt19937 random(1983);
  std::vector<double> ratioY, ratioColour;
  std::vector<int> counts(500);
  int held = 0, rooms = 0;
  for (; rooms < 200; ++rooms) {
    const Enclosure room = randomEnclosure(random);
    SpectralAllowance allowance;
    allowance.pictures = true;
    const SpectralChoice choice = chooseWavelengths(room.finishes, room.sources, allowance);
    const TrueError error = trueError(room, choice.quadrature, spectrum::controlQuadrature(room.sources));
    ++counts[choice.quadrature.wavelengths.size()];
    const bool holds = error.illuminance <= choice.error.illuminance && error.colour <= choice.error.colour;
    held += holds ? 1 : 0;
    EXPECT_TRUE(holds) << "room " << rooms << ": " << error.illuminance << " against " << choice.error.illuminance
                       << ", " << error.colour << " against " << choice.error.colour;
    ratioY.push_back(choice.error.illuminance / error.illuminance);
    ratioColour.push_back(choice.error.colour / error.colour);
  }
  std::printf("rooms in which both bounds hold: %d of %d\n", held, rooms);
  std::printf("bound / true error, median: illuminance %.2f, colour %.2f\n", median(ratioY), median(ratioColour));
  std::printf("wavelengths: rooms ");
  for (std::size_t n = 0; n < counts.size(); ++n)
    if (counts[n] > 0) std::printf(" %zu: %d", n, counts[n]);
  std::printf("\n");
  EXPECT_LE(median(ratioY), 12);
  EXPECT_LE(median(ratioColour), 3);
}

TEST(SpectralChoice, ColourBoundHoldsForTwoHundredSourcesThroughFilters) {
  // Two or three filters in the beam of a real source; the truth is integrated exactly between all knots.
  std::mt19937 random(2026);
  std::vector<double> ratio;
  int held = 0, scenes = 0;
  double worstTrue = 0;
  const auto names = spectrum::illuminantNames();
  const auto chosen = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  for (; scenes < 200; ++scenes) {
    const std::vector<SpectralDistribution> sources{spectrum::illuminant(names[chosen(names.size())]).value()};
    const std::size_t count = 2 + chosen(2);
    std::vector<Finish> filters;
    for (std::size_t i = 0; i < count; ++i)
      filters.push_back({reflectances()[chosen(reflectances().size())], 1.0 / static_cast<double>(count)});
    SpectralAllowance allowance;
    allowance.pictures = true;
    const SpectralChoice choice = chooseWavelengths(filters, sources, allowance);
    const auto exact = [&](const SpectralDistribution& a, const SpectralDistribution& b) {
      // Source x observer on a grid of 0.25 nm, the filters interpolated there.
      spectrum::Xyz sum;
      for (int i = 0; i <= 1880; ++i) {
        const double w = 360 + 0.25 * i;
        const double light = sources[0].continuum(w) * a.continuum(w) * b.continuum(w);
        sum.X += light * spectrum::cie1931().xbar.continuum(w);
        sum.Y += light * spectrum::cie1931().ybar.continuum(w);
        sum.Z += light * spectrum::cie1931().zbar.continuum(w);
      }
      return sum;
    };
    const auto one = SpectralDistribution::flat(1);
    const spectrum::Xyz light = exact(one, one);
    const auto relative = [&](const spectrum::Xyz& c) {
      return spectrum::Xyz{c.X / light.Y, c.Y / light.Y, c.Z / light.Y};
    };
    double error = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i; j <= count; ++j) {  // j == count: filter i alone
        const auto& second = j == count ? one : filters[j].reflectance;
        auto values = spectrum::atNodes(filters[i].reflectance, choice.quadrature);
        const auto other = spectrum::atNodes(second, choice.quadrature);
        for (std::size_t k = 0; k < values.size(); ++k) values[k] *= other[k];
        const Response found = spectrum::responseOf(choice.quadrature.weights[0], values);
        error = std::max(error, spectrum::deltaE2000(
                                    spectrum::lab({found[0], found[1], found[2]}, relative(light)),
                                    spectrum::lab(relative(exact(filters[i].reflectance, second)), relative(light))));
      }
    }
    const bool holds = error <= choice.error.colour;
    held += holds ? 1 : 0;
    EXPECT_TRUE(holds) << "scene " << scenes << ": " << error << " against " << choice.error.colour;
    ratio.push_back(choice.error.colour / error);
    worstTrue = std::max(worstTrue, error);
  }
  std::printf("sources through filters: bound holds in %d of %d; bound / true error, median %.2f; largest true %.2f\n",
              held, scenes, median(ratio), worstTrue);
  EXPECT_LE(median(ratio), 3);
  EXPECT_LE(worstTrue, 1) << "what was asked for";
}

TEST(SpectralChoice, GreyRoomTravelsOnOneWavelength) {
  const SpectralChoice choice =
      chooseWavelengths({{SpectralDistribution::flat(0.2), 0.5}, {SpectralDistribution::flat(0.7), 0.5}},
                        {spectrum::illuminant("CIE FL11").value()}, {0.001, true, 0.001, 0.1});
  EXPECT_EQ(choice.quadrature.wavelengths.size(), 1U);
  EXPECT_EQ(choice.error.illuminance, 0);
}

TEST(SpectralChoice, MoreAccuracyNeverTakesFewerWavelengths) {
  const std::vector<Finish> finishes{{reflectances()[8], 0.2}, {reflectances()[3], 0.3}, {reflectances()[20], 0.5}};
  const std::vector<SpectralDistribution> sources{spectrum::illuminant("CIE LED-B3").value()};
  std::size_t before = 0;
  for (const double allowed : {0.03, 0.01, 0.003, 0.001, 0.0003}) {
    const auto choice = chooseWavelengths(finishes, sources, {allowed, true, allowed, 300 * allowed});
    EXPECT_GE(choice.quadrature.wavelengths.size(), before) << allowed;
    EXPECT_LE(choice.error.illuminance, allowed);
    before = choice.quadrature.wavelengths.size();
  }
}

TEST(LightPaths, RoomOfOneFinishGivesTheSeriesOfItsReflections) {
  const LightPaths paths({{SpectralDistribution::flat(0.5), 1.0}});
  const auto transmittances = paths.transmittances({{0.5, 0.2}});
  ASSERT_EQ(transmittances.size(), 8U);
  for (std::size_t path = 0; path < 3; ++path) {
    EXPECT_DOUBLE_EQ(transmittances[path][0], 1.0) << "rho / (1 - rho)";
    EXPECT_DOUBLE_EQ(transmittances[path][1], 0.25);
  }
  EXPECT_DOUBLE_EQ(transmittances[3][1], 0.05) << "rho^2 / (1 - rho)";
  EXPECT_EQ(paths.seen(3), LightPaths::Seen::byGrid);
  EXPECT_EQ(transmittances[4], (std::vector<double>{0.5, 0.2})) << "seen in direct light";
  EXPECT_DOUBLE_EQ(transmittances[7][1], 0.04) << "in its own light";
  EXPECT_EQ(paths.seen(4), LightPaths::Seen::byEye);
}

}  // namespace
}  // namespace goniolux::planner
