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
      cutPlane_(vtkSmartPointer<vtkPlane>::New()) {
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
  detail_.setSingleShot(true);
  connect(&detail_, &QTimer::timeout, this, &RoomView::drawDetail);
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

std::vector<vtkActor*> RoomView::plainActors() const {
  return {room_, luminaires_, rims_, aims_, solids_, chosen_, colours_, isolines_, ruler_};
}

void RoomView::buildActors() {
  for (auto* actor : {&room_, &luminaires_, &rims_, &aims_, &solids_, &chosen_, &colours_, &isolines_, &ruler_}) {
    *actor = emptyActor();
    renderer_->AddActor(*actor);
  }
  makeSurface(*room_, true);
  colours_->GetProperty()->SetLighting(false);
  colours_->GetMapper()->SetScalarModeToUseCellData();
  for (vtkActor* lines : {rims_.Get(), chosen_.Get()}) makeForward(*lines);
}

void RoomView::addDetail(vtkPolyData* surface, bool isEdges, bool isClosed) {
  Detail detail{emptyActor(), isEdges, isClosed};
  setData(*detail.actor, surface);
  if (isEdges) {
    makePlain(*detail.actor, theme().edge, 1);
    makeForward(*detail.actor);
  } else {
    makeSurface(*detail.actor, isClosed);
  }
  renderer_->AddActor(detail.actor);
  details_.push_back(detail);
}

void RoomView::buildDetails() {
  for (const Detail& detail : details_) renderer_->RemoveActor(detail.actor);
  details_.clear();
  if (!scene_) return;
  // The first pieces of bodies and sheets, with the edges of the largest objects; then the other surfaces, then edges.
  const auto& pieces = scene_->objects;
  const std::size_t first =
      pieces.size() > 1 && pieces[0].isClosed != pieces[1].isClosed ? 2 : std::min<std::size_t>(pieces.size(), 1);
  for (std::size_t i = 0; i < first; ++i) addDetail(scene_->objects[i].data, false, scene_->objects[i].isClosed);
  if (!scene_->edges.empty()) addDetail(scene_->edges.front(), true, false);
  leastDetails_ = detailsAtOnce_ = nextDetail_ = details_.size();
  for (std::size_t i = first; i < scene_->objects.size(); ++i)
    addDetail(scene_->objects[i].data, false, scene_->objects[i].isClosed);
  for (std::size_t i = 1; i < scene_->edges.size(); ++i) addDetail(scene_->edges[i], true, false);
  // What is drawn in pieces is neither smoothed as a whole nor seen through.
  renderer_->SetUseFXAA(!isLarge());
  colours_->GetProperty()->SetOpacity(isLarge() ? 1 : 0.92);
  applyCut();
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
  for (const Detail& detail : details_)
    if (detail.isEdges) makePlain(*detail.actor, t.edge, 1);
  makePlain(*luminaires_, t.luminaire);
  makePlain(*rims_, t.aim.darker(130), 1.5F);
  makePlain(*aims_, t.aim, 1.5F);
  makePlain(*solids_, t.selection, 1);
  makePlain(*chosen_, t.selection, 3);
  makePlain(*isolines_, QColor("#202020"), 1.2F);
  makePlain(*ruler_, t.selection, 2);
  update3d();
}

void RoomView::showScene(std::shared_ptr<const RoomScene> scene, bool frame) {
  scene_ = std::move(scene);
  buildDetails();
  if (!scene_) {
    for (vtkActor* actor : plainActors()) setData(*actor, nullptr);
    return update3d();
  }
  setData(*room_, scene_->room);
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
  chosen_->SetOrientation(0, 0, 0);
  setData(*chosen_, scene_ ? marksOf(*scene_, selection_).Get() : nullptr);
  setData(*solids_, scene_ && showsSolids_ ? solidsOf(*scene_, selection_).Get() : nullptr);
}

void RoomView::showOverlay(std::shared_ptr<const GridOverlay> overlay) {
  setData(*colours_, overlay ? overlay->colours.Get() : nullptr);
  setData(*isolines_, overlay ? overlay->isolines.Get() : nullptr);
  update3d();
}

void RoomView::select(const std::vector<std::string>& pointers) {
  if (pointers == selection_) return;
  selection_ = pointers;
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
  showsAims_ = visible;
  update3d();
}

void RoomView::setEdgesVisible(bool visible) {
  showsEdges_ = visible;
  update3d();
}

void RoomView::setOverlayVisible(bool visible) {
  showsOverlay_ = visible;
  update3d();
}

void RoomView::setSolidsVisible(bool visible) {
  showsSolids_ = visible;
  showSelection();
  update3d();
}

void RoomView::setCut(std::optional<Cut> cut) {
  cut_ = cut;
  applyCut();
  update3d();
}

void RoomView::applyCut() {
  if (cut_) {
    Vec3 origin(0), normal(0);
    origin[cut_->axis] = cut_->at;
    normal[cut_->axis] = cut_->takesGreater ? -1 : 1;
    cutPlane_->SetOrigin(origin.x, origin.y, origin.z);
    cutPlane_->SetNormal(normal.x, normal.y, normal.z);
  }
  std::vector<vtkActor*> actors{room_, luminaires_, rims_, aims_};
  for (const Detail& detail : details_) {
    actors.push_back(detail.actor);
    // A body that is cut open shows its inside.
    if (detail.isClosed) detail.actor->GetProperty()->SetBackfaceCulling(cut_ ? 0 : 1);
  }
  for (vtkActor* actor : actors) {
    actor->GetMapper()->RemoveAllClippingPlanes();
    if (cut_) actor->GetMapper()->AddClippingPlane(cutPlane_);
  }
}

Ray RoomView::rayThrough(const QPoint& at) const {
  const double x = (2 * (at.x() + 0.5) / std::max(width(), 1) - 1) * width() / std::max(height(), 1);
  const double y = 1 - 2 * (at.y() + 0.5) / std::max(height(), 1);
  const double half = camera_.span() / 2;
  const Vec3 at1 = camera_.target() + half * (x * camera_.right() + y * camera_.up());
  if (camera_.isParallel()) {
    const Vec3 forward = camera_.forward();
    return {at1 - parallelDistance * forward, forward};
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
