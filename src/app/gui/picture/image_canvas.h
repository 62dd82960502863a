// ImageCanvas: a picture, fitted or zoomed, with an earlier one beside it behind a movable line.
#pragma once

#include <QImage>
#include <QWidget>

namespace goniolux::gui {

class ImageCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit ImageCanvas(QWidget* parent = nullptr);
  void show(const QImage& picture);
  void setEarlier(const QImage& picture);
  /// Left of this share of the width stands the earlier picture; 0: only the new one.
  void setSplit(double share);
  /// The circle that is measured, in pixels of the picture; below 0: none.
  void setMark(const QPoint& pixel, int radius);
  [[nodiscard]] const QImage& picture() const { return picture_; }
  /// Where a pixel of the picture is in the widget.
  [[nodiscard]] QPoint toWidget(const QPoint& pixel) const;

 Q_SIGNALS:
  void pixelPointed(const QPoint& pixel);  ///< (-1, -1) beside the picture
  void pixelClicked(const QPoint& pixel);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] QRectF frame() const;
  [[nodiscard]] QPoint pixelAt(const QPoint& at) const;

  QImage picture_, earlier_;
  double split_ = 0;
  QPoint mark_{-1, -1};
  int radius_ = 0;
};

}  // namespace goniolux::gui
