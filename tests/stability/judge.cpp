#include "stability/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "analysis/grid_estimate.h"
#include "core/two_sample.h"

namespace goniolux::stability {
namespace {

using core::Estimate;
using project::GridResult;
using project::Results;

constexpr double falseAlarms = 1e-4;  // of a check
constexpr double dof = analysis::replicateCount - 1;

/// How much wider an interval must be, so that `values` of them together fail by chance in one case of 10 000.
double stretch(double confidence, std::size_t values) {
  return core::studentTail(dof, falseAlarms / static_cast<double>(std::max<std::size_t>(1, values))) /
         core::studentTail(dof, 1 - confidence);
}

const GridResult* findGrid(const Results& results, const std::string& name) {
  const auto found =
      std::find_if(results.grids.begin(), results.grids.end(), [&](const GridResult& g) { return g.name == name; });
  return found == results.grids.end() ? nullptr : &*found;
}

Judgement wrong(std::string why) {
  return {Outcome::wrong, std::move(why)};
}

}  // namespace

Judgement judge(const std::vector<Figure>& figures, double confidence) {
  const double factor = stretch(confidence, figures.size());
  Judgement result;
  double most = -1;
  std::size_t off = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Figure& f = figures[i];
    const double half = f.found.halfWidth();
    if (!std::isfinite(f.found.value) || !std::isfinite(half)) return wrong(fmt::format("value {} is no number", i));
    const double room = f.exact ? 0 : factor * f.found.statistical + half - f.found.statistical + f.known;
    const double apart = std::abs(f.found.value - f.reference);
    const bool isOff = apart > room || (f.exact && half > 0);
    off += isOff ? 1 : 0;
    const double weight = room > 0 ? apart / room : isOff ? HUGE_VAL : 0;
    if (weight <= most && !(isOff && off == 1)) continue;
    most = weight;
    result.detail = fmt::format("{:.6g} ± {:.2g}, reference {:.6g}", f.found.value, half, f.reference);
    if (f.reference != 0) result.detail += fmt::format(" ({:+.2g} %)", 100 * (f.found.value / f.reference - 1));
  }
  if (off == 0) return result;
  result.outcome = Outcome::wrong;
  if (figures.size() > 1) result.detail += fmt::format("; {} of {} are off", off, figures.size());
  return result;
}

Judgement judgeGrid(const Check& check, const Results& results) {
  const GridResult* grid = findGrid(results, check.text("grid"));
  if (grid == nullptr) return wrong("there is no grid \"" + check.text("grid") + '"');
  const double tolerance = check.number("tolerance"), absolute = check.number("absolute");
  std::vector<Figure> figures;
  if (check.kind == "weighted") {
    Figure sum;
    sum.reference = check.number("value");
    sum.known = tolerance * std::abs(sum.reference);
    const auto& weights = check.row.find("weights")->array();
    if (weights.size() != grid->values.size()) return wrong("another number of points than weights");
    double squares = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const Estimate point = grid->pointEstimate(i);
      const double w = weights[i].number();
      sum.found.value += w * point.value;
      squares += w * w * point.statistical * point.statistical;
      sum.found.systematic["all"] += std::abs(w) * point.systematic.at("all");
    }
    sum.found.statistical = std::sqrt(squares);
    figures.push_back(sum);
  } else {
    const auto& values = check.row.find("values")->array();
    if (values.size() != grid->values.size()) return wrong("another number of points than references");
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i].isNull()) continue;
      const double reference = values[i].number(), known = tolerance * std::abs(reference) + absolute;
      figures.push_back({reference, grid->pointEstimate(i), known, tolerance == 0 && absolute == 0});
    }
  }
  Judgement result = judge(figures, results.confidence);
  if (result.outcome == Outcome::right && !results.reached) result.outcome = Outcome::wide;
  return result;
}

Judgement judgeSame(const Check& check, const Results& one, const Results& other) {
  const GridResult *a = findGrid(one, check.text("grid")), *b = findGrid(other, check.text("grid"));
  if (a == nullptr || b == nullptr || a->values.size() != b->values.size()) return wrong("the grids are not the same");
  if (check.flag("exact")) {
    for (std::size_t i = 0; i < a->values.size(); ++i)
      if (std::bit_cast<std::uint64_t>(a->values[i]) != std::bit_cast<std::uint64_t>(b->values[i]))
        return wrong(fmt::format("point {}: {:.17g} and {:.17g}", i, a->values[i], b->values[i]));
    return {Outcome::right, "bit for bit"};
  }
  std::vector<Figure> figures;
  for (std::size_t i = 0; i < a->values.size(); ++i) {
    if (std::isnan(a->values[i]) && std::isnan(b->values[i])) continue;
    const Estimate was = a->pointEstimate(i), is = b->pointEstimate(i);
    Figure f{was.value, is, was.systematic.at("all") + 1e-4 * std::abs(was.value), false};
    f.found.statistical = std::hypot(was.statistical, is.statistical);
    figures.push_back(f);
  }
  Judgement result = judge(figures, one.confidence);
  if (result.outcome == Outcome::right && check.row.find("mean_tolerance") != nullptr) {
    const double change = b->mean.value / a->mean.value - 1;
    result.detail = fmt::format("the mean changes by {:.1g}", change);
    if (!(std::abs(change) <= check.number("mean_tolerance"))) return wrong(result.detail);
  }
  if (result.outcome == Outcome::right && !(one.reached && other.reached)) result.outcome = Outcome::wide;
  return result;
}

Judgement judgeFinite(const Check& check, const Results& results) {
  for (const project::ObserverResult& observer : results.observers) {
    if (observer.name != check.text("observer")) continue;
    const Estimate& e = observer.value;
    if (std::isfinite(e.value) && std::isfinite(e.halfWidth()))
      return {results.reached ? Outcome::right : Outcome::wide,
              fmt::format("{:.1f} ± {:.2g}, {} luminaires rated", e.value, e.halfWidth(), observer.sources.size())};
    // No rating is an answer where the results say that there is none.
    if (!results.reached && results.reachedText.find(observer.name) != std::string::npos)
      return {Outcome::right, results.reachedText};
    return wrong(fmt::format("the rating is {} ± {}", e.value, e.halfWidth()));
  }
  return wrong("there is no rating");
}

}  // namespace goniolux::stability
