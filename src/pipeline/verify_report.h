// What `verify` says: a text, a JSON document, JUnit XML for continuous integration, and a page to look at.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"
#include "pipeline/batch.h"

namespace goniolux::pipeline {

struct BatchSummary {
  std::vector<BatchProject> projects;
  double falseAlarms = 0.01;  ///< of the whole batch
  std::size_t values = 0;     ///< that share it
  double tolerance = 0;
  double seconds = 0;
  std::string programVersion;
};

std::size_t countOf(const BatchSummary& batch, BatchProject::Verdict verdict);

std::string textOf(const BatchSummary& batch);
core::Value documentOf(const BatchSummary& batch);
/// The form that Jenkins, GitLab and GitHub read: a test case per project.
std::string junitOf(const BatchSummary& batch);
/// HTML in one file: summary, what has changed with baseline, run and difference of each grid side by side.
std::string pageOf(const BatchSummary& batch);

}  // namespace goniolux::pipeline
