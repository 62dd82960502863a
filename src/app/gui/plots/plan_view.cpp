#include "app/gui/plots/plan_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPdfWriter>
#include <cmath>
#include <utility>

#include "app/gui/plots/drawing_lock.h"
#include "app/gui/plots/qt_ink.h"
#include "app/gui/window/theme.h"
#include "pipeline/plan_map.h"
#include "plot/number_text.h"
#include "plot/vtk/plan_map_painter.h"

namespace goniolux::gui {
namespace {

// The page is laid out at this size at least and scaled to the widget: its words keep their proportion to the plan.
constexpr int leastWidth = 900, leastHeight = 620;

void paintPage(QPainter& painter, const plot::PlanMap& map, const plot::MapLayout& layout) {
  painter.fillRect(QRect(0, 0, layout.width, layout.height), Qt::white);
  QtInk ink(painter, layout.height);
  plot::PlanMapPainter(map, layout).paint(ink);
}

bool hasValues(const project::GridResult& grid) {
  for (const double value : grid.values)
    if (std::isfinite(value)) return true;
  return false;
}

}  // namespace

PlanView::PlanView(QWidget* parent) : QWidget(parent), worker_("plots") {
  setObjectName("planView");
  setAccessibleName(tr("Illuminance in plan"));
  setMouseTracking(true);
  setMinimumSize(240, 180);
  wait_.setSingleShot(true);
  wait_.setInterval(60);
  connect(&wait_, &QTimer::timeout, this, &PlanView::draw);
}

void PlanView::show(const GridsOutcome& outcome) {
  outcome_ = outcome;
  if (result() == nullptr && outcome_.results && !outcome_.results->grids.empty())
    grid_ = QString::fromStdString(outcome_.results->grids.front().name);
  wait_.start();
}

void PlanView::clear() {
  outcome_ = {};
  picture_ = {};
  drawn_.reset();
  update();
}

void PlanView::setGrid(const QString& name) {
  if (name == grid_ || name.isEmpty()) return;
  grid_ = name;
  wait_.start();
}

void PlanView::setPalette(const std::string& palette) {
  palette_ = palette;
  wait_.start();
}

void PlanView::setBanded(bool banded) {
  banded_ = banded;
  wait_.start();
}

const project::GridResult* PlanView::result() const {
  if (!outcome_.results) return nullptr;
  for (const project::GridResult& grid : outcome_.results->grids)
    if (QString::fromStdString(grid.name) == grid_) return &grid;
  return nullptr;
}

void PlanView::draw() {
  const project::GridResult* grid = result();
  if (grid == nullptr || !hasValues(*grid)) return;
  if (isBusy_) {
    isStale_ = true;
    return;
  }
  isBusy_ = true;
  const double zoom =
      std::min({1.0, static_cast<double>(width()) / leastWidth, static_cast<double>(height()) / leastHeight});
  pipeline::MapOptions options;
  options.palette = palette_;
  options.banded = banded_;
  options.width = static_cast<int>(width() / zoom);
  options.height = static_cast<int>(height() / zoom);
  worker_.run([this, outcome = outcome_, grid, options, zoom, dense = devicePixelRatioF()] {
    auto drawn = std::make_shared<Drawn>();
    const QMutexLocker lock(&drawingLock());
    drawn->map = pipeline::planMapOf(*outcome.results, *grid, outcome.outline.get(), options);
    drawn->layout = plot::layoutOf(drawn->map);
    drawn->halfWidths = grid->halfWidths;
    const double scale = zoom * dense;
    drawn->picture = QImage(static_cast<int>(drawn->layout.width * scale),
                            static_cast<int>(drawn->layout.height * scale), QImage::Format_RGB32);
    drawn->picture.fill(Qt::white);
    QPainter painter(&drawn->picture);
    painter.scale(scale, scale);
    paintPage(painter, drawn->map, drawn->layout);
    painter.end();
    drawn->picture.setDevicePixelRatio(dense);
    post(this, [this, drawn] { take(drawn); });
  });
}

void PlanView::take(const std::shared_ptr<const Drawn>& drawn) {
  isBusy_ = false;
  if (outcome_.results) {
    drawn_ = drawn;
    picture_ = drawn->picture;
    update();
    Q_EMIT this->drawn();
  }
  if (std::exchange(isStale_, false)) draw();
}

void PlanView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (picture_.isNull()) {
    painter.fillRect(rect(), theme().base);
    painter.setPen(theme().faintText);
    painter.drawText(rect(), Qt::AlignCenter, tr("Press Calculate to see the illuminance here."));
    return;
  }
  painter.fillRect(rect(), Qt::white);
  painter.drawImage(0, 0, picture_);
}

void PlanView::resizeEvent(QResizeEvent*) {
  wait_.start();
}

void PlanView::mouseMoveEvent(QMouseEvent* event) {
  if (!drawn_ || picture_.isNull()) return;
  const plot::MapLayout& layout = drawn_->layout;
  const double zoom = static_cast<double>(layout.width) / std::max(picture_.width() / picture_.devicePixelRatio(), 1.0);
  const core::Vec2 at = layout.toPlan({event->pos().x() * zoom, layout.height - event->pos().y() * zoom});
  double nearest = 1e300;
  std::size_t found = 0;
  for (std::size_t i = 0; i < drawn_->map.points.size(); ++i) {
    const double distance = glm::length(drawn_->map.points[i] - at);
    if (distance < nearest) nearest = distance, found = i;
  }
  if (!layout.shown.contains(at) || nearest > 1e299) return Q_EMIT pointed(QString());
  const double value = drawn_->map.values[found], h = drawn_->halfWidths[found];
  const core::Vec2& p = drawn_->map.points[found];
  const QString words = std::isfinite(value)
                            ? QString::fromStdString(plot::uncertaintyText(value, h) + " " + drawn_->map.unit)
                            : tr("not counted");
  Q_EMIT pointed(tr("point %1, %2 m: %3").arg(p.x, 0, 'f', 2).arg(p.y, 0, 'f', 2).arg(words));
}

QString PlanView::exportTo(const QString& file) const {
  if (!drawn_) return tr("There is no plot yet; calculate first.");
  const QMutexLocker lock(&drawingLock());
  const plot::MapLayout& layout = drawn_->layout;
  if (file.endsWith(".pdf", Qt::CaseInsensitive)) {
    QPdfWriter writer(file);
    writer.setPageMargins({0, 0, 0, 0});
    constexpr double pointsPerPixel = 0.6;
    writer.setPageSize(QPageSize(QSizeF(layout.width, layout.height) * pointsPerPixel, QPageSize::Point));
    writer.setTitle(QString::fromStdString(drawn_->map.title));
    QPainter painter;
    if (!painter.begin(&writer)) return tr("%1 cannot be written; choose another folder.").arg(file);
    painter.scale(static_cast<double>(writer.width()) / layout.width,
                  static_cast<double>(writer.height()) / layout.height);
    paintPage(painter, drawn_->map, layout);
    return {};
  }
  QImage picture(layout.width * 2, layout.height * 2, QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  painter.scale(2, 2);
  paintPage(painter, drawn_->map, layout);
  painter.end();
  if (!picture.save(file)) return tr("%1 cannot be written; choose another folder or ending.").arg(file);
  return {};
}

}  // namespace goniolux::gui
