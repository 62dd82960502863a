#include "app/gui/plots/qt_ink.h"

#include <vtkImageData.h>

#include <QFontMetricsF>

namespace goniolux::gui {
namespace {

QColor colourOf(const plot::Rgb& c, int opacity) {
  return {c[0], c[1], c[2], opacity};
}

}  // namespace

QtInk::QtInk(QPainter& painter, int height) : painter_(painter), height_(height) {
  painter_.setRenderHint(QPainter::Antialiasing);
  painter_.setRenderHint(QPainter::SmoothPixmapTransform);
}

QPolygonF QtInk::polygon(const plot::Polyline& points) const {
  QPolygonF result;
  for (const core::Vec2& p : points) result << QPointF(p.x, height_ - p.y);
  return result;
}

void QtInk::line(const plot::Polyline& points, const plot::Rgb& colour, double width, int opacity) {
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(QPen(colourOf(colour, opacity), width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter_.drawPolyline(polygon(points));
}

void QtInk::area(const plot::Polyline& corners, const plot::Rgb& colour, int opacity) {
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(colourOf(colour, opacity));
  painter_.drawPolygon(polygon(corners));
}

void QtInk::text(const std::string& words, const core::Vec2& at, const plot::TextStyle& style) {
  QFont font("DejaVu Sans");
  font.setPixelSize(style.size);
  font.setBold(style.bold);
  painter_.setFont(font);
  painter_.setPen(colourOf(style.colour, 255));
  const QString text = QString::fromStdString(words);
  const QFontMetricsF metrics(font);
  const double width = metrics.horizontalAdvance(text);
  using Align = plot::TextStyle::Align;
  const double left = style.align == Align::left ? 0 : style.align == Align::center ? -width / 2 : -width;
  painter_.save();
  painter_.translate(at.x, height_ - at.y);
  painter_.rotate(-style.angle / core::degree);
  painter_.drawText(QPointF(left, metrics.capHeight() / 2), text);
  painter_.restore();
}

void QtInk::image(const core::Vec2& low, const core::Vec2& high, vtkImageData* image) {
  int size[3];
  image->GetDimensions(size);
  const QImage rows(static_cast<const uchar*>(image->GetScalarPointer()), size[0], size[1], 4 * size[0],
                    QImage::Format_RGBA8888);
  painter_.drawImage(QRectF(low.x, height_ - high.y, high.x - low.x, high.y - low.y), rows.mirrored(false, true));
}

}  // namespace goniolux::gui
