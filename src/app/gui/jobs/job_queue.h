// JobQueue: all jobs, one at a time on one thread: each uses every processor while it runs.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/gui/jobs/job.h"
#include "app/gui/jobs/worker.h"

namespace goniolux::gui {

class JobQueue final : public QObject {
  Q_OBJECT
 public:
  explicit JobQueue(QObject* parent = nullptr);
  /// Stops everything and waits for the job that runs.
  ~JobQueue() override;

  /// Queues a job; it belongs to the queue, which keeps it for the list of jobs.
  Job* start(const QString& title, Job::Work work);
  void stopAll();
  [[nodiscard]] bool isBusy() const;
  /// The job that runs, or the next to run; nullptr when all are over.
  [[nodiscard]] Job* current() const;
  [[nodiscard]] const std::vector<Job*>& jobs() const { return jobs_; }

 Q_SIGNALS:
  void added(Job* job);
  void progressed(Job* job);
  void over(Job* job);

 private:
  std::vector<Job*> jobs_;
  std::unique_ptr<Worker> worker_;
};

}  // namespace goniolux::gui
