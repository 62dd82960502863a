#include "display/film.h"

#include <algorithm>
#include <cmath>

#include "display/film_curve.h"
#include "spectrum/cie_data.h"

namespace goniolux::display {
namespace {

using core::Mat3;
using core::Vec3;

constexpr double ln10 = 2.302585092994046;
constexpr int samples = 71;  // 380 to 730 nm in steps of 5 nm
double wavelength(int i) {
  return 380 + 5.0 * i;
}

// The film on the screen at its wavelengths: light of no dye at all, and the dyes.
struct Screen {
  std::array<Vec3, samples> light;  // lamp x base x observer
  std::array<Vec3, samples> dyes;   // density of one unit of cyan, magenta, yellow
};

Screen screenOf(const Film& film) {
  Screen screen;
  for (int i = 0; i < samples; ++i) {
    const double nm = wavelength(i);
    const auto& observer = spectrum::cie1931();
    const auto at = static_cast<std::size_t>(i);
    const double through = film.lamp.continuum(nm) * std::pow(10.0, -film.base.continuum(nm));
    screen.light[at] =
        Vec3(observer.xbar.continuum(nm), observer.ybar.continuum(nm), observer.zbar.continuum(nm)) * through;
    for (int c = 0; c < 3; ++c) screen.dyes[at][c] = film.dyes[static_cast<std::size_t>(c)].continuum(nm);
  }
  return screen;
}

// Light through the dye amounts and its derivative by them (columns are dyes).
Vec3 lightThrough(const Screen& screen, const Vec3& amounts, Mat3* derivative = nullptr) {
  Vec3 sum(0);
  if (derivative != nullptr) *derivative = Mat3(0);
  for (std::size_t i = 0; i < samples; ++i) {
    const Vec3 part = screen.light[i] * std::exp(-ln10 * glm::dot(amounts, screen.dyes[i]));
    sum += part;
    if (derivative == nullptr) continue;
    for (int c = 0; c < 3; ++c) (*derivative)[c] -= part * (ln10 * screen.dyes[i][c]);
  }
  return sum;
}

// Dye amounts of codes: through the print's curves, or the film's densities themselves.
Vec3 amountsOf(const Film& film, const Vec3& codes) {
  Vec3 amounts;
  for (int c = 0; c < 3; ++c) {
    const double density = film.density(codes[c]);
    amounts[c] = film.reversal ? density : densityAt(film.print[static_cast<std::size_t>(c)], -density);
  }
  return amounts;
}

Vec3 codesOf(const Film& film, const Vec3& amounts) {
  Vec3 codes;
  for (int c = 0; c < 3; ++c)
    codes[c] =
        film.code(film.reversal ? amounts[c] : -exposureFor(film.print[static_cast<std::size_t>(c)], amounts[c]));
  return codes;
}

// Codes of the brightest light: the negative at its densest, the reversal film at its clearest.
Vec3 brightest(const Film& film) {
  return Vec3(film.reversal ? film.code(0) : 1);
}

class FilmModel final : public DeviceModel {
 public:
  explicit FilmModel(const Device& device) : film_(device.film), screen_(screenOf(*device.film)) {
    white_ = lightThrough(screen_, amountsOf(*film_, brightest(*film_)));
    const double flare = device.white_cd_m2 > 0 ? device.flare_cd_m2 / device.white_cd_m2 : 0;
    flare_ = white_ / white_.y * flare;
  }

  // Newton's method on the logarithm of X, Y, Z, which is nearly linear in densities. Neighbouring pixels are alike:
  // each begins where the last one ended.
  void toDevice(std::span<glm::vec3> pixels) const override {
    Vec3 amounts(1);
    Vec3 lastTarget(-1), lastCodes(0);
    for (glm::vec3& pixel : pixels) {
      const Vec3 target = (Vec3(pixel) - flare_) * white_.y;
      if (target == lastTarget) {
        pixel = glm::vec3(lastCodes);
        continue;
      }
      lastTarget = target;
      lastCodes = solve(target, amounts);
      pixel = glm::vec3(lastCodes);
    }
  }
  void toLight(std::span<glm::vec3> pixels) const override {
    for (glm::vec3& pixel : pixels)
      pixel = glm::vec3(lightThrough(screen_, amountsOf(*film_, Vec3(pixel))) / white_.y + flare_);
  }
  [[nodiscard]] double encode(int, double value) const override { return value; }
  [[nodiscard]] double decode(int, double code) const override { return code; }
  [[nodiscard]] bool isLinear() const override { return false; }

 private:
  Vec3 solve(const Vec3& target, Vec3& amounts) const {
    // Darker than any dye makes it: as dark as can be, said by codes out of range.
    const Vec3 aim = glm::max(target, white_ * 1e-7);
    if (!(aim.x < 1e6 * white_.x && aim.y < 1e6 * white_.y && aim.z < 1e6 * white_.z)) return Vec3(std::nan(""));
    for (int round = 0; round < 24; ++round) {
      Mat3 derivative;
      const Vec3 light = lightThrough(screen_, amounts, &derivative);
      const Vec3 apart = glm::log(aim / light);
      for (int c = 0; c < 3; ++c) derivative[c] /= light;
      Vec3 step = glm::inverse(derivative) * apart;
      const double largest = std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
      if (!std::isfinite(largest)) break;
      if (largest > 1) step /= largest;
      amounts = glm::clamp(amounts + step, Vec3(-3), Vec3(12));
      if (largest < 1e-6) return codesOf(*film_, amounts);
    }
    amounts = Vec3(1);
    return Vec3(std::nan(""));  // no amounts of these dyes make the colour
  }

  std::shared_ptr<const Film> film_;
  Screen screen_;
  Vec3 white_{1}, flare_{0};
};

// Log exposure of the recorded film's layers for codes.
Vec3 logExposures(const Film& film, const Vec3& codes) {
  Vec3 result;
  for (int c = 0; c < 3; ++c) {
    const double density = film.density(codes[c]);
    const auto& curve = film.exposed[static_cast<std::size_t>(c)];
    // A reversal film's table is of what is left unexposed: density falls where exposure rises.
    result[c] = film.reversal ? -exposureFor(curve, density) : exposureFor(curve, density);
  }
  return result;
}

Vec3 codesOfExposures(const Film& film, const Vec3& logExposure) {
  Vec3 codes;
  for (int c = 0; c < 3; ++c) {
    const auto& curve = film.exposed[static_cast<std::size_t>(c)];
    const double at =
        std::clamp(film.reversal ? -logExposure[c] : logExposure[c], curve.front().first, curve.back().first);
    codes[c] = std::clamp(film.code(densityAt(curve, at)), 0.0, 1.0);
  }
  return codes;
}

}  // namespace

Vec3 filmLight(const Film& film, const Vec3& codes) {
  const Screen screen = screenOf(film);
  return lightThrough(screen, amountsOf(film, codes)) / lightThrough(screen, amountsOf(film, brightest(film))).y;
}

Mat3 recorderCrosstalk(const Film& film) {
  Mat3 matrix(0);
  for (int channel = 0; channel < 3; ++channel)
    for (int layer = 0; layer < 3; ++layer)
      for (int i = 0; i < samples; ++i) {
        const double nm = wavelength(i);
        const auto c = static_cast<std::size_t>(channel), l = static_cast<std::size_t>(layer);
        matrix[channel][layer] +=
            film.phosphors[c].continuum(nm) * film.filters[c].continuum(nm) * film.sensitivities[l].continuum(nm);
      }
  for (int layer = 0; layer < 3; ++layer) {
    const double sum = matrix[0][layer] + matrix[1][layer] + matrix[2][layer];
    for (int channel = 0; channel < 3; ++channel) matrix[channel][layer] /= sum;
  }
  return matrix;
}

Vec3 recorderDrive(const Film& film, const Vec3& codes) {
  const Vec3 full = logExposures(film, brightest(film)), wanted = logExposures(film, codes);
  Vec3 exposures;
  for (int c = 0; c < 3; ++c) exposures[c] = std::pow(10.0, wanted[c] - full[c]);
  return glm::inverse(recorderCrosstalk(film)) * exposures;
}

Mat3 compositePrimaries(const Film& film) {
  const Mat3 crosstalk = recorderCrosstalk(film);
  const Vec3 full = logExposures(film, brightest(film));
  Mat3 light;
  for (int channel = 0; channel < 3; ++channel) {
    Vec3 logExposure;
    for (int layer = 0; layer < 3; ++layer)
      logExposure[layer] = full[layer] + std::log10(std::max(crosstalk[channel][layer], 1e-12));
    light[channel] = filmLight(film, codesOfExposures(film, logExposure));
  }
  // Films multiply where monitors add: the three need not sum to white. As for a monitor, their chromaticities and
  // white make the matrix (SMPTE RP 177).
  const Vec3 white = filmLight(film, brightest(film));
  const Vec3 share = glm::inverse(light) * white;
  for (int channel = 0; channel < 3; ++channel) light[channel] *= share[channel];
  return light;
}

std::unique_ptr<DeviceModel> makeFilmModel(const Device& device) {
  return std::make_unique<FilmModel>(device);
}

}  // namespace goniolux::display
