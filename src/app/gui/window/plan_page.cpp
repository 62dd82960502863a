#include "app/gui/window/plan_page.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/gui/window/icons.h"
#include "plot/palette.h"

namespace goniolux::gui {

PlanPage::PlanPage(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QToolBar(this);
  bar->setIconSize({18, 18});
  layout->addWidget(bar);
  view_ = new PlanView(this);
  layout->addWidget(view_, 1);
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
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addAction(icon("export"), tr("Export this plot …"), this, &PlanPage::exportRequested);
  connect(grids_, &QComboBox::currentTextChanged, view_, &PlanView::setGrid);
  connect(colours, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this, colours] { view_->setPalette(colours->currentData().toString().toStdString()); });
  connect(banded, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this, banded] { view_->setBanded(banded->currentData().toBool()); });
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

void PlanPage::clear() {
  grids_->clear();
  view_->clear();
}

void PlanPage::setGrid(const QString& name) {
  grids_->setCurrentText(name);
}

}  // namespace goniolux::gui
