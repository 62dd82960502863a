#include "app/gui/picture/image_canvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/window/theme.h"

namespace goniolux::gui {

ImageCanvas::ImageCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName("imageCanvas");
  setAccessibleName(tr("Rendered picture"));
  setMouseTracking(true);
  setFocusPolicy(Qt::ClickFocus);
  setMinimumSize(240, 180);
}

void ImageCanvas::show(const QImage& picture) {
  picture_ = picture;
  update();
}

void ImageCanvas::setEarlier(const QImage& picture) {
  earlier_ = picture;
  update();
}

void ImageCanvas::setSplit(double share) {
  split_ = share;
  update();
}

void ImageCanvas::setTool(Tool tool) {
  tool_ = tool;
  growing_.clear();
  region_.clear();
  setCursor(tool == Tool::point ? Qt::ArrowCursor : Qt::CrossCursor);
  update();
}

void ImageCanvas::setMark(const QPoint& pixel, int radius) {
  mark_ = pixel;
  radius_ = radius;
  update();
}

QRectF ImageCanvas::frame() const {
  if (picture_.isNull()) return {};
  const double scale = std::min((width() - 24.0) / picture_.width(), (height() - 24.0) / picture_.height());
  const QSizeF size = QSizeF(picture_.size()) * scale;
  return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

QPoint ImageCanvas::pixelAt(const QPoint& at) const {
  const QRectF shown = frame();
  if (picture_.isNull() || !shown.contains(at)) return {-1, -1};
  const int x = static_cast<int>((at.x() - shown.left()) / shown.width() * picture_.width());
  const int y = static_cast<int>((at.y() - shown.top()) / shown.height() * picture_.height());
  return {std::clamp(x, 0, picture_.width() - 1), std::clamp(y, 0, picture_.height() - 1)};
}

QPoint ImageCanvas::toWidget(const QPoint& pixel) const {
  const QRectF shown = frame();
  return QPointF(shown.left() + (pixel.x() + 0.5) / picture_.width() * shown.width(),
                 shown.top() + (pixel.y() + 0.5) / picture_.height() * shown.height())
      .toPoint();
}

void ImageCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  // A neutral surround in either theme: colours are judged against it.
  painter.fillRect(rect(), theme().isDark ? QColor("#16181b") : QColor("#d9dbde"));
  if (picture_.isNull()) {
    painter.setPen(theme().faintText);
    painter.drawText(rect(), Qt::AlignCenter, tr("Choose a view and press Render."));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF shown = frame();
  painter.drawImage(shown, picture_);
  if (split_ > 0 && !earlier_.isNull()) {
    QRectF left = shown;
    left.setWidth(shown.width() * split_);
    painter.drawImage(left, earlier_, QRectF(0, 0, earlier_.width() * split_, earlier_.height()));
    painter.setPen(QPen(theme().accent, 2));
    painter.drawLine(left.topRight(), left.bottomRight());
  }
  if (mark_.x() >= 0) {
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = shown.width() / picture_.width();
    const double r = std::max(4.0, (radius_ + 0.5) * scale);
    painter.setPen(QPen(Qt::black, 3));
    painter.drawEllipse(QPointF(toWidget(mark_)), r, r);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.drawEllipse(QPointF(toWidget(mark_)), r, r);
  }
  paintRegion(painter);
}

void ImageCanvas::paintRegion(QPainter& painter) const {
  const QPolygonF& drawn = growing_.isEmpty() ? region_ : growing_;
  if (drawn.size() < 2) return;
  const QRectF shown = frame();
  QPolygonF corners;
  for (const QPointF& p : drawn)
    corners << QPointF(shown.left() + p.x() / picture_.width() * shown.width(),
                       shown.top() + p.y() / picture_.height() * shown.height());
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [colour, width] : {std::pair(QColor(Qt::black), 3.0), std::pair(QColor(Qt::white), 1.5)}) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (growing_.isEmpty() || tool_ == Tool::rectangle) {
      painter.drawPolygon(corners);
    } else {
      painter.drawPolyline(corners);
    }
  }
}

QPointF ImageCanvas::placeAt(const QPoint& at) const {
  const QRectF shown = frame();
  return {std::clamp((at.x() - shown.left()) / shown.width(), 0.0, 1.0) * picture_.width(),
          std::clamp((at.y() - shown.top()) / shown.height(), 0.0, 1.0) * picture_.height()};
}

void ImageCanvas::finish(bool isRegion) {
  if (isRegion) region_ = growing_;
  growing_.clear();
  update();
  Q_EMIT regionDrawn();
}

void ImageCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (!growing_.isEmpty()) {
    const QPointF to = placeAt(event->pos());
    if (tool_ == Tool::rectangle) {
      const QPointF from = growing_.front();
      growing_ = QVector<QPointF>{from, QPointF(to.x(), from.y()), to, QPointF(from.x(), to.y())};
    } else {
      growing_.back() = to;
    }
    update();
  }
  Q_EMIT pixelPointed(pixelAt(event->pos()));
}

void ImageCanvas::mousePressEvent(QMouseEvent* event) {
  const QPoint pixel = pixelAt(event->pos());
  if (event->button() != Qt::LeftButton || picture_.isNull()) return;
  setFocus(Qt::MouseFocusReason);
  if (tool_ == Tool::point) {
    if (pixel.x() >= 0) Q_EMIT pixelClicked(pixel);
    return;
  }
  const QPointF at = placeAt(event->pos());
  if (tool_ == Tool::rectangle) {
    growing_ = QVector<QPointF>{at, at, at, at};
    return;
  }
  if (growing_.isEmpty()) {
    growing_ = QVector<QPointF>{at, at};
    return;
  }
  // A click at the first corner closes the polygon.
  constexpr double reach = 8;  // pixels of the screen
  const double scale = frame().width() / picture_.width();
  const QPointF away = (at - growing_.front()) * scale;
  if (growing_.size() > 3 && std::hypot(away.x(), away.y()) < reach) {
    growing_.removeLast();
    return finish(true);
  }
  growing_.back() = at;
  growing_ << at;
}

void ImageCanvas::mouseReleaseEvent(QMouseEvent*) {
  if (tool_ != Tool::rectangle || growing_.isEmpty()) return;
  const QRectF box = growing_.boundingRect();
  finish(box.width() >= 1 && box.height() >= 1);
}

void ImageCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  // The first click of the two has set the last corner already.
  if (tool_ != Tool::polygon || growing_.isEmpty()) return mousePressEvent(event);
  growing_.removeLast();
  if (growing_.size() >= 3) return finish(true);
  growing_ << placeAt(event->pos());
}

void ImageCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
  region_.clear();
  finish(false);
}

}  // namespace goniolux::gui
