// Runs a helper program (no shell) and waits for it.
#pragma once

#include <string>
#include <vector>

namespace goniolux::pipeline {

struct ProcessEnd {
  enum class How { exited, killed, timedOut, notStarted };
  How how = How::notStarted;
  int code = 0;        ///< exit code, or the signal that killed it
  std::string errors;  ///< what it wrote to standard error; or why it could not start
};

/// Starts `program` with these arguments; its standard output goes nowhere. Ends it when it takes longer than
/// `timeLimit_s`.
ProcessEnd runHelper(const std::string& program, const std::vector<std::string>& arguments, double timeLimit_s);

/// A program that runs.
struct StartedProcess {
  int id = 0;           ///< process id; 0: it could not be started
  int errors = -1;      ///< descriptor to read its standard error from; closed at its end by the other side
  std::string failure;  ///< why it could not be started
};

/// Starts a program as runHelper() does and does not wait. `ownGroup`: in a process group of its own.
StartedProcess startProcess(const std::string& program, const std::vector<std::string>& arguments, bool ownGroup);
/// Waits for the process and says how it ended; for id 0: not started.
ProcessEnd endOf(int id);

/// Where a helper program of this installation is: the path in the environment variable if that is set, else
/// ../libexec/NAME as seen from the running program, else NAME beside it; "" if there is none.
std::string findHelper(const std::string& name, const char* environmentVariable);

}  // namespace goniolux::pipeline
