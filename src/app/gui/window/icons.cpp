#include "app/gui/window/icons.h"

#include <QIconEngine>
#include <QMap>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include "app/gui/window/theme.h"

namespace goniolux::gui {
namespace {

/// Strokes on a field of 24 x 24: "M x y" begins, "L x y" goes on, "Z" closes, "O x y r" is a circle.
const QMap<QString, QString>& drawings() {
  static const QMap<QString, QString> map{
      {"new", "M 6 3 L 14 3 L 18 7 L 18 21 L 6 21 Z M 12 10 L 12 17 M 8.5 13.5 L 15.5 13.5"},
      {"open", "M 3 19 L 3 5 L 9 5 L 11 8 L 20 8 L 20 11 M 3 19 L 6 11 L 22 11 L 19 19 Z"},
      {"save", "M 4 4 L 17 4 L 20 7 L 20 20 L 4 20 Z M 8 4 L 8 9 L 15 9 L 15 4 M 7 20 L 7 13 L 17 13 L 17 20"},
      {"undo", "M 8 5 L 4 9 L 8 13 M 4 9 L 15 9 L 19 12 L 19 16 L 15 19 L 9 19"},
      {"redo", "M 16 5 L 20 9 L 16 13 M 20 9 L 9 9 L 5 12 L 5 16 L 9 19 L 15 19"},
      {"run", "M 7 4 L 19 12 L 7 20 Z"},
      {"pause", "M 8 5 L 8 19 M 16 5 L 16 19"},
      {"stop", "M 6 6 L 18 6 L 18 18 L 6 18 Z"},
      {"render", "M 3 7 L 8 7 L 10 4 L 14 4 L 16 7 L 21 7 L 21 19 L 3 19 Z O 12 13 3.6"},
      {"grid", "M 3 4 L 21 4 L 21 20 L 3 20 Z M 9 4 L 9 20 M 15 4 L 15 20 M 3 9.3 L 21 9.3 M 3 14.6 L 21 14.6"},
      {"luminaire", "M 5 4 L 19 4 L 17 9 L 7 9 Z M 12 12 L 12 20 M 8 12 L 5 19 M 16 12 L 19 19"},
      {"object", "M 4 8 L 12 4 L 20 8 L 20 16 L 12 20 L 4 16 Z M 4 8 L 12 12 L 20 8 M 12 12 L 12 20"},
      {"material", "O 12 12 8.5 M 6.5 8 L 16 18 M 5 11.5 L 12.5 19 M 9.5 5 L 19 14.5"},
      {"scene", "O 12 9 5.5 M 9.5 14 L 9.5 18 L 14.5 18 L 14.5 14 M 10 21 L 14 21"},
      {"observer", "M 2 12 L 7 7 L 12 5.5 L 17 7 L 22 12 L 17 17 L 12 18.5 L 7 17 Z O 12 12 3"},
      {"view", "M 3 6 L 21 6 L 21 18 L 3 18 Z M 3 15 L 9 10 L 13 14 L 16 11.5 L 21 16"},
      {"requirement", "M 4 12.5 L 9.5 18 L 20 6"},
      {"settings", "M 4 7 L 20 7 M 4 12 L 20 12 M 4 17 L 20 17 O 9 7 2 O 15 12 2 O 7 17 2"},
      {"project", "M 3 20 L 3 9 L 12 3 L 21 9 L 21 20 Z M 9 20 L 9 13 L 15 13 L 15 20"},
      {"perspective", "M 4 8 L 12 4 L 20 8 L 20 16 L 12 20 L 4 16 Z M 4 8 L 12 12 L 20 8 M 12 12 L 12 20"},
      {"plan", "M 4 4 L 20 4 L 20 20 L 4 20 Z M 4 13 L 12 13 L 12 20"},
      {"front", "M 4 6 L 20 6 L 20 19 L 4 19 Z M 8 19 L 8 12 L 12 12 L 12 19 M 2 19 L 22 19"},
      {"side", "M 5 9 L 12 4 L 19 9 L 19 19 L 5 19 Z M 2 19 L 22 19"},
      {"fit", "M 4 9 L 4 4 L 9 4 M 15 4 L 20 4 L 20 9 M 20 15 L 20 20 L 15 20 M 9 20 L 4 20 L 4 15"},
      {"measure", "M 3 16 L 16 3 L 21 8 L 8 21 Z M 7 12 L 9.5 14.5 M 10 9 L 11.5 10.5 M 13 6 L 15.5 8.5"},
      {"cut", "M 3 12 L 21 12 M 6 8 L 12 4 L 18 8 M 6 16 L 12 20 L 18 16"},
      {"aim", "M 12 3 L 12 19 M 7 14 L 12 19 L 17 14"},
      {"import", "M 12 3 L 12 14 M 7.5 9.5 L 12 14 L 16.5 9.5 M 4 15 L 4 20 L 20 20 L 20 15"},
      {"export", "M 12 14 L 12 3 M 7.5 7.5 L 12 3 L 16.5 7.5 M 4 15 L 4 20 L 20 20 L 20 15"},
      {"error", "O 12 12 8.5 M 12 7 L 12 13 M 12 16 L 12 17"},
      {"warning", "M 12 4 L 21 20 L 3 20 Z M 12 10 L 12 15 M 12 17 L 12 18"},
      {"pass", "O 12 12 8.5 M 8 12.5 L 11 15.5 L 16.5 9"},
      {"fail", "O 12 12 8.5 M 9 9 L 15 15 M 15 9 L 9 15"},
      {"undecided", "O 12 12 8.5 M 8 12 L 16 12"},
      {"light",
       "O 12 12 4 M 12 2 L 12 5 M 12 19 L 12 22 M 2 12 L 5 12 M 19 12 L 22 12 M 5 5 L 7 7 M 17 17 L 19 19 M "
       "19 5 L 17 7 M 5 19 L 7 17"},
  };
  return map;
}

QPainterPath pathOf(const QString& drawing) {
  QPainterPath path;
  const QStringList words = drawing.split(' ', Qt::SkipEmptyParts);
  const auto number = [&](int i) { return words.at(i).toDouble(); };
  for (int i = 0; i < words.size(); ++i) {
    const QString& w = words.at(i);
    if (w == "M") path.moveTo(number(i + 1), number(i + 2));
    if (w == "L") path.lineTo(number(i + 1), number(i + 2));
    if (w == "O") path.addEllipse(QPointF(number(i + 1), number(i + 2)), number(i + 3), number(i + 3));
    if (w == "Z") path.closeSubpath();
  }
  return path;
}

/// Draws at any size.
class DrawnIcon final : public QIconEngine {
 public:
  DrawnIcon(QPainterPath path, QColor colour, QColor faint)
      : path_(std::move(path)), colour_(std::move(colour)), faint_(std::move(faint)) {}
  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / 24.0, rect.height() / 24.0);
    painter->setPen(QPen(mode == QIcon::Disabled ? faint_ : colour_, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPath(path_);
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return picture;
  }
  [[nodiscard]] QIconEngine* clone() const override { return new DrawnIcon(path_, colour_, faint_); }

 private:
  QPainterPath path_;
  QColor colour_, faint_;
};

QColor colourFor(const QString& name) {
  const Theme& t = theme();
  if (name == "error" || name == "fail") return t.fail;
  if (name == "warning" || name == "undecided") return t.undecided;
  if (name == "pass") return t.pass;
  if (name == "run") return t.accent;
  QColor colour = t.text;
  colour.setAlphaF(0.85);
  return colour;
}

}  // namespace

QIcon icon(const QString& name) {
  const auto found = drawings().find(name);
  if (found == drawings().end()) return {};
  return QIcon(new DrawnIcon(pathOf(*found), colourFor(name), theme().faintText));
}

QIcon programIcon() {
  // A luminaire over its cone of light: the goniometer's view of the world.
  QIcon result;
  for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
    QPixmap picture(size, size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(size / 64.0, size / 64.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor("#20324a"));
    painter.drawRoundedRect(QRectF(1, 1, 62, 62), 13, 13);
    QPainterPath cone;
    cone.moveTo(32, 17);
    cone.cubicTo(10, 24, 6, 50, 32, 55);
    cone.cubicTo(58, 50, 54, 24, 32, 17);
    QLinearGradient glow(0, 15, 0, 56);
    glow.setColorAt(0, QColor("#fff3c4"));
    glow.setColorAt(1, QColor("#f2a93b"));
    painter.setBrush(glow);
    painter.drawPath(cone);
    painter.setBrush(QColor("#f4f7fa"));
    painter.drawRoundedRect(QRectF(20, 11, 24, 6), 2, 2);
    painter.setPen(QPen(QColor(32, 50, 74, 150), 1.6));
    painter.drawLine(QPointF(32, 17), QPointF(32, 55));
    painter.drawArc(QRectF(14, 0, 36, 34), 205 * 16, 130 * 16);
    painter.end();
    result.addPixmap(picture);
  }
  return result;
}

}  // namespace goniolux::gui
