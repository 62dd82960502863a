#include "app/gui/room/room_view.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <cmath>
#include <utility>

#include "app/gui/room/room_actors.h"
#include "app/gui/window/theme.h"

namespace goniolux::gui {

using core::Vec3;

RoomView::RoomView(QWidget* parent)
    : QVTKOpenGLNativeWidget(parent),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      cut_(vtkSmartPointer<vtkPlane>::New()) {
  setObjectName("roomView");
  setAccessibleName(tr("3-D view of the room"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(200, 160);
  window_->SetMultiSamples(0);
  setRenderWindow(window_);
  window_->AddRenderer(renderer_);
  draw_.setSingleShot(true);
  draw_.setInterval(0);
  connect(&draw_, &QTimer::timeout, this, &RoomView::drawNow);
  interactor()->SetInteractorStyle(nullptr);  // the mouse is read here
  renderer_->SetAutomaticLightCreation(false);
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  renderer_->AddLight(light);
  renderer_->SetUseFXAA(true);
  buildActors();
  applyColours();
}

RoomView::~RoomView() = default;

void RoomView::buildActors() {
  for (auto* actor :
       {&room_, &objects_, &edges_, &luminaires_, &rims_, &aims_, &chosen_, &colours_, &isolines_, &ruler_}) {
    *actor = emptyActor();
    renderer_->AddActor(*actor);
  }
  makeSurface(*room_, true);
  makeSurface(*objects_, false);
  colours_->GetProperty()->SetLighting(false);
  colours_->GetMapper()->SetScalarModeToUseCellData();
  colours_->GetProperty()->SetOpacity(0.92);
  // Lines go before the surfaces that they bound.
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  for (vtkActor* lines : {edges_.Get(), rims_.Get(), chosen_.Get()})
    lines->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -40);
  for (vtkActor* surfaces : {room_.Get(), objects_.Get()})
    surfaces->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
}

void RoomView::applyColours() {
  const Theme& t = theme();
  const auto rgb = [](const QColor& c, double* to) { c.getRgbF(&to[0], &to[1], &to[2]); };
  double top[3], bottom[3];
  rgb(t.viewTop, top);
  rgb(t.viewBottom, bottom);
  renderer_->GradientBackgroundOn();
  renderer_->SetBackground(bottom);
  renderer_->SetBackground2(top);
  makePlain(*edges_, t.edge, 1);
  makePlain(*luminaires_, t.luminaire);
  makePlain(*rims_, t.aim.darker(130), 1.5F);
  makePlain(*aims_, t.aim, 1.5F);
  makePlain(*chosen_, t.selection, 3);
  makePlain(*isolines_, QColor("#202020"), 1.2F);
  makePlain(*ruler_, t.selection, 2);
  update3d();
}

void RoomView::showScene(std::shared_ptr<const RoomScene> scene, bool frame) {
  scene_ = std::move(scene);
  if (!scene_) {
    for (auto* actor :
         {&room_, &objects_, &edges_, &luminaires_, &rims_, &aims_, &chosen_, &colours_, &isolines_, &ruler_})
      setData(**actor, nullptr);
    return update3d();
  }
  setData(*room_, scene_->room);
  setData(*objects_, scene_->objects);
  setData(*edges_, scene_->edges);
  showLuminaires();
  showSelection();
  if (frame) return setPreset(preset_);
  update3d();
}

void RoomView::showLuminaires() {
  setData(*luminaires_, openingsOf(*scene_));
  setData(*rims_, rimsOf(*scene_));
  setData(*aims_, aimsOf(*scene_));
}

void RoomView::showSelection() {
  chosen_->SetPosition(0, 0, 0);
  if (!scene_ || selection_.empty()) {
    setData(*chosen_, nullptr);
  } else if (selection_.starts_with("/luminaires/")) {
    setData(*chosen_, rimsOf(*scene_, selection_));
  } else {
    setData(*chosen_, boxAround(*scene_, selection_));
  }
}

void RoomView::showOverlay(std::shared_ptr<const GridOverlay> overlay) {
  setData(*colours_, overlay ? overlay->colours.Get() : nullptr);
  setData(*isolines_, overlay ? overlay->isolines.Get() : nullptr);
  update3d();
}

void RoomView::select(const std::string& pointer) {
  if (pointer == selection_) return;
  selection_ = pointer;
  showSelection();
  update3d();
}

void RoomView::setPreset(OrbitCamera::Preset preset) {
  preset_ = preset;
  if (scene_) camera_.frame(scene_->low, scene_->high, preset, static_cast<double>(width()) / std::max(height(), 1));
  update3d();
}

void RoomView::lookThrough(const scene::View& view) {
  camera_.lookFrom(view.eye, view.target, view.verticalFov);
  update3d();
}

void RoomView::setMeasuring(bool measuring) {
  isMeasuring_ = measuring;
  measuredFrom_.reset();
  setCursor(measuring ? Qt::CrossCursor : Qt::ArrowCursor);
  if (!measuring) setData(*ruler_, nullptr);
  update3d();
}

void RoomView::setAimsVisible(bool visible) {
  aims_->SetVisibility(visible ? 1 : 0);
  update3d();
}

void RoomView::setEdgesVisible(bool visible) {
  edges_->SetVisibility(visible ? 1 : 0);
  update3d();
}

void RoomView::setOverlayVisible(bool visible) {
  colours_->SetVisibility(visible ? 1 : 0);
  isolines_->SetVisibility(visible ? 1 : 0);
  update3d();
}

void RoomView::setCut(std::optional<double> height) {
  for (vtkActor* actor : {room_.Get(), objects_.Get(), edges_.Get(), luminaires_.Get(), rims_.Get(), aims_.Get()}) {
    actor->GetMapper()->RemoveAllClippingPlanes();
    if (height) actor->GetMapper()->AddClippingPlane(cut_);
  }
  if (height) {
    cut_->SetOrigin(0, 0, *height);
    cut_->SetNormal(0, 0, -1);
  }
  update3d();
}

void RoomView::update3d() {
  // One picture for all that changes in one turn of the event loop.
  if (isVisible() && !draw_.isActive()) draw_.start();
}

void RoomView::drawNow() {
  if (!isVisible() || width() < 2) return;
  camera_.applyTo(*renderer_->GetActiveCamera());
  renderer_->ResetCameraClippingRange();
  window_->Render();
}

Ray RoomView::rayThrough(const QPoint& at) const {
  const double x = (2 * (at.x() + 0.5) / std::max(width(), 1) - 1) * width() / std::max(height(), 1);
  const double y = 1 - 2 * (at.y() + 0.5) / std::max(height(), 1);
  const double half = camera_.span() / 2;
  const Vec3 at1 = camera_.target() + half * (x * camera_.right() + y * camera_.up());
  if (camera_.isParallel()) {
    const Vec3 forward = camera_.forward();
    return {at1 - 1e3 * forward, forward};
  }
  return {camera_.eye(), glm::normalize(at1 - camera_.eye())};
}

QPoint RoomView::toWidget(const Vec3& point) const {
  const Vec3 from = camera_.isParallel() ? camera_.target() : camera_.eye();
  const Vec3 d = point - from;
  double scale = 2 / camera_.span();
  if (!camera_.isParallel())
    scale *= glm::length(camera_.target() - camera_.eye()) / std::max(glm::dot(d, camera_.forward()), 1e-9);
  const double half = 0.5 * height();
  return {static_cast<int>(std::lround(0.5 * width() + half * scale * glm::dot(d, camera_.right()))),
          static_cast<int>(std::lround(half - half * scale * glm::dot(d, camera_.up())))};
}

}  // namespace goniolux::gui
