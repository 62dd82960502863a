// KeptRun: what a long run leaves beside its results while it works, in the results folder: checkpoint/ with all that
// is finished, so that `--resume` goes on from there, and log.jsonl.
#pragma once

#include <memory>
#include <string>

#include "core/kept_work.h"
#include "core/parameter.h"
#include "pipeline/run_log.h"
#include "pipeline/stage.h"
#include "project/project.h"
#include "solver/solver.h"

namespace goniolux::pipeline {

class KeptRun {
 public:
  /// With the option "resume", takes up what an earlier run of the same verb with the same inputs and settings
  /// finished. Throws core::InputError naming what is no longer the same, or when the checkpoint is damaged.
  KeptRun(const std::string& verb, const StageRequest& request, const project::Project& project,
          const std::string& folder, core::ProgressSink& progress);

  [[nodiscard]] core::ProgressSink& progress() { return log_; }
  [[nodiscard]] core::Keeping keeping() { return {&work_, ""}; }

  /// The run ends. Finished: the checkpoint is removed. Interrupted or out of time: it is written, and the report's
  /// text says how to go on.
  void close(StageReport& report, bool isFinished);

 private:
  std::string verb_;
  RunLog log_;
  core::KeptWork work_;
};

/// The flag --resume.
core::Parameter resumeOption();

/// What work costs from here on, with what the parts of it that were kept had cost.
class Meter {
 public:
  Meter(const solver::Solver& solver, const core::Keeping& keeping);
  ~Meter();
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;
  [[nodiscard]] core::Spent spent() const;

 private:
  [[nodiscard]] core::Spent now() const;

  const solver::Solver& solver_;
  core::KeptWork* kept_;
  core::Spent start_;
};

}  // namespace goniolux::pipeline
