#include "app/gui/document/checked_project.h"

#include <exception>
#include <utility>

namespace goniolux::gui {
namespace {

std::shared_ptr<const CheckedProject> check(quint64 revision, std::string text, const std::string& file) {
  auto result = std::make_shared<CheckedProject>();
  result->revision = revision;
  try {
    auto project = std::make_shared<project::Project>(project::readProjectText(text, file));
    result->diagnostics = project->warnings;
    result->scene = std::make_shared<const RoomScene>(roomSceneOf(*project, text));
    result->project = std::move(project);
  } catch (const core::InputError& error) {
    result->diagnostics = error.diagnostics();
  } catch (const std::exception& error) {
    result->diagnostics.error({file, 0, 0}, "project", error.what());
  }
  result->text = std::move(text);
  return result;
}

}  // namespace

ProjectChecker::ProjectChecker(Document& document, QObject* parent)
    : QObject(parent),
      document_(document),
      latest_(std::make_shared<CheckedProject>()),
      latestGood_(latest_),
      worker_("project reader") {
  wait_.setSingleShot(true);
  wait_.setInterval(80);
  connect(&wait_, &QTimer::timeout, this, &ProjectChecker::begin);
  connect(&document_, &Document::changed, this, [this] { wait_.start(); });
  connect(&document_, &Document::opened, this, [this] {
    latest_ = latestGood_ = std::make_shared<CheckedProject>();
    if (document_.isOpen()) begin();
  });
}

void ProjectChecker::begin() {
  wait_.stop();
  if (!document_.isOpen()) return;
  if (isBusy_) {
    isStale_ = true;
    return;
  }
  isBusy_ = true;
  worker_.run([this, revision = document_.revision(), text = document_.text(), file = document_.file().toStdString()] {
    auto found = check(revision, text, file);
    post(this, [this, found] { finish(found); });
  });
}

void ProjectChecker::finish(std::shared_ptr<const CheckedProject> found) {
  isBusy_ = false;
  if (document_.isOpen()) {
    latest_ = std::move(found);
    if (latest_->project) latestGood_ = latest_;
    Q_EMIT checked();
  }
  if (std::exchange(isStale_, false)) begin();
}

}  // namespace goniolux::gui
