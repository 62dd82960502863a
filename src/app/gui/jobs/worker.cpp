#include "app/gui/jobs/worker.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <utility>

namespace goniolux::gui {

Worker::Worker(const QString& name, QObject* parent) : QObject(parent), place_(new QObject) {
  thread_.setObjectName(name);
  place_->moveToThread(&thread_);
  connect(&thread_, &QThread::finished, place_, &QObject::deleteLater);
  thread_.start();
  // The interface goes first: calculations use every processor. Threads that this one makes inherit it. (On Linux a
  // thread's nice value is its own; QThread's priorities change nothing there.)
  constexpr int behind = 10;
  run([] { setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), behind); });
}

Worker::~Worker() {
  isStopping_ = true;
  // Asked for by the thread itself: a quit() from here is lost when its event loop has not begun yet.
  post(place_, [this] { thread_.quit(); });
  thread_.wait();
}

void Worker::run(std::function<void()> work) {
  post(place_, [this, task = std::move(work)] {
    if (!isStopping_) task();
  });
}

void post(QObject* receiver, std::function<void()> work) {
  QMetaObject::invokeMethod(
      receiver, [task = std::move(work)] { task(); }, Qt::QueuedConnection);
}

}  // namespace goniolux::gui
