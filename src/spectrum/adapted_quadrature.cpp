#include "spectrum/adapted_quadrature.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "spectrum/dense_solve.h"

namespace goniolux::spectrum {
namespace {

// Pull towards the weights of linear interpolation, as a share of the mean diagonal of the normal equations: decides
// where the paths leave it open.
constexpr double pullToHats = 1e-7;
// Mean squared error, in tolerances, at which there is nothing left to improve.
constexpr double negligible = 1e-8;

// Weights of one channel of one source: sum_k W_k T_j(lambda_k) shall be response_j for all paths j, and sum_k W_k =
// white.
struct Problem {
  std::size_t source, channel;
  double white = 0;
  std::vector<double> response = {},
                      importance = {};  // per path; importance = 1 / (tolerated absolute error)^2 / paths
};

// Normal equations of one problem on the present nodes.
struct Equations {
  std::vector<double> gram, right;  // n x n, n
};

class Search {
 public:
  Search(int count, const SpectralQuadrature& control, const std::vector<LightPath>& paths)
      : n_(static_cast<std::size_t>(count)), control_(control), paths_(paths.size()) {
    transmittance_.resize(control.wavelengths.size(), std::vector<double>(paths_));
    for (std::size_t j = 0; j < paths_; ++j) {
      assert(paths[j].transmittance.size() == control.wavelengths.size());
      for (std::size_t i = 0; i < transmittance_.size(); ++i) transmittance_[i][j] = paths[j].transmittance[i];
    }
    for (std::size_t s = 0; s < control.weights.size(); ++s) {
      for (std::size_t c = 0; c < responseChannels; ++c) addProblem(s, c, paths);
    }
  }

  SpectralQuadrature at(const std::vector<double>& wavelengths) {
    const std::vector<double>& known = control_.wavelengths;
    std::vector<std::size_t> nodes;
    for (const double wanted : wavelengths) {
      auto next = std::lower_bound(known.begin(), known.end(), wanted);
      if (next == known.end() || (next != known.begin() && wanted - *(next - 1) < *next - wanted)) --next;
      nodes.push_back(static_cast<std::size_t>(next - known.begin()));
    }
    nodes_ = apart(std::move(nodes));
    return result();
  }

  SpectralQuadrature run() {
    std::vector<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& start : {startByResponse(), startEvenly()}) {
      nodes_ = start;
      const double reached = improve();
      if (reached < least) {
        least = reached;
        best = nodes_;
      }
      if (least < negligible) break;
    }
    nodes_ = best;
    return result();
  }

 private:
  void addProblem(std::size_t source, std::size_t channel, const std::vector<LightPath>& paths) {
    Problem problem{source, channel};
    problem.response.assign(paths_, 0);
    for (std::size_t i = 0; i < transmittance_.size(); ++i) {
      const double weight = control_.weights[source][i][channel];
      if (weight == 0) continue;
      problem.white += weight;
      for (std::size_t j = 0; j < paths_; ++j) problem.response[j] += weight * transmittance_[i][j];
    }
    if (!(problem.white > 0)) return;  // no light in this channel: its weights stay 0
    for (std::size_t j = 0; j < paths_; ++j) {
      const double tolerance = paths[j].tolerance[channel];
      const double tolerated = tolerance * std::max(problem.response[j], darkestShare * problem.white);
      problem.importance.push_back(tolerance > 0 ? 1 / (tolerated * tolerated * static_cast<double>(paths_)) : 0);
    }
    problems_.push_back(std::move(problem));
  }

  // Nodes at equal shares of all responses together.
  std::vector<std::size_t> startByResponse() const {
    std::vector<double> density(transmittance_.size());
    for (const auto& weights : control_.weights) {
      for (std::size_t i = 0; i < density.size(); ++i) density[i] += weights[i][0] + weights[i][1] + weights[i][2];
    }
    double total = 0;
    for (const double d : density) total += d;
    std::vector<std::size_t> nodes;
    double sum = 0;
    for (std::size_t i = 0; i < density.size() && nodes.size() < n_; ++i) {
      sum += density[i];
      if (sum >= total * (static_cast<double>(nodes.size()) + 0.5) / static_cast<double>(n_)) nodes.push_back(i);
    }
    while (nodes.size() < n_) nodes.push_back(nodes.empty() ? 0 : std::min(nodes.back() + 1, density.size() - 1));
    return apart(std::move(nodes));
  }

  std::vector<std::size_t> startEvenly() const {
    constexpr double from = 430, to = 670;
    std::vector<std::size_t> nodes;
    for (std::size_t k = 0; k < n_; ++k) {
      const double wanted = from + (to - from) * (static_cast<double>(k) + 0.5) / static_cast<double>(n_);
      const auto at = std::lower_bound(control_.wavelengths.begin(), control_.wavelengths.end(), wanted);
      nodes.push_back(static_cast<std::size_t>(at - control_.wavelengths.begin()));
    }
    return apart(std::move(nodes));
  }

  // Strictly ascending and inside the table.
  std::vector<std::size_t> apart(std::vector<std::size_t> nodes) const {
    for (std::size_t k = 1; k < n_; ++k) nodes[k] = std::max(nodes[k], nodes[k - 1] + 1);
    for (std::size_t k = n_; k-- > 0;) nodes[k] = std::min(nodes[k], transmittance_.size() - (n_ - k));
    return nodes;
  }

  // Moves one node at a time while that lowers the misfit, in steps from coarse to fine.
  double improve() {
    equations_.assign(problems_.size(), {std::vector<double>(n_ * n_), std::vector<double>(n_)});
    for (std::size_t k = 0; k < n_; ++k) replace(k, nodes_[k]);
    double misfit = misfitOfNodes();
    for (const std::size_t step : {32, 16, 8, 4, 2, 1}) {
      for (bool moved = true; moved && misfit > negligible;) {
        moved = false;
        for (std::size_t k = 0; k < n_; ++k) {
          for (const bool up : {false, true}) {
            const std::size_t old = nodes_[k];
            if (!up && old < step) continue;
            const std::size_t place = up ? old + step : old - step;
            const std::size_t below = k == 0 ? 0 : nodes_[k - 1] + 1;
            const std::size_t above = k + 1 == n_ ? transmittance_.size() : nodes_[k + 1];
            if (place < below || place >= above) continue;
            const auto kept = equations_;
            replace(k, place);
            const double attempt = misfitOfNodes();
            if (attempt < 0.999 * misfit) {
              misfit = attempt;
              moved = true;
            } else {
              nodes_[k] = old;
              equations_ = kept;
            }
          }
        }
      }
    }
    return misfit;
  }

  // Puts node k at a place and renews its row and column of the normal equations.
  void replace(std::size_t k, std::size_t place) {
    nodes_[k] = place;
    const std::vector<double>& own = transmittance_[place];
    std::vector<double> product(paths_);
    for (std::size_t l = 0; l < n_; ++l) {
      const std::vector<double>& other = transmittance_[nodes_[l]];
      for (std::size_t j = 0; j < paths_; ++j) product[j] = own[j] * other[j];
      for (std::size_t p = 0; p < problems_.size(); ++p) {
        const std::vector<double>& importance = problems_[p].importance;
        double sum = 0;
        for (std::size_t j = 0; j < paths_; ++j) sum += importance[j] * product[j];
        equations_[p].gram[k * n_ + l] = equations_[p].gram[l * n_ + k] = sum;
      }
    }
    for (std::size_t p = 0; p < problems_.size(); ++p) {
      const Problem& problem = problems_[p];
      double sum = 0;
      for (std::size_t j = 0; j < paths_; ++j) sum += problem.importance[j] * own[j] * problem.response[j];
      equations_[p].right[k] = sum;
    }
  }

  double misfitOfNodes() const {
    double sum = 0;
    for (std::size_t p = 0; p < problems_.size(); ++p) sum += misfit(p, weights(p));
    return sum;
  }

  // Sum over the paths of importance times squared error.
  double misfit(std::size_t p, const std::vector<double>& w) const {
    const Problem& problem = problems_[p];
    double sum = 0;
    for (std::size_t j = 0; j < paths_; ++j) {
      if (problem.importance[j] == 0) continue;
      double error = -problem.response[j];
      for (std::size_t k = 0; k < n_; ++k) error += w[k] * transmittance_[nodes_[k]][j];
      sum += problem.importance[j] * error * error;
    }
    return sum;
  }

  // Least squares under sum = white and no weight below 0: nodes whose weights come out negative are given up for this
  // channel, the worst first.
  std::vector<double> weights(std::size_t p) const {
    const Problem& problem = problems_[p];
    const Equations& e = equations_[p];
    const std::vector<double> hats = hatWeights(problem);
    double diagonal = 0;
    for (std::size_t k = 0; k < n_; ++k) diagonal += e.gram[k * n_ + k];
    const double pull = pullToHats * diagonal / static_cast<double>(n_) + std::numeric_limits<double>::min();

    std::vector<std::size_t> used(n_);
    for (std::size_t k = 0; k < n_; ++k) used[k] = k;
    while (used.size() > 1) {
      const std::size_t m = used.size(), size = m + 1, width = size + 1;  // with the multiplier of the sum
      std::vector<double> system(size * width, 0.0);
      for (std::size_t a = 0; a < m; ++a) {
        for (std::size_t b = 0; b < m; ++b) system[a * width + b] = e.gram[used[a] * n_ + used[b]];
        system[a * width + a] += pull;
        system[a * width + m] = system[m * width + a] = diagonal;  // scaled like the rest
        system[a * width + size] = e.right[used[a]] + pull * hats[used[a]];
      }
      system[m * width + size] = diagonal * problem.white;
      for (double& coefficient : system) coefficient /= diagonal > 0 ? diagonal : 1;
      if (diagonal <= 0 || !solveDense(system, size)) return hats;
      std::size_t worst = m;
      for (std::size_t a = 0; a < m; ++a) {
        const double value = system[a * width + size];
        if (value < 0 && (worst == m || value < system[worst * width + size])) worst = a;
      }
      if (worst == m) {
        std::vector<double> result(n_, 0.0);
        for (std::size_t a = 0; a < m; ++a) result[used[a]] = system[a * width + size];
        return result;
      }
      used.erase(used.begin() + static_cast<std::ptrdiff_t>(worst));
    }
    std::vector<double> result(n_, 0.0);
    result[used.front()] = problem.white;
    return result;
  }

  // The control's weights shared between the two nodes around each wavelength: linear interpolation of T.
  std::vector<double> hatWeights(const Problem& problem) const {
    std::vector<double> result(n_, 0.0);
    std::size_t above = 0;  // first node at or above the wavelength
    for (std::size_t i = 0; i < transmittance_.size(); ++i) {
      while (above < n_ && nodes_[above] < i) ++above;
      const double weight = control_.weights[problem.source][i][problem.channel];
      if (above == 0 || above == n_) {
        result[above == 0 ? 0 : n_ - 1] += weight;
        continue;
      }
      const double low = control_.wavelengths[nodes_[above - 1]], high = control_.wavelengths[nodes_[above]];
      const double share = (control_.wavelengths[i] - low) / (high - low);
      result[above] += share * weight;
      result[above - 1] += (1 - share) * weight;
    }
    return result;
  }

  SpectralQuadrature result() {
    equations_.assign(problems_.size(), {std::vector<double>(n_ * n_), std::vector<double>(n_)});
    for (std::size_t k = 0; k < n_; ++k) replace(k, nodes_[k]);
    SpectralQuadrature quadrature;
    quadrature.scheme = "adapted:" + std::to_string(n_);
    quadrature.values = NodeValues::sampled;
    for (const std::size_t node : nodes_) quadrature.wavelengths.push_back(control_.wavelengths[node]);
    quadrature.weights.assign(control_.weights.size(), std::vector<Response>(n_, Response{}));
    for (std::size_t p = 0; p < problems_.size(); ++p) {
      const std::vector<double> w = weights(p);
      for (std::size_t k = 0; k < n_; ++k) quadrature.weights[problems_[p].source][k][problems_[p].channel] = w[k];
    }
    return quadrature;
  }

  std::size_t n_;
  const SpectralQuadrature& control_;
  std::size_t paths_;
  std::vector<std::vector<double>> transmittance_;  // [wavelength][path]
  std::vector<Problem> problems_;
  std::vector<std::size_t> nodes_;  // indices of the control's wavelengths, ascending
  std::vector<Equations> equations_;
};

}  // namespace

SpectralQuadrature adaptedQuadrature(int count, const SpectralQuadrature& control,
                                     const std::vector<LightPath>& paths) {
  assert(count >= 1 && static_cast<std::size_t>(count) <= control.wavelengths.size());
  return Search(count, control, paths).run();
}

SpectralQuadrature adaptedWeights(const std::vector<double>& wavelengths, const SpectralQuadrature& control,
                                  const std::vector<LightPath>& paths) {
  assert(!wavelengths.empty() && wavelengths.size() <= control.wavelengths.size());
  SpectralQuadrature quadrature = Search(static_cast<int>(wavelengths.size()), control, paths).at(wavelengths);
  quadrature.wavelengths = wavelengths;
  return quadrature;
}

}  // namespace goniolux::spectrum
