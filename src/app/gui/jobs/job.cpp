#include "app/gui/jobs/job.h"

#include <exception>
#include <utility>

#include "app/gui/jobs/worker.h"

namespace goniolux::gui {

void JobProgress::progress(const std::string& task, double fraction, const std::string& reached) {
  {
    QMutexLocker lock(&mutex_);
    while (paused_ && !cancelled()) resumed_.wait(&mutex_, 200);
  }
  // Twenty a second are enough for the eye.
  if (sinceShown_.isValid() && sinceShown_.elapsed() < 50 && fraction < 1) return;
  sinceShown_.start();
  publish([job = &job_, fraction, t = QString::fromStdString(task), r = QString::fromStdString(reached)] {
    job->fraction_ = fraction;
    job->task_ = t;
    job->reached_ = r;
    Q_EMIT job->progressed();
  });
}

void JobProgress::note(const std::string& message) {
  publish([job = &job_, text = QString::fromStdString(message)] { Q_EMIT job->noted(text); });
}

void JobProgress::publish(std::function<void()> deliver) {
  post(&job_, std::move(deliver));
}

void JobProgress::setPaused(bool paused) {
  QMutexLocker lock(&mutex_);
  paused_ = paused;
  resumed_.wakeAll();
}

Job::Job(QString title, Work work, QObject* parent)
    : QObject(parent), title_(std::move(title)), work_(std::move(work)), progress_(*this) {}

double Job::seconds() const {
  return isOver() ? lasted_ : clock_.isValid() ? 1e-3 * static_cast<double>(clock_.elapsed()) : 0;
}

double Job::secondsLeft() const {
  if (state_ != State::running || fraction_ < 0.02) return -1;
  return seconds() * (1 - fraction_) / fraction_;
}

void Job::stop() {
  progress_.cancel();
  progress_.setPaused(false);
  if (state_ == State::waiting) setState(State::stopped);
}

void Job::setPaused(bool paused) {
  if (isOver()) return;
  progress_.setPaused(paused);
  setState(paused ? State::paused : State::running);
}

void Job::setState(State state) {
  if (isOver()) return;
  if (state >= State::done) lasted_ = seconds();
  state_ = state;
  Q_EMIT progressed();
  if (isOver()) Q_EMIT over();
}

void Job::execute() {
  if (progress_.cancelled()) return;
  post(this, [this] {
    clock_.start();
    if (state_ == State::waiting) setState(State::running);
  });
  QString failure;
  core::Diagnostics found;
  bool failed = true;
  try {
    work_(progress_);
    failed = false;
  } catch (const core::InputError& error) {
    failure = QString::fromUtf8(error.what());
    found = error.diagnostics();
  } catch (const std::bad_alloc&) {
    failure = tr("There is not enough memory for this; ask for less accuracy, fewer points or a smaller picture.");
  } catch (const std::exception& error) {
    failure = QString::fromUtf8(error.what());
  }
  const bool stopped = progress_.cancelled();
  post(this, [this, failure, found, failed, stopped] {
    failure_ = failure;
    diagnostics_ = found;
    if (!failed) fraction_ = 1;
    setState(stopped ? State::stopped : failed ? State::failed : State::done);
  });
}

}  // namespace goniolux::gui
