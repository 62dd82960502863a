// Worker: a thread of its own for what would take the interface more than a moment. Pieces of work run one after the
// other in the order in which they were given; what they find goes back to the GUI thread by post().
#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <functional>

namespace goniolux::gui {

class Worker final : public QObject {
  Q_OBJECT
 public:
  explicit Worker(const QString& name, QObject* parent = nullptr);
  /// Waits for the piece that runs; pieces that have not begun are dropped.
  ~Worker() override;

  /// Runs `work` on the worker's thread. It must not throw.
  void run(std::function<void()> work);

 private:
  QThread thread_;
  std::atomic<bool> isStopping_{false};
  QObject* place_;  // lives in the thread
};

/// Runs `work` on the thread of `receiver`, soon; not at all when the receiver is gone by then.
void post(QObject* receiver, std::function<void()> work);

}  // namespace goniolux::gui
