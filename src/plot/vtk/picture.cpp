#include "plot/vtk/picture.h"

#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

#include "core/document.h"
#include "plot/vtk/offscreen_window.h"
#include "plot/vtk/plan_map_painter.h"

namespace goniolux::plot {
namespace {

/// Lets the painter draw when VTK draws its scene.
class PainterItem final : public vtkContextItem {
 public:
  vtkTypeMacro(PainterItem, vtkContextItem);
  static PainterItem* New();
  const PlanMapPainter* painter = nullptr;
  bool Paint(vtkContext2D* context) override {
    ContextInk ink(*context);
    painter->paint(ink);
    return true;
  }
};
vtkStandardNewMacro(PainterItem);

std::string drawPng(const PlanMapPainter& painter, const MapLayout& layout) {
  OffscreenWindow offscreen(layout.width, layout.height);
  vtkNew<PainterItem> item;
  item->painter = &painter;
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(actor);
  offscreen.window()->AddRenderer(renderer);
  offscreen.window()->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(offscreen.window());
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  std::string bytes = pngOf(grab->GetOutput());
  if (bytes.empty()) throw CannotDraw("VTK made no picture");
  return bytes;
}

std::string drawSvg(const PlanMap& map, const PlanMapPainter& painter, const MapLayout& layout) {
  SvgInk ink(layout.width, layout.height, map.title, map.subtitle);
  painter.paint(ink);
  return ink.document();
}

}  // namespace

void drawPlanMap(const PlanMap& map, const std::vector<std::string>& files) {
  const MapLayout layout = layoutOf(map);
  const PlanMapPainter painter(map, layout);
  // SVG first: it needs no OpenGL, so that at least it is there when that fails.
  for (const std::string& file : files) {
    if (file.ends_with(".svg")) core::writeFile(file, drawSvg(map, painter, layout));
  }
  std::string png;
  for (const std::string& file : files) {
    if (file.ends_with(".svg")) continue;
    if (png.empty()) png = drawPng(painter, layout);
    core::writeFile(file, png);
  }
}

}  // namespace goniolux::plot
