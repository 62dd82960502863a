// Batch: the projects of `verify`, what is known of each, and the files that keep what is done, so that a batch that
// was killed goes on from there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/verify_compare.h"
#include "project/baseline.h"
#include "project/project.h"

namespace goniolux::pipeline {

struct BatchProject {
  enum class Verdict {
    passed,      ///< nothing has changed that chance and tolerance do not explain
    changed,     ///< a value has changed
    broken,      ///< it, or its baseline, cannot be read or calculated; others are not touched
    noBaseline,  ///< there is nothing to compare with
    notRun,      ///< of another shard, or the time was up
  };

  std::string path;    ///< its folder, as a person would write it
  std::string folder;  ///< of its results
  Verdict verdict = Verdict::notRun;
  std::string trouble;      ///< broken: what is wrong
  bool unfinished = false;  ///< broken because the disk was full, memory was out or it crashed: worth another try
  bool ofThisShard = true, kept = false, updated = false;
  double accuracy = 0, seconds = 0;
  std::optional<project::Baseline> baseline;
  std::optional<project::Project> project;
  std::vector<std::string> changedInputs;
  std::vector<Difference> differences;  ///< every expected value
  std::vector<std::string> remarks;
};

const char* wordFor(BatchProject::Verdict verdict);

/// Every project below the folders (or named files), sorted by path, each once; folders named "results" and those that
/// a batch wrote are passed over. Throws core::InputError for a folder that is none, and when there is no project.
std::vector<std::string> findProjects(const std::vector<std::string>& inputs);

/// What a finished calculation leaves beside its results. Kept results are used again only when the key is the same:
/// inputs, settings, and the program that made them.
struct Outcome {
  std::string key;
  double seconds = 0;
};
std::optional<Outcome> readOutcome(const std::string& folder);
void writeOutcome(const std::string& folder, const Outcome& outcome);
void forgetOutcome(const std::string& folder);

/// Part i of n.
struct Shard {
  std::size_t index = 1, count = 1;
};
/// "2/5". Throws core::InputError.
Shard shardFrom(const std::string& text);

}  // namespace goniolux::pipeline
