#include "app/gui/jobs/job_queue.h"

#include <utility>

namespace goniolux::gui {

JobQueue::JobQueue(QObject* parent) : QObject(parent), worker_(std::make_unique<Worker>("jobs")) {}

JobQueue::~JobQueue() {
  disconnect();
  stopAll();
  worker_.reset();
}

Job* JobQueue::start(const QString& title, Job::Work work) {
  auto* job = new Job(title, std::move(work), this);
  jobs_.push_back(job);
  connect(job, &Job::progressed, this, [this, job] { Q_EMIT progressed(job); });
  connect(job, &Job::over, this, [this, job] { Q_EMIT over(job); });
  Q_EMIT added(job);
  worker_->run([job] { job->execute(); });
  return job;
}

void JobQueue::stopAll() {
  for (Job* job : jobs_) job->stop();
}

bool JobQueue::isBusy() const {
  return current() != nullptr;
}

Job* JobQueue::current() const {
  for (Job* job : jobs_)
    if (!job->isOver()) return job;
  return nullptr;
}

}  // namespace goniolux::gui
