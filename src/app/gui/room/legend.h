// Legend: the scale of the false colours, beside the picture that they are in.
#pragma once

#include <QWidget>
#include <memory>

#include "app/gui/room/grid_overlay.h"

namespace goniolux::gui {

class Legend final : public QWidget {
  Q_OBJECT
 public:
  explicit Legend(QWidget* parent = nullptr);
  void show(std::shared_ptr<const GridOverlay> overlay);
  [[nodiscard]] QSize sizeHint() const override { return {112, 320}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const GridOverlay> overlay_;
};

}  // namespace goniolux::gui
