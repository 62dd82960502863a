// GridRun: the rounds that a grid's estimate is made of, and what each point needs after them
// (docs/methods/intervals.md). Decisions are made from all points together, between rounds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analysis/grid_estimate.h"
#include "analysis/remainder.h"
#include "core/kept_work.h"
#include "core/progress.h"
#include "solver/solver.h"

namespace goniolux::analysis {

class GridRun {
 public:
  /// All by reference but the key, the accuracy and where finished work is kept.
  GridRun(const solver::Solver& solver, const Quantity& quantity, const std::vector<solver::Receiver>& receivers,
          std::uint64_t key, const GridAccuracy& accuracy, core::Keeping keeping);

  /// Told how much of the samples that are foreseen is done, every few seconds.
  void tellTo(std::function<void(double share)> told) { told_ = std::move(told); }

  /// What light each point sees. False when it was interrupted.
  bool plan(const core::ProgressSink& progress);
  /// A first round at some of the points; sets the samples that each point needs, between them by the needier
  /// neighbour. False when it was interrupted.
  bool pilot(const core::ProgressSink& progress);
  /// Measures what the solver misses; rounds after this add it.
  void findRemainder(double secondsLeft, const core::ProgressSink& progress);

  /// Of the points and samples that are wanted, what the time allows, by the pace of the last round: fewer samples, as
  /// long as a point gets more than it has. So a time limit is kept, and what is asked last is what is left undone.
  std::vector<std::size_t> within(const std::vector<std::size_t>& points, double secondsLeft);
  /// Fresh replicates of the points named. False when it was interrupted: then nothing has changed.
  bool round(const std::vector<std::size_t>& points, const core::ProgressSink& progress);
  void everyPointIsKnown() { everyPointIsKnown_ = true; }

  [[nodiscard]] GridEstimate estimate() const;
  [[nodiscard]] bool pointsReached(const GridEstimate& e) const;

  /// Sets the samples that points need for the accuracy asked for; returns the points to estimate anew.
  std::vector<std::size_t> refine(const GridEstimate& e);
  /// More samples for the points that may be the minimum, or for all where the mean spoils the uniformity; returns
  /// them.
  std::vector<std::size_t> refineMinimum(const GridEstimate& e);

 private:
  /// What a kept estimate must have been made of to be of use.
  struct SampleKind {
    std::uint64_t point = 0;
    std::uint32_t samples = 0, whole = 0;
    bool operator==(const SampleKind&) const = default;
  };
  [[nodiscard]] SampleKind kindOf(std::size_t point) const {
    return {point, samples_[point], static_cast<std::uint32_t>(whole_[point])};
  }
  std::vector<std::size_t> cut(const std::vector<std::size_t>& points, double secondsLeft);
  std::vector<std::size_t> chosenBefore(const std::string& part, const std::vector<std::size_t>& points);

  [[nodiscard]] bool extremesReached(const GridEstimate& e) const;
  [[nodiscard]] std::vector<std::size_t> minimumCandidates(const GridEstimate& e) const;
  [[nodiscard]] bool minimumIsWhole(const GridEstimate& e) const;
  [[nodiscard]] bool meanSpoilsUniformity(const GridEstimate& e) const;
  [[nodiscard]] double commonNoise() const;

  /// The quantity's part of a response.
  [[nodiscard]] double of(const solver::Response& response) const {
    return quantity_.factor * response[quantity_.channel];
  }
  [[nodiscard]] std::uint64_t pointKey(std::size_t point, std::uint64_t round) const;
  [[nodiscard]] double allowed(double value, double mean) const;
  [[nodiscard]] double roomFor(double value, double mean, double systematic) const;

  const solver::Solver& solver_;
  const Quantity& quantity_;
  const std::vector<solver::Receiver>& receivers_;
  std::uint64_t key_;
  GridAccuracy accuracy_;
  core::Keeping keeping_;
  std::function<void(double)> told_;
  double quantile_, margin_, roughMean_ = 0;
  std::vector<std::unique_ptr<solver::ReceiverPlan>> plans_;
  std::vector<std::uint32_t> samples_;
  std::vector<std::uint32_t> used_;              // those of the replicates that are kept
  bool everyPointIsKnown_ = false;               // the first full round is done
  double taken_ = 0;                             // samples of all rounds
  double perSecond_ = 1;                         // samples of all replicates, in the last round
  std::vector<char> whole_;                      // points that are calculated without the light solution
  std::vector<std::vector<double>> replicates_;  // [replicate][point], with what the solver misses added
  Remainder remainder_;
  std::uint64_t round_ = 0;
};

}  // namespace goniolux::analysis
