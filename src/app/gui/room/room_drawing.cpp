// How the 3-D view is drawn: a small scene as a whole, a large one in pieces.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <QElapsedTimer>

#include <algorithm>

#include "app/gui/room/room_actors.h"
#include "app/gui/room/room_view.h"

namespace goniolux::gui {
namespace {

// Of a picture while it moves, ms: more pieces below the first, fewer above the second.
constexpr qint64 quickPicture = 15, slowPicture = 42;
constexpr int restBeforeDetails = 120;  // ms
constexpr double forwardShare = 0.002;  // of the distance, by which edges go before their surfaces

}  // namespace

void RoomView::update3d() {
  // One picture for all that changes in one turn of the event loop.
  if (isVisible() && !draw_.isActive()) draw_.start();
}

void RoomView::aimCamera() {
  vtkCamera& camera = *renderer_->GetActiveCamera();
  camera_.applyTo(camera);
  // By the whole scene, whatever of it is visible: all pieces must share one depth.
  if (scene_) {
    const core::Vec3 margin(0.05 * scene_->size());
    const core::Vec3 low = scene_->low - margin, high = scene_->high + margin;
    const double bounds[6] = {low.x, high.x, low.y, high.y, low.z, high.z};
    renderer_->ResetCameraClippingRange(bounds);
  } else {
    renderer_->ResetCameraClippingRange();
  }
  double range[2];
  camera.GetClippingRange(range);
  const double span = std::max(range[1] - range[0], 1e-9);
  // A point nearer by a share e of its distance: z of the clip space is less by e times the constant of its row.
  const double depth = camera_.isParallel() ? 2 * forwardShare * glm::length(camera_.eye() - camera_.target()) / span
                                            : 2 * forwardShare * range[0] * range[1] / span;
  for (vtkActor* lines : {rims_.Get(), chosen_.Get()}) drawForward(*lines, depth);
  for (const Detail& detail : details_)
    if (detail.isEdges) drawForward(*detail.actor, depth);
}

void RoomView::setVisible(bool plain, std::size_t from, std::size_t to) {
  for (vtkActor* actor : plainActors()) actor->SetVisibility(plain ? 1 : 0);
  if (plain) {
    aims_->SetVisibility(showsAims_ ? 1 : 0);
    colours_->SetVisibility(showsOverlay_ ? 1 : 0);
    isolines_->SetVisibility(showsOverlay_ ? 1 : 0);
  }
  for (std::size_t i = 0; i < details_.size(); ++i)
    details_[i].actor->SetVisibility(i >= from && i < to && (showsEdges_ || !details_[i].isEdges) ? 1 : 0);
}

void RoomView::drawNow() {
  if (!isVisible() || width() < 2) return;
  draw_.stop();
  detail_.stop();
  aimCamera();
  setVisible(true, 0, detailsAtOnce_);
  QElapsedTimer clock;
  clock.start();
  window_->Render();
  nextDetail_ = detailsAtOnce_;
  if (!isLarge()) return;
  window_->WaitForCompletion();
  if (clock.elapsed() < quickPicture && detailsAtOnce_ < details_.size()) ++detailsAtOnce_;
  if (clock.elapsed() > slowPicture && detailsAtOnce_ > leastDetails_) --detailsAtOnce_;
  setVisible(true, 0, details_.size());  // as Qt would have it drawn when it asks by itself
  if (nextDetail_ < details_.size()) detail_.start(drag_ ? restBeforeDetails : 0);
}

void RoomView::drawDetail() {
  if (!isVisible() || nextDetail_ >= details_.size()) return;
  // Over what is there already.
  renderer_->SetPreserveColorBuffer(true);
  renderer_->SetPreserveDepthBuffer(true);
  setVisible(false, nextDetail_, nextDetail_ + 1);
  window_->Render();
  renderer_->SetPreserveColorBuffer(false);
  renderer_->SetPreserveDepthBuffer(false);
  setVisible(true, 0, details_.size());
  if (++nextDetail_ < details_.size()) detail_.start(0);
}

QImage RoomView::picture() {
  drawNow();
  while (nextDetail_ < details_.size()) drawDetail();
  return grabFramebuffer();
}

}  // namespace goniolux::gui
