// ResultsPanel: what was calculated, each number with its half-width, and the verdicts on what was required.
#pragma once

#include <QTreeWidget>
#include <QWidget>
#include <memory>
#include <vector>

#include "project/results.h"

class QLabel;

namespace goniolux::gui {

class ResultsPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit ResultsPanel(QWidget* parent = nullptr);

  /// Null: nothing is calculated yet. `isFinal` is false while the work goes on.
  void show(std::shared_ptr<const project::Results> results, bool isFinal);
  /// The results belong to an earlier state of the project.
  void setStale(bool stale);
  [[nodiscard]] QString cell(const QString& grid, const QString& column) const;
  /// "pass", "fail" or "undecided" of the n-th requirement; "" when there is none.
  [[nodiscard]] QString verdict(int number) const;
  /// The table as comma-separated values.
  [[nodiscard]] QString csv() const;

 Q_SIGNALS:
  void gridChosen(const QString& name);

 private:
  void addGrid(const project::GridResult& grid);
  void addVerdicts(const project::Results& results);

  QLabel* summary_;
  QTreeWidget* table_;
  QTreeWidget* verdicts_;
};

/// "512 ± 4", and "–" where there is no number.
QString withHalfWidth(const core::Estimate& estimate);

}  // namespace goniolux::gui
