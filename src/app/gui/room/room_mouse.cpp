// The mouse in the 3-D view: turning, moving, choosing, measuring.
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include <vtkActor.h>

#include "app/gui/room/room_actors.h"
#include "app/gui/room/room_view.h"

namespace goniolux::gui {

using core::Vec3;

namespace {

constexpr int clickReach = 4;  // pixels that a click may wander

/// Half-angle of the cone about the mouse that still hits a small luminaire.
double reachOf(const OrbitCamera& camera, int height) {
  return 9 * camera.span() / std::max(height, 1) / glm::length(camera.eye() - camera.target());
}

}  // namespace

bool RoomView::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      setFocus(Qt::MouseFocusReason);
      return press(mouse->pos(), mouse->button(), mouse->modifiers());
    }
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (drag_) return drag(mouse->pos(), mouse->modifiers());
      hover(mouse->pos());
      return true;
    }
    case QEvent::MouseButtonRelease:
      return release(static_cast<QMouseEvent*>(event)->pos());
    case QEvent::MouseButtonDblClick:
      frameAll();
      return true;
    case QEvent::Wheel: {
      const auto* turned = static_cast<QWheelEvent*>(event);
      wheel(turned->position().toPoint(), turned->angleDelta().y() / 120.0);
      return true;
    }
    case QEvent::Show:
    case QEvent::Resize: {
      const bool handled = QVTKOpenGLNativeWidget::event(event);
      update3d();
      return handled;
    }
    default:
      return QVTKOpenGLNativeWidget::event(event);
  }
}

Vec3 RoomView::planeNormal() const {
  // Level where one looks down or up enough, else the upright plane that faces the viewer.
  const Vec3 forward = camera_.forward();
  if (std::abs(forward.z) > 0.25) return {0, 0, 1};
  return glm::normalize(Vec3(forward.x, forward.y, 0));
}

bool RoomView::press(const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
  if (button != Qt::LeftButton && button != Qt::MiddleButton) return false;
  Drag drag;
  drag.from = drag.last = at;
  const bool shift = keys.testFlag(Qt::ShiftModifier);
  drag.kind = button == Qt::MiddleButton || shift ? Drag::Kind::pan : Drag::Kind::orbit;
  if (camera_.isParallel() && preset_ == OrbitCamera::Preset::plan && drag.kind == Drag::Kind::orbit)
    drag.kind = Drag::Kind::pan;
  if (button == Qt::LeftButton && scene_ && !isMeasuring_ && !shift) {
    const Ray ray = rayThrough(at);
    const auto picked = pick(*scene_, ray, reachOf(camera_, height()), true);
    if (picked && picked->pointer == selection_) {
      drag.luminaire = picked->luminaire;
      const Vec3& position = scene_->luminaires[static_cast<std::size_t>(drag.luminaire)].position;
      if (const auto grip = onPlane(ray, position, planeNormal())) {
        drag.kind = Drag::Kind::move;
        drag.grip = *grip;
      }
    }
  }
  drag_ = drag;
  return true;
}

bool RoomView::drag(const QPoint& at, Qt::KeyboardModifiers keys) {
  const QPoint by = at - drag_->last;
  if (drag_->kind == Drag::Kind::move) {
    const Vec3& position = scene_->luminaires[static_cast<std::size_t>(drag_->luminaire)].position;
    const auto to = onPlane(rayThrough(at), position, planeNormal());
    if (!to || (at - drag_->from).manhattanLength() <= clickReach) return true;
    const Vec3 wanted = position + (*to - drag_->grip);
    drag_->delta = (keys.testFlag(Qt::ControlModifier) ? wanted : snapped(wanted, snap_)) - position;
    // Along the plane's normal nothing moves: snapping must not lift a luminaire off its height.
    const Vec3 normal = planeNormal();
    drag_->delta -= glm::dot(drag_->delta, normal) * normal;
    chosen_->SetPosition(drag_->delta.x, drag_->delta.y, drag_->delta.z);
    const Vec3 now = position + drag_->delta;
    Q_EMIT pointed(tr("to x %1 m, y %2 m, z %3 m").arg(now.x, 0, 'f', 2).arg(now.y, 0, 'f', 2).arg(now.z, 0, 'f', 2));
  } else if (drag_->kind == Drag::Kind::pan) {
    camera_.pan(by.x(), by.y(), height());
  } else {
    camera_.orbit(by.x(), by.y(), height());
  }
  drag_->last = at;
  update3d();
  return true;
}

bool RoomView::release(const QPoint& at) {
  if (!drag_) return false;
  const Drag done = *drag_;
  drag_.reset();
  const bool isClick = (at - done.from).manhattanLength() <= clickReach;
  if (done.kind == Drag::Kind::move && glm::length(done.delta) > 1e-9) {
    chosen_->SetPosition(0, 0, 0);
    Q_EMIT moved(QString::fromStdString(selection_), done.delta.x, done.delta.y, done.delta.z);
  } else if (isClick && isMeasuring_) {
    measure(at);
  } else if (isClick && scene_) {
    const auto picked = pick(*scene_, rayThrough(at), reachOf(camera_, height()));
    Q_EMIT selected(picked ? QString::fromStdString(picked->pointer) : QString());
  }
  update3d();
  return true;
}

void RoomView::hover(const QPoint& at) {
  if (!scene_ || !isMeasuring_ || !measuredFrom_) return;
  const auto picked = pick(*scene_, rayThrough(at), 0);
  if (!picked) return;
  const Ray ray = rayThrough(at);
  setData(*ruler_, lineBetween(*measuredFrom_, ray.origin + picked->distance * ray.direction));
  update3d();
}

void RoomView::measure(const QPoint& at) {
  const Ray ray = rayThrough(at);
  const auto picked = scene_ ? pick(*scene_, ray, 0) : std::nullopt;
  if (!picked) return;
  const Vec3 point = ray.origin + picked->distance * ray.direction;
  if (!measuredFrom_) {
    measuredFrom_ = point;
    Q_EMIT pointed(tr("measuring: click the second point"));
    return;
  }
  const Vec3 d = point - *measuredFrom_;
  setData(*ruler_, lineBetween(*measuredFrom_, point));
  Q_EMIT pointed(tr("distance %1 m (x %2, y %3, z %4)")
                     .arg(glm::length(d), 0, 'f', 3)
                     .arg(d.x, 0, 'f', 3)
                     .arg(d.y, 0, 'f', 3)
                     .arg(d.z, 0, 'f', 3));
  measuredFrom_.reset();
}

void RoomView::wheel(const QPoint& at, double steps) {
  const Ray ray = rayThrough(at);
  const auto point = onPlane(ray, camera_.target(), camera_.forward());
  camera_.zoom(std::pow(1.15, steps), point.value_or(camera_.target()));
  update3d();
}

}  // namespace goniolux::gui
