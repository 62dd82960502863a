// RunLog: log.jsonl of the results folder: what a run did and when, one JSON object per line. A progress sink that
// writes down what it hears and passes it on.
#pragma once

#include <map>
#include <string>

#include "core/document.h"
#include "core/progress.h"

namespace goniolux::pipeline {

class RunLog final : public core::ProgressSink {
 public:
  /// Goes on with the log that is there when `goesOn`, else a new one replaces it. Nothing is written before the run is
  /// a few seconds old or something is finished: a project that turns out to be wrong leaves no file.
  RunLog(core::ProgressSink& outer, const std::string& folder, bool goesOn);
  ~RunLog() override;
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  void progress(const std::string& task, double fraction, const std::string& reached) override;
  void note(const std::string& message) override;
  /// A line of another kind.
  void event(const std::string& kind, const core::Value& members);
  /// The last line; without it the run ended by an error.
  void end(const core::Value& members);
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  void write();

  core::ProgressSink& outer_;
  std::string file_, pending_;
  bool goesOn_, isOpen_ = false, isEnded_ = false;
  double begin_, lastLine_ = 0;
  std::map<std::string, double> told_;  // task: share done as last written
};

}  // namespace goniolux::pipeline
