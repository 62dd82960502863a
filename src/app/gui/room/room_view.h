// RoomView: the project in three dimensions. Drag turns, Shift-drag or the middle button pans, the wheel zooms to the
// mouse; a click selects, with Ctrl several; a drag of what is selected moves it in its plane, with Alt turns it.
//
// A scene of more triangles than software OpenGL draws in a moment is drawn in pieces, the largest objects first: what
// moves shows the first pieces only, and the rest comes in when it rests, a piece in each turn of the event loop.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkSmartPointer.h>
#include <QImage>
#include <QPoint>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/room/grid_overlay.h"
#include "app/gui/room/orbit_camera.h"
#include "app/gui/room/picking.h"
#include "app/gui/room/room_scene.h"
#include "scene/view.h"

class vtkActor;
class vtkGenericOpenGLRenderWindow;
class vtkPlane;
class vtkRenderer;

namespace goniolux::gui {

class RoomView final : public QVTKOpenGLNativeWidget {
  Q_OBJECT
 public:
  explicit RoomView(QWidget* parent = nullptr);
  ~RoomView() override;

  /// Shows a scene; the camera stays where it is unless `frame` asks to show everything. Null: nothing.
  void showScene(std::shared_ptr<const RoomScene> scene, bool frame);
  void showOverlay(std::shared_ptr<const GridOverlay> overlay);
  void select(const std::vector<std::string>& pointers);
  void setPreset(OrbitCamera::Preset preset);
  void frameAll() { setPreset(preset_); }
  void lookThrough(const scene::View& view);
  /// Whether a click begins a measurement instead of a selection.
  void setMeasuring(bool measuring);
  /// m; 0: nothing snaps.
  void setSnap(double step) { snap_ = step; }
  void setAimsVisible(bool visible);
  void setEdgesVisible(bool visible);
  void setOverlayVisible(bool visible);
  void setSolidsVisible(bool visible);
  void setCut(std::optional<Cut> cut);
  /// Takes over the colours of the theme.
  void applyColours();

  [[nodiscard]] const std::vector<std::string>& selection() const { return selection_; }
  /// Where a point is in the widget.
  [[nodiscard]] QPoint toWidget(const core::Vec3& point) const;
  /// So far before its target does a ray of a parallel view begin, m.
  static constexpr double parallelDistance = 1e3;
  [[nodiscard]] const OrbitCamera& orbitCamera() const { return camera_; }
  /// Draws at once, of a large scene the first pieces, and waits for it: for the frame rate.
  void drawNow();
  /// The whole scene, in all its pieces.
  [[nodiscard]] QImage picture();
  /// All pieces of a large scene are there.
  [[nodiscard]] bool isDrawn() const { return nextDetail_ >= details_.size(); }

 Q_SIGNALS:
  /// A click on an entry, or on nothing; `together`: with what is selected.
  void selected(const QString& pointer, bool together);
  /// What is selected was dragged by so many metres.
  void moved(double x, double y, double z);
  /// What is selected was turned about the vertical, anticlockwise seen from above.
  void turned(double degrees);
  void pointed(const QString& words);  ///< what lies under the mouse, or a measured distance

 protected:
  bool event(QEvent* event) override;

 private:
  struct Drag {
    enum class Kind { orbit, pan, move, turn } kind = Kind::orbit;
    QPoint from, last;
    core::Vec3 start{0};  ///< of a move: the luminaire's place, or where an object was gripped
    core::Vec3 grip{0}, delta{0};
    core::Vec3 center{0};  ///< of a turn
    double angle = 0, degrees = 0;
  };
  struct Detail {
    vtkSmartPointer<vtkActor> actor;
    bool isEdges = false, isClosed = false;
  };
  void buildActors();
  [[nodiscard]] std::vector<vtkActor*> plainActors() const;
  void buildDetails();
  void addDetail(vtkPolyData* surface, bool isEdges, bool isClosed);
  void applyCut();
  // room_drawing.cpp
  void aimCamera();
  [[nodiscard]] bool isLarge() const { return details_.size() > leastDetails_; }
  void setVisible(bool plain, std::size_t from, std::size_t to);
  void drawDetail();
  void showLuminaires();
  void showSelection();
  void update3d();
  [[nodiscard]] Ray rayThrough(const QPoint& at) const;
  /// Of that ray what is not cut away.
  [[nodiscard]] Ray visibleRay(const QPoint& at) const { return cut_ ? cut_->of(rayThrough(at)) : rayThrough(at); }
  bool press(const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers keys);
  bool drag(const QPoint& at, Qt::KeyboardModifiers keys);
  bool release(const QPoint& at, Qt::KeyboardModifiers keys);
  void hover(const QPoint& at);
  void wheel(const QPoint& at, double steps);
  void measure(const QPoint& at);
  bool grip(const QPoint& at, Qt::KeyboardModifiers keys, Drag& drag) const;
  void moveSelected(const QPoint& at, Qt::KeyboardModifiers keys);
  void turnSelected(const QPoint& at, Qt::KeyboardModifiers keys);
  [[nodiscard]] core::Vec3 planeNormal() const;

  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> room_, luminaires_, rims_, aims_, solids_, chosen_, colours_, isolines_, ruler_;
  std::vector<Detail> details_;  ///< objects and edges in the order in which they are drawn
  std::size_t leastDetails_ = 0, detailsAtOnce_ = 0, nextDetail_ = 0;
  bool showsEdges_ = true, showsAims_ = true, showsOverlay_ = true, showsSolids_ = true;
  std::optional<Cut> cut_;
  vtkSmartPointer<vtkPlane> cutPlane_;
  std::shared_ptr<const RoomScene> scene_;
  OrbitCamera camera_;
  OrbitCamera::Preset preset_ = OrbitCamera::Preset::perspective;
  std::vector<std::string> selection_;
  std::optional<Drag> drag_;
  std::optional<core::Vec3> measuredFrom_;
  bool isMeasuring_ = false;
  double snap_ = 0.1;
  QTimer draw_, detail_;
};

}  // namespace goniolux::gui
