// RoomPage: the 3-D view with what belongs to it: directions of view, cut, measuring, snapping, legend.
#pragma once

#include <QWidget>
#include <memory>

#include "app/gui/document/checked_project.h"
#include "app/gui/room/legend.h"
#include "app/gui/room/room_view.h"

class QAction;
class QComboBox;
class QSlider;
class QToolBar;

namespace goniolux::gui {

class RoomPage final : public QWidget {
  Q_OBJECT
 public:
  explicit RoomPage(QWidget* parent = nullptr);
  void showProject(const CheckedProject& checked, bool frame);
  void showOverlay(std::shared_ptr<const GridOverlay> overlay);
  void applyColours();
  [[nodiscard]] RoomView& view() { return *view_; }

 private:
  void addPresets();
  void addTools();
  void updateCut();

  QToolBar* bar_;
  RoomView* view_;
  Legend* legend_;
  QAction* falseColour_ = nullptr;
  QAction* cutting_ = nullptr;
  QComboBox* cutSide_ = nullptr;
  QSlider* cutPlace_ = nullptr;
  QComboBox* views_ = nullptr;
  QComboBox* snap_ = nullptr;
  std::shared_ptr<const RoomScene> scene_;
  std::shared_ptr<const GridOverlay> overlay_;
  std::vector<scene::View> projectViews_;
};

}  // namespace goniolux::gui
