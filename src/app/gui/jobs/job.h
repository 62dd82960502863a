// Job: one piece of work of the engine: a calculation, a rendering, an export. It runs on the jobs' thread, tells how
// far it is, hands over what it has so far, and can be paused and stopped. The interface calculates by jobs only.
#pragma once

#include <QElapsedTimer>
#include <QMutex>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QWaitCondition>
#include <atomic>
#include <functional>

#include "core/diagnostics.h"
#include "core/progress.h"

namespace goniolux::gui {

class Job;

/// The engine's view of a job; used on the jobs' thread.
class JobProgress final : public core::ProgressSink {
 public:
  explicit JobProgress(Job& job) : job_(job) {}
  void progress(const std::string& task, double fraction, const std::string& reached) override;
  void note(const std::string& message) override;
  /// Has `deliver` run on the GUI thread: partial results.
  void publish(std::function<void()> deliver);

  void setPaused(bool paused);

 private:
  Job& job_;
  QElapsedTimer sinceShown_;
  QMutex mutex_;
  QWaitCondition resumed_;
  bool paused_ = false;
};

class Job final : public QObject {
  Q_OBJECT
 public:
  enum class State { waiting, running, paused, done, stopped, failed };
  using Work = std::function<void(JobProgress&)>;

  /// `work` may throw core::InputError or any std::exception: the job has failed then, with what it says.
  Job(QString title, Work work, QObject* parent = nullptr);

  [[nodiscard]] const QString& title() const { return title_; }
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool isOver() const { return state_ >= State::done; }
  [[nodiscard]] double fraction() const { return fraction_; }
  [[nodiscard]] const QString& task() const { return task_; }
  [[nodiscard]] const QString& reached() const { return reached_; }
  /// Seconds that it has run, and that are left as far as one can tell; below 0: not known.
  [[nodiscard]] double seconds() const;
  [[nodiscard]] double secondsLeft() const;
  /// Why it failed: sentences for the user, with positions where the engine gave them.
  [[nodiscard]] const QString& failure() const { return failure_; }
  [[nodiscard]] const core::Diagnostics& diagnostics() const { return diagnostics_; }
  /// What was just done, as a command that does the same.
  void setCommandLine(const QString& command) { command_ = command; }
  [[nodiscard]] const QString& commandLine() const { return command_; }

  void stop();
  void setPaused(bool paused);

 Q_SIGNALS:
  void progressed();
  void noted(const QString& message);
  void over();

 private:
  friend class JobProgress;
  friend class JobQueue;
  void execute();  ///< on the jobs' thread
  void setState(State state);

  QString title_, task_, reached_, failure_, command_;
  Work work_;
  JobProgress progress_;
  State state_ = State::waiting;
  double fraction_ = 0, lasted_ = 0;
  QElapsedTimer clock_;
  core::Diagnostics diagnostics_;
};

}  // namespace goniolux::gui
