// Observe: the glare ratings of a project's observers.
#pragma once

#include "core/kept_work.h"
#include "core/progress.h"
#include "pipeline/engine.h"
#include "project/results.h"

namespace goniolux::pipeline {

/// Rates every observer into `results`, sharing what is left of the time limit; says what CIE 117 does not vouch for
/// among Results::leftOut. Throws core::InputError when an eye lies inside a solid object.
void rateObservers(const project::Project& project, const Engine& engine, double secondsLeft,
                   core::ProgressSink& progress, project::Results& results, const core::Keeping& keeping = {});

}  // namespace goniolux::pipeline
