#include "pipeline/process_pool.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace goniolux::pipeline {

ProcessPool::~ProcessPool() {
  killAll();
}

void ProcessPool::start(std::size_t tag, const std::string& program, const std::vector<std::string>& arguments) {
  Child child{tag, startProcess(program, arguments, true), "", Clock::now()};
  child.errors = child.process.failure;
  children_.push_back(std::move(child));
}

std::optional<ProcessPool::Ended> ProcessPool::wait(double seconds) {
  const auto deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (true) {
    for (std::size_t i = 0; i < children_.size(); ++i) {
      Child& child = children_[i];
      if (child.process.errors >= 0) continue;  // it still speaks
      Ended ended{child.tag, endOf(child.process.id),
                  std::chrono::duration<double>(Clock::now() - child.began).count()};
      ended.end.errors = std::move(child.errors);
      children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(i));
      return ended;
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0 || children_.empty()) return std::nullopt;
    std::vector<pollfd> waits;
    for (const Child& child : children_) waits.push_back({child.process.errors, POLLIN, 0});
    if (poll(waits.data(), waits.size(), static_cast<int>(left)) <= 0) continue;
    for (std::size_t i = 0; i < children_.size(); ++i) {
      if (waits[i].revents == 0) continue;
      std::array<char, 4096> buffer;
      const ssize_t count = read(children_[i].process.errors, buffer.data(), buffer.size());
      if (count > 0) {
        children_[i].errors.append(buffer.data(), static_cast<std::size_t>(count));
      } else if (count == 0 || errno != EINTR) {
        close(children_[i].process.errors);
        children_[i].process.errors = -1;
      }
    }
  }
}

void ProcessPool::killAll() {
  for (Child& child : children_) {
    if (child.process.id > 0) {
      kill(child.process.id, SIGKILL);
      endOf(child.process.id);
    }
    if (child.process.errors >= 0) close(child.process.errors);
  }
  children_.clear();
}

}  // namespace goniolux::pipeline
