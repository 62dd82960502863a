#include "app/gui/window/results_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>
#include <cmath>

#include "app/gui/window/icons.h"
#include "app/gui/window/theme.h"
#include "plot/number_text.h"

namespace goniolux::gui {
namespace {

enum Column { nameColumn, meanColumn, minColumn, maxColumn, u0Column, udColumn, pointsColumn, columnCount };

QTreeWidget* makeTable(const QStringList& titles, QWidget* parent) {
  auto* table = new QTreeWidget(parent);
  table->setHeaderLabels(titles);
  table->setRootIsDecorated(false);
  table->setUniformRowHeights(true);
  table->setAlternatingRowColors(true);
  table->setFrameShape(QFrame::NoFrame);
  return table;
}

}  // namespace

QString withHalfWidth(const core::Estimate& e) {
  if (!std::isfinite(e.value)) return "–";
  return QString::fromStdString(plot::uncertaintyText(e.value, e.halfWidth()));
}

ResultsPanel::ResultsPanel(QWidget* parent) : QWidget(parent) {
  setObjectName("results");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  summary_ = new QLabel(this);
  summary_->setContentsMargins(10, 7, 10, 7);
  summary_->setWordWrap(true);
  layout->addWidget(summary_);
  auto* split = new QSplitter(Qt::Horizontal, this);
  layout->addWidget(split, 1);
  table_ = makeTable({tr("Grid"), tr("Mean"), tr("Minimum"), tr("Maximum"), "U₀", "U_d", tr("Points")}, split);
  table_->setObjectName("resultsTable");
  table_->setAccessibleName(tr("Results by grid"));
  table_->headerItem()->setToolTip(meanColumn,
                                   tr("Mean illuminance of the grid's points, maintained. CIE S 017 17-21-060: "
                                      "illuminance is luminous flux per area of a surface."));
  table_->headerItem()->setToolTip(u0Column, tr("Uniformity: smallest illuminance over mean (EN 12464-1)."));
  table_->headerItem()->setToolTip(udColumn, tr("Diversity: smallest illuminance over largest."));
  table_->header()->resizeSection(nameColumn, 142);
  for (int c = meanColumn; c < columnCount; ++c) {
    table_->header()->resizeSection(c, c == pointsColumn ? 66 : c >= u0Column ? 106 : 104);
    table_->headerItem()->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
  }
  table_->header()->setStretchLastSection(false);
  connect(table_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item != nullptr) Q_EMIT gridChosen(item->text(nameColumn));
  });
  verdicts_ = makeTable({tr("Requirement"), tr("Verdict")}, split);
  verdicts_->setObjectName("verdictsTable");
  verdicts_->header()->setStretchLastSection(false);
  verdicts_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  verdicts_->header()->resizeSection(1, 96);
  split->setSizes({800, 420});
  show(nullptr, true);
}

void ResultsPanel::show(std::shared_ptr<const project::Results> results, bool isFinal) {
  const QString chosen = table_->currentItem() != nullptr ? table_->currentItem()->text(nameColumn) : QString();
  const QSignalBlocker quiet(table_);
  table_->clear();
  verdicts_->clear();
  summary_->setStyleSheet(QString());
  if (!results) {
    summary_->setText(tr("Nothing is calculated yet. Choose an accuracy and press Calculate."));
    return;
  }
  for (const project::GridResult& grid : results->grids) addGrid(grid);
  addVerdicts(*results);
  for (int i = 0; i < table_->topLevelItemCount(); ++i)
    if (table_->topLevelItem(i)->text(nameColumn) == chosen) table_->setCurrentItem(table_->topLevelItem(i));
  if (!isFinal) {
    summary_->setText(tr("Being calculated: the half-widths shrink as the work goes on."));
  } else {
    QString words = tr("Intervals at %1 % confidence; %2 s, %3 million rays.")
                        .arg(100 * results->confidence)
                        .arg(results->wallTime_s, 0, 'f', 2)
                        .arg(1e-6 * static_cast<double>(results->rays), 0, 'f', 2);
    if (!results->reached)
      words +=
          " " + tr("The accuracy asked for was not reached: %1.").arg(QString::fromStdString(results->reachedText));
    summary_->setText(words);
  }
}

void ResultsPanel::addGrid(const project::GridResult& grid) {
  auto* row = new QTreeWidgetItem(table_);
  const QString unit = " " + QString::fromStdString(grid.unit);
  row->setText(nameColumn, QString::fromStdString(grid.name));
  row->setText(meanColumn, withHalfWidth(grid.mean) + unit);
  row->setText(minColumn, withHalfWidth(grid.min) + unit);
  row->setText(maxColumn, withHalfWidth(grid.max) + unit);
  row->setText(u0Column, withHalfWidth(grid.u0));
  row->setText(udColumn, withHalfWidth(grid.ud));
  row->setText(pointsColumn, QString::number(grid.points.size() - grid.excluded.size()));
  row->setToolTip(nameColumn, QString::fromStdString(grid.quantity));
  for (int c = meanColumn; c < columnCount; ++c) row->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
}

void ResultsPanel::addVerdicts(const project::Results& results) {
  using Verdict = project::RequirementResult::Verdict;
  for (const project::ObserverResult& observer : results.observers) {
    auto* row = new QTreeWidgetItem(verdicts_);
    row->setText(0, QString::fromStdString(observer.name + ": " + observer.quantity));
    row->setText(1, withHalfWidth(observer.value));
    row->setIcon(0, icon("observer"));
    if (observer.quantity == "ugr")
      row->setToolTip(0, tr("UGR, unified glare rating of the luminaires against the luminance that they stand before "
                            "(CIE 117:1995); EN 12464-1 limits it."));
  }
  for (const project::RequirementResult& requirement : results.requirements) {
    const bool pass = requirement.verdict == Verdict::pass, fail = requirement.verdict == Verdict::fail;
    auto* row = new QTreeWidgetItem(verdicts_);
    row->setText(0, QString::fromStdString(requirement.text));
    row->setToolTip(0, row->text(0));
    row->setText(1, pass ? tr("pass") : fail ? tr("fail") : tr("undecided"));
    row->setData(1, Qt::UserRole, pass ? "pass" : fail ? "fail" : "undecided");
    row->setIcon(0, icon(pass ? "pass" : fail ? "fail" : "undecided"));
    row->setForeground(1, pass ? theme().pass : fail ? theme().fail : theme().undecided);
    row->setToolTip(1, pass   ? tr("The whole interval keeps the limit.")
                       : fail ? tr("The whole interval breaks the limit.")
                              : tr("The limit lies inside the interval: ask for more accuracy."));
  }
}

void ResultsPanel::setStale(bool stale) {
  if (!stale) return;
  summary_->setText(tr("The project has changed since this was calculated: press Calculate again."));
  summary_->setStyleSheet(QString("color: %1").arg(theme().undecided.name()));
}

QString ResultsPanel::cell(const QString& grid, const QString& column) const {
  for (int c = 0; c < columnCount; ++c) {
    if (table_->headerItem()->text(c) != column) continue;
    for (int i = 0; i < table_->topLevelItemCount(); ++i)
      if (table_->topLevelItem(i)->text(nameColumn) == grid) return table_->topLevelItem(i)->text(c);
  }
  return {};
}

QString ResultsPanel::verdict(int number) const {
  int seen = 0;
  for (int i = 0; i < verdicts_->topLevelItemCount(); ++i) {
    const QString verdict = verdicts_->topLevelItem(i)->data(1, Qt::UserRole).toString();
    if (!verdict.isEmpty() && seen++ == number) return verdict;
  }
  return {};
}

QString ResultsPanel::csv() const {
  QString text;
  const auto line = [&](const QTreeWidgetItem* item) {
    QStringList cells;
    for (int c = 0; c < columnCount; ++c) cells << "\"" + item->text(c) + "\"";
    text += cells.join(',') + "\n";
  };
  line(table_->headerItem());
  for (int i = 0; i < table_->topLevelItemCount(); ++i) line(table_->topLevelItem(i));
  return text;
}

}  // namespace goniolux::gui
