// Watchdog: how long the interface's thread was away at most: another thread asks it every few milliseconds.
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>
#include <atomic>

namespace goniolux::test {

class Watchdog final : public QThread {
 public:
  Watchdog() {
    place_.moveToThread(QCoreApplication::instance()->thread());
    start();
  }
  ~Watchdog() override {
    stop_ = true;
    wait();
  }
  /// Milliseconds between asking and being answered, the longest so far.
  [[nodiscard]] double longest() const { return 1e-6 * static_cast<double>(longest_.load()); }
  void forget() { longest_ = 0; }

 protected:
  void run() override {
    while (!stop_) {
      QElapsedTimer clock;
      clock.start();
      std::atomic<bool> answered{false};
      auto* answer = &answered;
      QMetaObject::invokeMethod(
          &place_, [answer] { *answer = true; }, Qt::QueuedConnection);
      while (!answered && !stop_) usleep(500);
      // A test that ends while it is asked must still take its question back.
      if (!answered) QCoreApplication::removePostedEvents(&place_);
      longest_ = std::max(longest_.load(), static_cast<qint64>(clock.nsecsElapsed()));
      usleep(4000);
    }
  }

 private:
  QObject place_;
  std::atomic<bool> stop_{false};
  std::atomic<qint64> longest_{0};
};

}  // namespace goniolux::test
