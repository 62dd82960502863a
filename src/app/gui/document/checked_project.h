// CheckedProject: what the engine's own reader makes of the document's text: the project, or why there is none, and
// what the 3-D view shows of it. Made on a thread of its own while one types.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "app/gui/document/document.h"
#include "app/gui/jobs/worker.h"
#include "app/gui/room/room_scene.h"
#include "project/project.h"

namespace goniolux::gui {

struct CheckedProject {
  quint64 revision = 0;
  std::string text;
  std::shared_ptr<const project::Project> project;  ///< null when there are errors
  core::Diagnostics diagnostics;                    ///< errors and warnings with their places
  std::shared_ptr<const RoomScene> scene;           ///< null when there is no project
};

class ProjectChecker final : public QObject {
  Q_OBJECT
 public:
  explicit ProjectChecker(Document& document, QObject* parent = nullptr);

  /// The latest that is known; never null. Its revision may be behind the document's for a moment.
  [[nodiscard]] const std::shared_ptr<const CheckedProject>& latest() const { return latest_; }
  /// The latest belongs to the text as it is now.
  [[nodiscard]] bool isCurrent() const { return latest_->revision == document_.revision(); }
  /// The latest project without errors: the 3-D view goes on showing it while the text is broken.
  [[nodiscard]] const std::shared_ptr<const CheckedProject>& latestGood() const { return latestGood_; }

 Q_SIGNALS:
  void checked();

 private:
  void begin();
  void finish(std::shared_ptr<const CheckedProject> found);

  Document& document_;
  std::shared_ptr<const CheckedProject> latest_, latestGood_;
  QTimer wait_;
  bool isBusy_ = false, isStale_ = false;
  Worker worker_;
};

}  // namespace goniolux::gui
