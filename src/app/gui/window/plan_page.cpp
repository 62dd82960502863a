#include "app/gui/window/plan_page.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStyle>
#include <QTabWidget>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/gui/plots/paper.h"
#include "app/gui/plots/values_model.h"
#include "app/gui/window/icons.h"
#include "plot/levels.h"
#include "plot/palette.h"
#include "plot/section.h"

namespace goniolux::gui {

PlanPage::PlanPage(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QToolBar(this);
  bar->setIconSize({18, 18});
  layout->addWidget(bar);
  auto* split = new QSplitter(Qt::Horizontal, this);
  layout->addWidget(split, 1);
  view_ = new PlanView(split);
  charts_ = new QTabWidget(split);
  charts_->setObjectName("charts");
  charts_->setDocumentMode(true);
  section_ = new Paper(tr("Draw a line in the plan with the mouse to see the values along it."), charts_);
  histogram_ = new Paper(tr("Press Calculate to see how the values are spread."), charts_);
  values_ = new QTableView(charts_);
  values_->setObjectName("values");
  values_->setAccessibleName(tr("Values of the points"));
  model_ = new ValuesModel(this);
  values_->setModel(model_);
  values_->setSortingEnabled(true);
  values_->sortByColumn(-1, Qt::AscendingOrder);
  values_->setAlternatingRowColors(true);
  values_->setFrameShape(QFrame::NoFrame);
  values_->setShowGrid(false);
  values_->setSelectionBehavior(QAbstractItemView::SelectRows);
  values_->verticalHeader()->hide();
  values_->verticalHeader()->setDefaultSectionSize(24);
  charts_->addTab(section_, tr("Section"));
  charts_->addTab(histogram_, tr("Histogram"));
  charts_->addTab(values_, tr("Values"));
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 2);
  split->setSizes({560, 440});
  connect(view_, &PlanView::drawn, this, &PlanPage::showCharts);
  connect(view_, &PlanView::sectionDrawn, this, [this] {
    charts_->setCurrentWidget(section_);
    showSection();
  });
  connect(charts_, &QTabWidget::currentChanged, this, &PlanPage::showCharts);
  grids_ = new QComboBox(bar);
  grids_->setMinimumContentsLength(14);
  grids_->setToolTip(tr("The grid that is shown"));
  bar->addWidget(new QLabel(tr(" Grid  "), bar));
  bar->addWidget(grids_);
  bar->addSeparator();
  auto* colours = new QComboBox(bar);
  for (const plot::Palette& palette : plot::palettes())
    colours->addItem(QString::fromStdString(palette.name), QString::fromStdString(palette.name));
  for (int i = 0; i < colours->count(); ++i)
    colours->setItemData(i, QString::fromStdString(plot::palettes()[static_cast<std::size_t>(i)].title),
                         Qt::ToolTipRole);
  bar->addWidget(new QLabel(tr("  Colours  "), bar));
  bar->addWidget(colours);
  auto* banded = new QComboBox(bar);
  banded->addItem(tr("in bands"), true);
  banded->addItem(tr("smooth"), false);
  bar->addWidget(banded);
  bar->addWidget(new QLabel(tr("  Levels  "), bar));
  levels_ = new QLineEdit(bar);
  levels_->setObjectName("levels");
  levels_->setPlaceholderText(tr("automatic"));
  levels_->setToolTip(
      tr("Values of the isolux lines, here and in the 3-D view, such as 100, 200, 300, 500; empty: "
         "chosen from the results"));
  levels_->setMaximumWidth(170);
  bar->addWidget(levels_);
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addAction(icon("export"), tr("Export this plot …"), this, &PlanPage::exportRequested);
  connect(grids_, &QComboBox::currentTextChanged, view_, &PlanView::setGrid);
  connect(colours, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, colours] {
    view_->setPalette(colours->currentData().toString().toStdString());
    Q_EMIT scaleChanged();
  });
  connect(banded, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, banded] {
    view_->setBanded(banded->currentData().toBool());
    Q_EMIT scaleChanged();
  });
  connect(levels_, &QLineEdit::editingFinished, this, &PlanPage::takeLevels);
}

void PlanPage::show(const GridsOutcome& outcome) {
  QStringList names;
  for (const project::GridResult& grid : outcome.results->grids) names << QString::fromStdString(grid.name);
  QStringList known;
  for (int i = 0; i < grids_->count(); ++i) known << grids_->itemText(i);
  if (names != known) {
    const QSignalBlocker quiet(grids_);
    const QString chosen = view_->grid();
    grids_->clear();
    grids_->addItems(names);
    if (names.contains(chosen)) grids_->setCurrentText(chosen);
  }
  view_->show(outcome);
}

void PlanPage::showCharts() {
  showSection();
  const auto content = view_->content();
  if (!content) return;
  if (charts_->currentWidget() == histogram_)
    histogram_->show([content] { return smallSheetOf(plot::histogramOf(content->map)); });
  if (charts_->currentWidget() == values_) model_->show(content);
}

void PlanPage::showSection() {
  const auto content = view_->content();
  if (!content || !view_->section()) return section_->clear();
  section_->show([content, line = *view_->section(), none = tr("The line does not cross the grid.").toStdString()] {
    const plot::LineChart chart = plot::sectionOf(content->map, content->halfWidths, line.from, line.to);
    if (chart.curves.empty()) throw core::RunError(none);
    return smallSheetOf(chart);
  });
}

void PlanPage::takeLevels() {
  const QString text = levels_->text().trimmed();
  const auto levels =
      text.isEmpty() ? std::optional<std::vector<double>>(std::in_place) : plot::parseLevels(text.toStdString());
  levels_->setProperty("wrong", !levels);
  levels_->style()->unpolish(levels_);
  levels_->style()->polish(levels_);
  if (!levels || *levels == view_->scale().levels) return;
  view_->setLevels(*levels);
  Q_EMIT scaleChanged();
}

void PlanPage::clear() {
  section_->clear();
  histogram_->clear();
  model_->show(nullptr);
  grids_->clear();
  view_->clear();
}

void PlanPage::setGrid(const QString& name) {
  grids_->setCurrentText(name);
}

}  // namespace goniolux::gui
