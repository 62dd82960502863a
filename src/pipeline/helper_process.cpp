#include "pipeline/helper_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>

extern char** environ;  // POSIX asks the program to declare it

namespace goniolux::pipeline {
namespace {

using Clock = std::chrono::steady_clock;

/// Reads until the other side closes or the deadline passes; false when it passed.
bool readAll(int descriptor, Clock::time_point deadline, std::string& text) {
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    pollfd wait{descriptor, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(left));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    std::array<char, 4096> buffer;
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

ProcessEnd runHelper(const std::string& program, const std::vector<std::string>& arguments, double timeLimit_s) {
  ProcessEnd end;
  std::array<int, 2> pipeEnds{};
  if (pipe2(pipeEnds.data(), O_CLOEXEC) != 0) {
    end.errors = std::strerror(errno);
    return end;
  }
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipeEnds[1], 2);
  pid_t child = 0;
  const int failed = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(pipeEnds[1]);
  if (failed != 0) {
    close(pipeEnds[0]);
    end.errors = std::strerror(failed);
    return end;
  }

  const auto limit = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeLimit_s));
  const bool inTime = readAll(pipeEnds[0], Clock::now() + limit, end.errors);
  close(pipeEnds[0]);
  if (!inTime) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!inTime) {
    end.how = ProcessEnd::How::timedOut;
  } else if (WIFSIGNALED(status)) {
    end.how = ProcessEnd::How::killed;
    end.code = WTERMSIG(status);
  } else {
    end.how = ProcessEnd::How::exited;
    end.code = WEXITSTATUS(status);
  }
  return end;
}

std::string findHelper(const std::string& name, const char* environmentVariable) {
  namespace fs = std::filesystem;
  if (const char* named = std::getenv(environmentVariable); named != nullptr && *named != '\0') return named;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  for (const fs::path& candidate : {self.parent_path().parent_path() / "libexec" / name, self.parent_path() / name}) {
    if (fs::exists(candidate, error)) return candidate.string();
  }
  return {};
}

}  // namespace goniolux::pipeline
