// Watchdog: how long the interface's thread was away at most: another thread asks it every few milliseconds. A pause is
// taken apart: what the interface's thread computed in it, how long it stood in the queue for a processor (other
// programs had it: no fault of the interface), and what is left, for which it slept: a lock, a file, the graphics.
#pragma once

#include <pthread.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QMutex>
#include <QThread>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <string>

namespace goniolux::test {

/// Milliseconds of one pause.
struct Pause {
  double clock = 0;    ///< between being asked and answering
  double cpu = 0;      ///< of the interface's thread in it
  double starved = 0;  ///< able to run, but without a processor (Linux' schedstat; 0 where the kernel does not tell)
  [[nodiscard]] double asleep() const { return std::max(0.0, clock - cpu - starved); }
};

class Watchdog final : public QThread {
 public:
  /// Made on the interface's thread.
  Watchdog() : schedule_("/proc/self/task/" + std::to_string(syscall(SYS_gettid)) + "/schedstat") {
    pthread_getcpuclockid(pthread_self(), &cpuClock_);
    place_.moveToThread(QCoreApplication::instance()->thread());
    start();
  }
  ~Watchdog() override {
    stop_ = true;
    wait();
  }
  /// The pause in which the clock ran longest, and the one in which the interface's thread computed most.
  [[nodiscard]] Pause longest() const { return copyOf(longest_); }
  [[nodiscard]] Pause busiest() const { return copyOf(busiest_); }
  void forget() {
    const QMutexLocker lock(&mutex_);
    longest_ = busiest_ = {};
  }

  /// Does not look while it lives: what a test does itself on the interface's thread, screenshots above all, is not the
  /// interface's work.
  class Blindfold {
   public:
    explicit Blindfold(Watchdog* watchdog) : watchdog_(watchdog) {
      if (watchdog_ != nullptr) ++watchdog_->blind_;
    }
    ~Blindfold() {
      if (watchdog_ != nullptr) --watchdog_->blind_;
    }
    Blindfold(const Blindfold&) = delete;
    Blindfold& operator=(const Blindfold&) = delete;

   private:
    Watchdog* watchdog_;
  };

 protected:
  void run() override {
    while (!stop_) {
      const bool wasBlind = blind_ > 0;
      const double cpu = cpuMilliseconds(), starved = starvedMilliseconds();
      QElapsedTimer clock;
      clock.start();
      Pause pause;
      std::atomic<bool> answered{false};
      // The answer is timed where it is given: this thread, too, may have to wait for its turn.
      QMetaObject::invokeMethod(
          &place_,
          [&] {
            pause = {1e-6 * static_cast<double>(clock.nsecsElapsed()), cpuMilliseconds() - cpu,
                     starvedMilliseconds() - starved};
            answered = true;
          },
          Qt::QueuedConnection);
      bool isBlind = wasBlind;
      while (!answered && !stop_) {
        isBlind = isBlind || blind_ > 0;
        usleep(500);
      }
      // A test that ends while it is asked must still take its question back.
      if (!answered) return QCoreApplication::removePostedEvents(&place_);
      if (!isBlind && blind_ == 0) {
        const QMutexLocker lock(&mutex_);
        if (pause.clock > longest_.clock) longest_ = pause;
        if (pause.cpu > busiest_.cpu) busiest_ = pause;
      }
      usleep(4000);
    }
  }

 private:
  [[nodiscard]] Pause copyOf(const Pause& pause) const {
    const QMutexLocker lock(&mutex_);
    return pause;
  }
  [[nodiscard]] double cpuMilliseconds() const {
    timespec t{};
    clock_gettime(cpuClock_, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
  }
  [[nodiscard]] double starvedMilliseconds() const {
    unsigned long long ran = 0, waited = 0;
    if (std::FILE* file = std::fopen(schedule_.c_str(), "r")) {
      if (std::fscanf(file, "%llu %llu", &ran, &waited) != 2) waited = 0;
      std::fclose(file);
    }
    return 1e-6 * static_cast<double>(waited);
  }

  QObject place_;
  clockid_t cpuClock_{};
  std::string schedule_;
  std::atomic<bool> stop_{false};
  std::atomic<int> blind_{0};
  mutable QMutex mutex_;
  Pause longest_, busiest_;
};

}  // namespace goniolux::test
