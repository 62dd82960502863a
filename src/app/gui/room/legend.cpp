#include "app/gui/room/legend.h"

#include <QPainter>
#include <algorithm>

#include "app/gui/window/theme.h"
#include "plot/number_text.h"

namespace goniolux::gui {

Legend::Legend(QWidget* parent) : QWidget(parent) {
  setMinimumWidth(112);
  setMaximumWidth(112);
  setVisible(false);
}

void Legend::show(std::shared_ptr<const GridOverlay> overlay) {
  overlay_ = std::move(overlay);
  setVisible(overlay_ && overlay_->scale);
  update();
}

void Legend::paintEvent(QPaintEvent*) {
  if (!overlay_ || !overlay_->scale) return;
  const plot::ColourScale& scale = *overlay_->scale;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme().text);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.drawText(QRect(12, 10, width() - 14, 20), Qt::AlignLeft, tr("Illuminance"));
  painter.setFont(font());
  painter.setPen(theme().faintText);
  painter.drawText(QRect(12, 29, width() - 14, 20), Qt::AlignLeft,
                   tr("in %1").arg(QString::fromStdString(overlay_->unit)));
  const int top = 62, barHeight = std::clamp(height() - top - 24, 60, 420);
  const QRect bar(12, top, 20, barHeight);
  const auto& edges = scale.edges();
  const int fields = static_cast<int>(edges.size()) - 1;
  for (int k = 0; k < fields; ++k) {
    const plot::Rgb c = scale.atFraction((k + 0.5) / fields);
    const double y0 = bar.bottom() + 1 - (k + 1.0) * barHeight / fields,
                 y1 = bar.bottom() + 1 - 1.0 * k * barHeight / fields;
    painter.fillRect(QRectF(bar.left(), y0, bar.width(), y1 - y0), QColor(c[0], c[1], c[2]));
  }
  painter.setPen(theme().border);
  painter.drawRect(bar.adjusted(0, 0, -1, 0));
  for (int k = 0; k <= fields; ++k) {
    const double y = bar.bottom() + 1 - 1.0 * k * barHeight / fields;
    const bool isEnd = k == 0 || k == fields;
    painter.setPen(isEnd ? theme().faintText : theme().text);
    painter.drawLine(QPointF(bar.right() + 2, y), QPointF(bar.right() + 6, y));
    const double value = edges[static_cast<std::size_t>(k)];
    painter.drawText(QRectF(bar.right() + 10, y - 9, 70, 18), Qt::AlignLeft | Qt::AlignVCenter,
                     QString::fromStdString(isEnd ? plot::pointText(value) : plot::levelText(value)));
  }
}

}  // namespace goniolux::gui
