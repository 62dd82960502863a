// Diagnostics: what a reader or a check has to say about its input. A reader returns a value and all its diagnostics
// together; a stage ends in one InputError that lists them. Library code never prints and never exits.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace goniolux::core {

/// Where something stands in a file. Lines and columns count from 1; 0 means "the file as a whole".
struct SourcePosition {
  std::string file;
  int line = 0;
  int column = 0;
};

enum class Severity { warning, error };

struct Diagnostic {
  Severity severity = Severity::error;
  SourcePosition position;
  std::string rule;     ///< short stable name, e.g. "unknown-key"
  std::string message;  ///< what is wrong; what to do
};

/// "FILE:LINE:COLUMN: error: MESSAGE" (line and column left out where they are 0).
std::string toString(const Diagnostic& diagnostic);

/// A list of diagnostics that grows while an input is read.
class Diagnostics {
 public:
  void error(SourcePosition position, std::string rule, std::string message);
  void warning(SourcePosition position, std::string rule, std::string message);
  void append(const Diagnostics& other);

  [[nodiscard]] bool hasErrors() const;
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return list_; }

 private:
  std::vector<Diagnostic> list_;
};

/// Bad input or usage: exit code 2. Carries every error and warning that was found.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Diagnostics diagnostics);
  InputError(SourcePosition position, std::string rule, std::string message);
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  Diagnostics diagnostics_;
};

/// The work could not be finished (disk full, out of memory, interrupted): exit code 3.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace goniolux::core
