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
  section_.reset();
  wait_.start();
}

void PlanView::setPalette(const std::string& palette) {
  scale_.palette = palette;
  wait_.start();
}

void PlanView::setBanded(bool banded) {
  scale_.banded = banded;
  wait_.start();
}

void PlanView::setLevels(const std::vector<double>& levels) {
  scale_.levels = levels;
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
  options.palette = scale_.palette;
  options.banded = scale_.banded;
  options.levels = scale_.levels;
  options.width = static_cast<int>(width() / zoom);
  options.height = static_cast<int>(height() / zoom);
  worker_.run([this, outcome = outcome_, grid, options, zoom, dense = devicePixelRatioF()] {
    auto drawn = std::make_shared<Drawn>();
    const QMutexLocker lock(&drawingLock());
    drawn->content.map = pipeline::planMapOf(*outcome.results, *grid, outcome.outline.get(), options);
    drawn->layout = plot::layoutOf(drawn->content.map);
    drawn->content.halfWidths = grid->halfWidths;
    const double scale = zoom * dense;
    drawn->picture = QImage(static_cast<int>(drawn->layout.width * scale),
                            static_cast<int>(drawn->layout.height * scale), QImage::Format_RGB32);
    drawn->picture.fill(Qt::white);
    QPainter painter(&drawn->picture);
    painter.scale(scale, scale);
    paintPage(painter, drawn->content.map, drawn->layout);
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
  if (!section_) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const QPoint from = toWidget(section_->from), to = toWidget(section_->to);
  for (const auto& [colour, width] : {std::pair(QColor(Qt::white), 4.0), std::pair(theme().selection, 2.0)}) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
    painter.drawEllipse(from, 3, 3);
    painter.drawEllipse(to, 3, 3);
  }
}

std::shared_ptr<const PlanView::Content> PlanView::content() const {
  return drawn_ ? std::shared_ptr<const Content>(drawn_, &drawn_->content) : nullptr;
}

core::Vec2 PlanView::toMap(const QPoint& at) const {
  const plot::MapLayout& layout = drawn_->layout;
  const double zoom = static_cast<double>(layout.width) / std::max(picture_.width() / picture_.devicePixelRatio(), 1.0);
  return layout.toPlan({at.x() * zoom, layout.height - at.y() * zoom});
}

QPoint PlanView::toWidget(const core::Vec2& place) const {
  if (!drawn_) return {};
  const plot::MapLayout& layout = drawn_->layout;
  const double zoom = static_cast<double>(layout.width) / std::max(picture_.width() / picture_.devicePixelRatio(), 1.0);
  const core::Vec2 page = layout.toPage(place);
  return QPointF(page.x / zoom, (layout.height - page.y) / zoom).toPoint();
}

void PlanView::mousePressEvent(QMouseEvent* event) {
  if (!drawn_ || event->button() != Qt::LeftButton || !drawn_->layout.shown.contains(toMap(event->pos()))) return;
  isDrawingSection_ = true;
  section_ = Line{toMap(event->pos()), toMap(event->pos())};
}

void PlanView::mouseReleaseEvent(QMouseEvent* event) {
  if (!std::exchange(isDrawingSection_, false) || !drawn_) return;
  section_->to = toMap(event->pos());
  // A mere click takes the line away.
  if (glm::length(section_->to - section_->from) * drawn_->layout.scale < 6) section_.reset();
  update();
  Q_EMIT sectionDrawn();
}

void PlanView::resizeEvent(QResizeEvent*) {
  wait_.start();
}

void PlanView::mouseMoveEvent(QMouseEvent* event) {
  if (!drawn_ || picture_.isNull()) return;
  const plot::MapLayout& layout = drawn_->layout;
  const core::Vec2 at = toMap(event->pos());
  if (isDrawingSection_) {
    section_->to = at;
    update();
  }
  double nearest = 1e300;
  std::size_t found = 0;
  for (std::size_t i = 0; i < drawn_->content.map.points.size(); ++i) {
    const double distance = glm::length(drawn_->content.map.points[i] - at);
    if (distance < nearest) nearest = distance, found = i;
  }
  if (!layout.shown.contains(at) || nearest > 1e299) return Q_EMIT pointed(QString());
  const double value = drawn_->content.map.values[found], h = drawn_->content.halfWidths[found];
  const core::Vec2& p = drawn_->content.map.points[found];
  const QString words = std::isfinite(value)
                            ? QString::fromStdString(plot::uncertaintyText(value, h) + " " + drawn_->content.map.unit)
                            : tr("not counted");
  Q_EMIT pointed(tr("point %1, %2 m: %3").arg(p.x, 0, 'f', 2).arg(p.y, 0, 'f', 2).arg(words));
}

std::function<void()> PlanView::exportOf(const QString& file) const {
  if (!drawn_) return nullptr;
  return [page = drawn_, file, cannot = tr("%1 cannot be written; choose another folder or ending.").arg(file)] {
    const QMutexLocker lock(&drawingLock());
    const plot::MapLayout& layout = page->layout;
    if (file.endsWith(".pdf", Qt::CaseInsensitive)) {
      QPdfWriter writer(file);
      writer.setPageMargins({0, 0, 0, 0});
      constexpr double pointsPerPixel = 0.6;
      writer.setPageSize(QPageSize(QSizeF(layout.width, layout.height) * pointsPerPixel, QPageSize::Point));
      writer.setTitle(QString::fromStdString(page->content.map.title));
      QPainter painter;
      if (!painter.begin(&writer)) throw core::RunError(cannot.toStdString());
      painter.scale(static_cast<double>(writer.width()) / layout.width,
                    static_cast<double>(writer.height()) / layout.height);
      paintPage(painter, page->content.map, layout);
      return;
    }
    QImage picture(layout.width * 2, layout.height * 2, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.scale(2, 2);
    paintPage(painter, page->content.map, layout);
    painter.end();
    if (!picture.save(file)) throw core::RunError(cannot.toStdString());
  };
}

}  // namespace goniolux::gui
