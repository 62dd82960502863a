// ImageCanvas: a picture, fitted, with an earlier one beside it behind a movable line. What is measured in it is
// pointed at, or drawn as a rectangle (dragged) or a polygon (clicked corner by corner, closed by a double click or at
// its first corner; Escape takes it back).
#pragma once

#include <QImage>
#include <QPolygonF>
#include <QWidget>

namespace goniolux::gui {

class ImageCanvas final : public QWidget {
  Q_OBJECT
 public:
  enum class Tool { point, rectangle, polygon };

  explicit ImageCanvas(QWidget* parent = nullptr);
  /// What the mouse draws; what was drawn is forgotten.
  void setTool(Tool tool);
  void show(const QImage& picture);
  void setEarlier(const QImage& picture);
  /// Left of this share of the width stands the earlier picture; 0: only the new one.
  void setSplit(double share);
  /// The circle that is measured, in pixels of the picture; below 0: none.
  void setMark(const QPoint& pixel, int radius);
  [[nodiscard]] const QImage& picture() const { return picture_; }
  /// Corners of what was drawn, in pixels of the picture from its upper left corner; empty: nothing.
  [[nodiscard]] const QPolygonF& region() const { return region_; }
  /// Where a pixel of the picture is in the widget.
  [[nodiscard]] QPoint toWidget(const QPoint& pixel) const;

 Q_SIGNALS:
  void pixelPointed(const QPoint& pixel);  ///< (-1, -1) beside the picture
  void pixelClicked(const QPoint& pixel);
  void regionDrawn();  ///< or taken back

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void paintRegion(QPainter& painter) const;
  [[nodiscard]] QPointF placeAt(const QPoint& at) const;  ///< in pixels of the picture, held inside it
  void finish(bool isRegion);
  [[nodiscard]] QRectF frame() const;
  [[nodiscard]] QPoint pixelAt(const QPoint& at) const;

  QImage picture_, earlier_;
  double split_ = 0;
  QPoint mark_{-1, -1};
  int radius_ = 0;
  Tool tool_ = Tool::point;
  QPolygonF region_, growing_;  ///< growing: its last corner follows the mouse
};

}  // namespace goniolux::gui
