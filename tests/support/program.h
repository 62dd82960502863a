// Starts a program and keeps what it said.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "core/document.h"
#include "support/temporary_folder.h"

namespace goniolux::test {

struct Outcome {
  int exitCode = -1;  ///< -1: it did not end by itself but by a signal
  std::string out, err;
};

/// A program that runs; its standard output and error go to files until it ends.
class Running {
 public:
  /// `command`: the program (looked for in PATH when it has no '/') and its arguments. `outFile`: takes standard output
  /// instead.
  explicit Running(const std::vector<std::string>& command, const std::string& outFile = "") {
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const std::string out = outFile.empty() ? (folder_.path() / "out").string() : outFile;
    const std::string err = (folder_.path() / "err").string();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
    const int failure = posix_spawnp(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) throw std::runtime_error("cannot start " + command.front());
  }
  ~Running() {
    if (process_ < 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void signal(int number) const { kill(process_, number); }

  /// Waits for its end.
  Outcome wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(folder_.path() / "out"),
            contentOf(folder_.path() / "err")};
  }

 private:
  TemporaryFolder folder_;
  pid_t process_ = -1;
};

#ifdef GONIOLUX_PROGRAM
/// Runs goniolux with these arguments; its test program's CMakeLists.txt says where it is.
inline Outcome goniolux(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {GONIOLUX_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return Running(command).wait();
}
#endif

/// The text as one JSON document; a failed test and null when it is none, or has anything beside it.
inline core::Value oneDocument(const std::string& text) {
  core::Diagnostics diagnostics;
  core::Value value = core::parseJson(text, "standard output", diagnostics);
  for (const core::Diagnostic& diagnostic : diagnostics.all())
    ADD_FAILURE() << core::toString(diagnostic) << "\nin: " << text;
  return value;
}

}  // namespace goniolux::test
