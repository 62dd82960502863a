// RoomView: the project in three dimensions. Drag turns, Shift-drag or the middle button pans, the wheel zooms to the
// mouse; a click selects, a drag of a selected luminaire moves it in its plane.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkSmartPointer.h>
#include <QPoint>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>

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
  void select(const std::string& pointer);
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
  /// Cuts away what lies above this height; nothing: no cut.
  void setCut(std::optional<double> height);
  /// Takes over the colours of the theme.
  void applyColours();

  [[nodiscard]] const std::string& selection() const { return selection_; }
  /// Where a point is in the widget.
  [[nodiscard]] QPoint toWidget(const core::Vec3& point) const;
  [[nodiscard]] const OrbitCamera& orbitCamera() const { return camera_; }
  /// Draws at once and waits for it: for the frame rate.
  void drawNow();

 Q_SIGNALS:
  void selected(const QString& pointer);
  /// The entry was dragged by so many metres.
  void moved(const QString& pointer, double x, double y, double z);
  void pointed(const QString& words);  ///< what lies under the mouse, or a measured distance

 protected:
  bool event(QEvent* event) override;

 private:
  struct Drag {
    enum class Kind { orbit, pan, move } kind = Kind::orbit;
    QPoint from, last;
    int luminaire = -1;
    core::Vec3 grip{0}, delta{0};
  };
  void buildActors();
  void showLuminaires();
  void showSelection();
  void update3d();
  [[nodiscard]] Ray rayThrough(const QPoint& at) const;
  bool press(const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers keys);
  bool drag(const QPoint& at, Qt::KeyboardModifiers keys);
  bool release(const QPoint& at);
  void hover(const QPoint& at);
  void wheel(const QPoint& at, double steps);
  void measure(const QPoint& at);
  [[nodiscard]] core::Vec3 planeNormal() const;

  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> room_, objects_, edges_, luminaires_, rims_, aims_, chosen_, colours_, isolines_, ruler_;
  vtkSmartPointer<vtkPlane> cut_;
  std::shared_ptr<const RoomScene> scene_;
  OrbitCamera camera_;
  OrbitCamera::Preset preset_ = OrbitCamera::Preset::perspective;
  std::string selection_;
  std::optional<Drag> drag_;
  std::optional<core::Vec3> measuredFrom_;
  bool isMeasuring_ = false;
  double snap_ = 0.1;
  QTimer draw_;
};

}  // namespace goniolux::gui
