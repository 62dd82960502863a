#include "app/gui/picture/image_canvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "app/gui/window/theme.h"

namespace goniolux::gui {

ImageCanvas::ImageCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName("imageCanvas");
  setAccessibleName(tr("Rendered picture"));
  setMouseTracking(true);
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
}

void ImageCanvas::mouseMoveEvent(QMouseEvent* event) {
  Q_EMIT pixelPointed(pixelAt(event->pos()));
}

void ImageCanvas::mousePressEvent(QMouseEvent* event) {
  const QPoint pixel = pixelAt(event->pos());
  if (event->button() == Qt::LeftButton && pixel.x() >= 0) Q_EMIT pixelClicked(pixel);
}

}  // namespace goniolux::gui
