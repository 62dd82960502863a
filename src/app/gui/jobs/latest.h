// Latest: a drawing made on a worker's thread, of which only the newest counts: while one is made, those asked for in
// between are skipped but the last.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "app/gui/jobs/worker.h"

namespace goniolux::gui {

template <typename Made>
class Latest {
 public:
  using Make = std::function<std::shared_ptr<const Made>()>;
  using Take = std::function<void(std::shared_ptr<const Made>)>;

  /// `owner` receives on the GUI thread what was made, by `take`; it must outlive this.
  Latest(QObject* owner, Take take) : owner_(owner), take_(std::move(take)), worker_("drawing") {}

  void ask(Make make) {
    if (isBusy_) {
      next_ = std::move(make);
      return;
    }
    isBusy_ = true;
    worker_.run([this, task = std::move(make)] {
      auto made = task();
      post(owner_, [this, made] {
        isBusy_ = false;
        if (made) take_(made);
        if (next_) ask(std::exchange(next_, nullptr));
      });
    });
  }

 private:
  QObject* owner_;
  Take take_;
  bool isBusy_ = false;
  Make next_;
  Worker worker_;
};

}  // namespace goniolux::gui
