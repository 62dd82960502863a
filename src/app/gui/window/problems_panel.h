// ProblemsPanel: every error and warning of the project as the engine's reader words it, with its place.
#pragma once

#include <QTreeWidget>

#include "core/diagnostics.h"

namespace goniolux::gui {

class ProblemsPanel final : public QTreeWidget {
  Q_OBJECT
 public:
  explicit ProblemsPanel(QWidget* parent = nullptr);
  void show(const core::Diagnostics& diagnostics);
  [[nodiscard]] int errors() const { return errors_; }
  [[nodiscard]] int warnings() const { return warnings_; }

 Q_SIGNALS:
  /// A line and column of the project's text was asked for.
  void placeChosen(int line, int column);

 private:
  int errors_ = 0, warnings_ = 0;
};

}  // namespace goniolux::gui
