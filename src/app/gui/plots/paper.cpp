#include "app/gui/plots/paper.h"

#include <QPainter>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/gui/plots/drawing_lock.h"
#include "app/gui/plots/qt_ink.h"
#include "app/gui/window/theme.h"
#include "plot/vtk/line_chart_painter.h"
#include "plot/vtk/polar_painter.h"
#include "plot/vtk/solid_painter.h"

namespace goniolux::gui {
namespace {

/// A painter keeps a reference to its figure: both live as long as the sheet.
template <typename Painter, typename Figure, typename... Size>
Sheet sheetWith(const Figure& figure, Size... size) {
  const auto kept = std::make_shared<const Figure>(figure);
  const auto painter = std::make_shared<const Painter>(*kept, size...);
  return {painter->width(), painter->height(), [kept, painter](plot::Ink& ink) { painter->paint(ink); }};
}

}  // namespace

Sheet sheetOf(const plot::PolarDiagram& diagram) {
  return sheetWith<plot::PolarPainter>(diagram);
}
Sheet sheetOf(const plot::PhotometricSolid& solid) {
  return sheetWith<plot::SolidPainter>(solid);
}
Sheet sheetOf(const plot::LineChart& chart) {
  return sheetWith<plot::LineChartPainter>(chart);
}
Sheet smallSheetOf(const plot::LineChart& chart) {
  return sheetWith<plot::LineChartPainter>(chart, 620, 600);
}

Paper::Paper(const QString& hint, QWidget* parent)
    : QWidget(parent), hint_(hint), drawing_(this, [this](const std::shared_ptr<const Drawn>& drawn) {
        picture_ = drawn->picture;
        failure_ = drawn->failure;
        update();
      }) {
  setMinimumSize(220, 180);
  wait_.setSingleShot(true);
  wait_.setInterval(60);
  connect(&wait_, &QTimer::timeout, this, &Paper::draw);
}

void Paper::show(std::function<Sheet()> make) {
  make_ = std::move(make);
  wait_.start();
}

void Paper::clear() {
  make_ = nullptr;
  picture_ = {};
  failure_.clear();
  update();
}

void Paper::draw() {
  if (!make_ || width() < 10) return;
  drawing_.ask([make = make_, size = size(), dense = devicePixelRatioF()] {
    auto drawn = std::make_shared<Drawn>();
    const QMutexLocker lock(&drawingLock());
    try {
      const Sheet sheet = make();
      const double scale = dense * std::min(static_cast<double>(size.width()) / sheet.width,
                                            static_cast<double>(size.height()) / sheet.height);
      drawn->picture =
          QImage(static_cast<int>(sheet.width * scale), static_cast<int>(sheet.height * scale), QImage::Format_RGB32);
      drawn->picture.fill(Qt::white);
      QPainter painter(&drawn->picture);
      painter.scale(scale, scale);
      QtInk ink(painter, sheet.height);
      sheet.paint(ink);
      painter.end();
      drawn->picture.setDevicePixelRatio(dense);
    } catch (const std::exception& error) {
      drawn->failure = QString::fromUtf8(error.what());
    }
    return drawn;
  });
}

void Paper::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (picture_.isNull()) {
    painter.fillRect(rect(), theme().base);
    painter.setPen(theme().faintText);
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     failure_.isEmpty() ? hint_ : failure_);
    return;
  }
  painter.fillRect(rect(), Qt::white);
  const QSizeF drawn = QSizeF(picture_.size()) / picture_.devicePixelRatio();
  painter.drawImage(QPointF((width() - drawn.width()) / 2, (height() - drawn.height()) / 2), picture_);
}

void Paper::resizeEvent(QResizeEvent*) {
  wait_.start();
}

}  // namespace goniolux::gui
