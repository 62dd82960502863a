#include "app/gui/window/room_page.h"

#include <QActionGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/gui/window/icons.h"

namespace goniolux::gui {

using Preset = OrbitCamera::Preset;

RoomPage::RoomPage(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  bar_ = new QToolBar(this);
  bar_->setIconSize({18, 18});
  layout->addWidget(bar_);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  layout->addLayout(row, 1);
  view_ = new RoomView(this);
  legend_ = new Legend(this);
  row->addWidget(view_, 1);
  row->addWidget(legend_);
  addPresets();
  addTools();
}

void RoomPage::addPresets() {
  const struct {
    const char* icon;
    QString title;
    Preset preset;
    Qt::Key key;
  } presets[] = {{"perspective", tr("Perspective"), Preset::perspective, Qt::Key_5},
                 {"plan", tr("Plan"), Preset::plan, Qt::Key_7},
                 {"front", tr("Elevation from the front"), Preset::front, Qt::Key_1},
                 {"side", tr("Elevation from the right"), Preset::right, Qt::Key_3}};
  for (const auto& p : presets) {
    QAction* action =
        bar_->addAction(icon(p.icon), p.title, this, [this, preset = p.preset] { view_->setPreset(preset); });
    action->setShortcut(p.key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(QString("%1 (%2)").arg(p.title, action->shortcut().toString()));
    addAction(action);
  }
  bar_->addAction(icon("fit"), tr("Show everything (double click)"), view_, &RoomView::frameAll);
  views_ = new QComboBox(bar_);
  views_->setToolTip(tr("Look through a view of the project"));
  views_->setMinimumContentsLength(13);
  bar_->addWidget(views_);
  connect(views_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    if (index > 0) view_->lookThrough(projectViews_.at(static_cast<std::size_t>(index - 1)));
    views_->setCurrentIndex(0);
  });
  bar_->addSeparator();
}

void RoomPage::addTools() {
  const auto toggle = [this](const char* name, const QString& title, bool on) {
    QAction* action = bar_->addAction(icon(name), title);
    action->setCheckable(true);
    action->setChecked(on);
    return action;
  };
  connect(toggle("object", tr("Edges of objects"), true), &QAction::toggled, view_, &RoomView::setEdgesVisible);
  connect(toggle("aim", tr("Aiming lines"), true), &QAction::toggled, view_, &RoomView::setAimsVisible);
  connect(toggle("luminaire", tr("Photometric solids of selected luminaires"), true), &QAction::toggled, view_,
          &RoomView::setSolidsVisible);
  falseColour_ = toggle("grid", tr("Calculated illuminance on the grids"), true);
  connect(falseColour_, &QAction::toggled, this, [this](bool on) {
    view_->setOverlayVisible(on);
    legend_->show(on ? overlay_ : nullptr);
  });
  connect(toggle("measure", tr("Measure a distance between two points"), false), &QAction::toggled, view_,
          &RoomView::setMeasuring);
  cutting_ = toggle("cut", tr("Cut the room open"), false);
  cutSide_ = new QComboBox(bar_);
  cutSide_->setToolTip(tr("What is cut away"));
  const QString sides[] = {tr("above"), tr("right of x"), tr("left of x"), tr("behind y"), tr("before y")};
  for (const QString& side : sides) cutSide_->addItem(side);
  cutPlace_ = new QSlider(Qt::Horizontal, bar_);
  cutPlace_->setObjectName("cutPlace");
  cutPlace_->setRange(1, 100);
  cutPlace_->setValue(60);
  cutPlace_->setMaximumWidth(90);
  cutPlace_->setToolTip(tr("Place of the cut"));
  for (QWidget* part : {static_cast<QWidget*>(cutSide_), static_cast<QWidget*>(cutPlace_)}) {
    QAction* action = bar_->addWidget(part);
    action->setVisible(false);
    connect(cutting_, &QAction::toggled, action, &QAction::setVisible);
  }
  connect(cutting_, &QAction::toggled, this, &RoomPage::updateCut);
  connect(cutSide_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &RoomPage::updateCut);
  connect(cutPlace_, &QSlider::valueChanged, this, &RoomPage::updateCut);
  auto* space = new QWidget(bar_);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar_->addWidget(space);
  auto* label = new QLabel(tr("Snap "), bar_);
  bar_->addWidget(label);
  snap_ = new QComboBox(bar_);
  snap_->setToolTip(tr("Steps in which the mouse moves things; hold Ctrl to move freely"));
  for (const double step : {0.0, 0.01, 0.05, 0.1, 0.25, 0.5, 1.0})
    snap_->addItem(step > 0 ? QString("%1 m").arg(step) : tr("off"), step);
  snap_->setCurrentIndex(3);
  bar_->addWidget(snap_);
  connect(snap_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this] { view_->setSnap(snap_->currentData().toDouble()); });
}

void RoomPage::updateCut() {
  if (!scene_ || !cutting_->isChecked()) return view_->setCut(std::nullopt);
  // In the order of the choices.
  constexpr Cut sides[] = {{2, 0, true}, {0, 0, true}, {0, 0, false}, {1, 0, true}, {1, 0, false}};
  Cut cut = sides[cutSide_->currentIndex()];
  cut.at = scene_->low[cut.axis] + (scene_->high[cut.axis] - scene_->low[cut.axis]) * cutPlace_->value() / 100.0;
  view_->setCut(cut);
}

void RoomPage::showProject(const CheckedProject& checked, bool frame) {
  scene_ = checked.scene;
  view_->showScene(checked.scene, frame);
  views_->clear();
  views_->addItem(tr("Look through …"));
  projectViews_ = checked.project ? checked.project->views : std::vector<scene::View>();
  for (const scene::View& view : projectViews_) views_->addItem(icon("view"), QString::fromStdString(view.name));
  views_->setEnabled(!projectViews_.empty());
  updateCut();
}

void RoomPage::showOverlay(std::shared_ptr<const GridOverlay> overlay) {
  overlay_ = std::move(overlay);
  view_->showOverlay(overlay_);
  legend_->show(falseColour_->isChecked() ? overlay_ : nullptr);
}

void RoomPage::applyColours() {
  view_->applyColours();
  legend_->update();
}

}  // namespace goniolux::gui
