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

StartedProcess startProcess(const std::string& program, const std::vector<std::string>& arguments, bool ownGroup) {
  StartedProcess started;
  std::array<int, 2> pipeEnds{};
  if (pipe2(pipeEnds.data(), O_CLOEXEC) != 0) {
    started.failure = std::strerror(errno);
    return started;
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
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  if (ownGroup) posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = 0;
  const int failed = posix_spawn(&child, program.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(pipeEnds[1]);
  if (failed != 0) {
    close(pipeEnds[0]);
    started.failure = std::strerror(failed);
    return started;
  }
  started.id = child;
  started.errors = pipeEnds[0];
  return started;
}

ProcessEnd endOf(int id) {
  ProcessEnd end;
  if (id <= 0) return end;
  int status = 0;
  while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  end.how = WIFSIGNALED(status) ? ProcessEnd::How::killed : ProcessEnd::How::exited;
  end.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  return end;
}

ProcessEnd runHelper(const std::string& program, const std::vector<std::string>& arguments, double timeLimit_s) {
  const StartedProcess child = startProcess(program, arguments, false);
  ProcessEnd end;
  if (child.id == 0) {
    end.errors = child.failure;
    return end;
  }
  const auto limit = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeLimit_s));
  std::string errors;
  const bool inTime = readAll(child.errors, Clock::now() + limit, errors);
  close(child.errors);
  if (!inTime) kill(child.id, SIGKILL);
  end = endOf(child.id);
  if (!inTime) end.how = ProcessEnd::How::timedOut;
  end.errors = std::move(errors);
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
