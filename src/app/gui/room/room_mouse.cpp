// The mouse in the 3-D view: turning, moving, choosing, measuring.
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
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
  const double distance =
      camera.isParallel() ? RoomView::parallelDistance : glm::length(camera.eye() - camera.target());
  return 9 * camera.span() / std::max(height, 1) / distance;
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
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      return release(mouse->pos(), mouse->modifiers());
    }
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

bool RoomView::grip(const QPoint& at, Qt::KeyboardModifiers keys, Drag& drag) const {
  const Ray ray = visibleRay(at);
  const double reach = reachOf(camera_, height());
  const auto isSelected = [&](const Picked& picked) {
    return std::find(selection_.begin(), selection_.end(), picked.pointer) != selection_.end();
  };
  // A selected luminaire first, even behind something: it shows by its frame.
  auto picked = pick(*scene_, ray, reach, true);
  if (!picked || !isSelected(*picked)) picked = pick(*scene_, ray, reach);
  if (!picked || !isSelected(*picked)) return false;
  const auto entry = scene_->entries.find(picked->pointer);
  if (entry != scene_->entries.end() && entry->second.isRoom) return false;
  drag.start = picked->luminaire >= 0 ? scene_->luminaires[static_cast<std::size_t>(picked->luminaire)].position
                                      : ray.origin + picked->distance * ray.direction;
  const bool turns = keys.testFlag(Qt::AltModifier);
  const auto gripped = onPlane(ray, drag.start, turns ? Vec3(0, 0, 1) : planeNormal());
  if (!gripped) return false;
  drag.grip = *gripped;
  drag.kind = turns ? Drag::Kind::turn : Drag::Kind::move;
  drag.center = picked->luminaire >= 0           ? drag.start
                : entry != scene_->entries.end() ? entry->second.center
                                                 : drag.start;
  return true;
}

bool RoomView::press(const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
  if (button != Qt::LeftButton && button != Qt::MiddleButton) return false;
  Drag drag;
  drag.from = drag.last = at;
  const bool shift = keys.testFlag(Qt::ShiftModifier);
  drag.kind = button == Qt::MiddleButton || shift ? Drag::Kind::pan : Drag::Kind::orbit;
  if (camera_.isParallel() && preset_ == OrbitCamera::Preset::plan && drag.kind == Drag::Kind::orbit)
    drag.kind = Drag::Kind::pan;
  if (button == Qt::LeftButton && scene_ && !isMeasuring_ && !shift) grip(at, keys, drag);
  drag_ = drag;
  return true;
}

void RoomView::moveSelected(const QPoint& at, Qt::KeyboardModifiers keys) {
  const Vec3 normal = planeNormal();
  const auto to = onPlane(rayThrough(at), drag_->start, normal);
  if (!to) return;
  const Vec3 by = *to - drag_->grip;
  // A luminaire comes to stand on the steps; what is gripped anywhere moves by steps.
  const bool standsOnSteps = drag_->start == drag_->center;
  if (keys.testFlag(Qt::ControlModifier)) {
    drag_->delta = by;
  } else {
    drag_->delta = standsOnSteps ? snapped(drag_->start + by, snap_) - drag_->start : snapped(by, snap_);
  }
  // Along the plane's normal nothing moves: snapping must not lift a luminaire off its height.
  drag_->delta -= glm::dot(drag_->delta, normal) * normal;
  chosen_->SetPosition(drag_->delta.x, drag_->delta.y, drag_->delta.z);
  const Vec3 now = standsOnSteps ? drag_->start + drag_->delta : drag_->delta;
  const QString words = standsOnSteps ? tr("to x %1 m, y %2 m, z %3 m") : tr("by x %1 m, y %2 m, z %3 m");
  Q_EMIT pointed(words.arg(now.x, 0, 'f', 2).arg(now.y, 0, 'f', 2).arg(now.z, 0, 'f', 2));
}

void RoomView::turnSelected(const QPoint& at, Qt::KeyboardModifiers keys) {
  constexpr double steps = 15;  // degrees
  const auto to = onPlane(rayThrough(at), drag_->grip, {0, 0, 1});
  if (!to) return;
  const Vec3 from = drag_->grip - drag_->center, now = *to - drag_->center;
  // What is gripped at its very centre turns with the mouse's way across.
  const double angle = std::hypot(from.x, from.y) < 0.1
                           ? (at.x() - drag_->from.x()) * 0.5
                           : (std::atan2(now.y, now.x) - std::atan2(from.y, from.x)) / core::degree;
  drag_->degrees = std::remainder(angle, 360);
  if (!keys.testFlag(Qt::ControlModifier)) drag_->degrees = steps * std::round(drag_->degrees / steps);
  const double c = std::cos(drag_->degrees * core::degree), s = std::sin(drag_->degrees * core::degree);
  const Vec3& m = drag_->center;
  chosen_->SetOrientation(0, 0, drag_->degrees);
  chosen_->SetPosition(m.x - c * m.x + s * m.y, m.y - s * m.x - c * m.y, 0);
  Q_EMIT pointed(tr("turned by %1°").arg(drag_->degrees, 0, 'f', 0));
}

bool RoomView::drag(const QPoint& at, Qt::KeyboardModifiers keys) {
  const QPoint by = at - drag_->last;
  switch (drag_->kind) {
    case Drag::Kind::move:
    case Drag::Kind::turn:
      if ((at - drag_->from).manhattanLength() <= clickReach) return true;
      if (drag_->kind == Drag::Kind::move) {
        moveSelected(at, keys);
      } else {
        turnSelected(at, keys);
      }
      break;
    case Drag::Kind::pan:
      camera_.pan(by.x(), by.y(), height());
      break;
    case Drag::Kind::orbit:
      camera_.orbit(by.x(), by.y(), height());
      break;
  }
  drag_->last = at;
  update3d();
  return true;
}

bool RoomView::release(const QPoint& at, Qt::KeyboardModifiers keys) {
  if (!drag_) return false;
  const Drag done = *drag_;
  drag_.reset();
  const bool isClick = (at - done.from).manhattanLength() <= clickReach;
  if (!isClick && done.kind == Drag::Kind::move && glm::length(done.delta) > 1e-9) {
    chosen_->SetPosition(0, 0, 0);
    Q_EMIT moved(done.delta.x, done.delta.y, done.delta.z);
  } else if (!isClick && done.kind == Drag::Kind::turn && done.degrees != 0) {
    showSelection();
    Q_EMIT turned(done.degrees);
  } else if (isClick && isMeasuring_) {
    measure(at);
  } else if (isClick && scene_) {
    const auto picked = pick(*scene_, visibleRay(at), reachOf(camera_, height()));
    Q_EMIT selected(picked ? QString::fromStdString(picked->pointer) : QString(), keys.testFlag(Qt::ControlModifier));
  }
  update3d();
  return true;
}

void RoomView::hover(const QPoint& at) {
  if (!scene_ || !isMeasuring_ || !measuredFrom_) return;
  const Ray ray = visibleRay(at);
  const auto picked = pick(*scene_, ray, 0);
  if (!picked) return;
  setData(*ruler_, lineBetween(*measuredFrom_, ray.origin + picked->distance * ray.direction));
  update3d();
}

void RoomView::measure(const QPoint& at) {
  const Ray ray = visibleRay(at);
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
