#include "plot/vtk/picture.h"

#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <functional>

#include "core/document.h"
#include "plot/vtk/line_chart_painter.h"
#include "plot/vtk/offscreen_window.h"
#include "plot/vtk/plan_map_painter.h"
#include "plot/vtk/polar_painter.h"
#include "plot/vtk/solid_painter.h"

namespace goniolux::plot {
namespace {

/// What is drawn, and how large (pixels).
struct Page {
  int width = 0, height = 0;
  std::string title, description;
  std::function<void(Ink&)> paint;
};

/// Lets the page be painted when VTK draws its scene.
class PainterItem final : public vtkContextItem {
 public:
  vtkTypeMacro(PainterItem, vtkContextItem);
  static PainterItem* New();
  const Page* page = nullptr;
  bool Paint(vtkContext2D* context) override {
    ContextInk ink(*context);
    page->paint(ink);
    return true;
  }
};
vtkStandardNewMacro(PainterItem);

std::string drawPng(const Page& page) {
  OffscreenWindow offscreen(page.width, page.height);
  vtkNew<PainterItem> item;
  item->page = &page;
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

std::string drawSvg(const Page& page) {
  SvgInk ink(page.width, page.height, page.title, page.description);
  page.paint(ink);
  return ink.document();
}

void drawPage(const Page& page, const std::vector<std::string>& files) {
  // SVG first: it needs no OpenGL, so that at least it is there when that fails.
  for (const std::string& file : files) {
    if (file.ends_with(".svg")) core::writeFile(file, drawSvg(page));
  }
  std::string png;
  for (const std::string& file : files) {
    if (file.ends_with(".svg")) continue;
    if (png.empty()) png = drawPng(page);
    core::writeFile(file, png);
  }
}

}  // namespace

namespace {

template <typename Painter, typename Figure>
void drawWith(const Figure& figure, const std::vector<std::string>& files) {
  const Painter painter(figure);
  drawPage({painter.width(), painter.height(), figure.title, figure.subtitle, [&](Ink& ink) { painter.paint(ink); }},
           files);
}

}  // namespace

void drawFigure(const core::Value& document, const std::vector<std::string>& files) {
  const std::string kind = figureKind(document);
  if (kind == "polar-diagram") return drawWith<PolarPainter>(polarDiagramFromJson(document), files);
  if (kind == "line-chart") return drawWith<LineChartPainter>(lineChartFromJson(document), files);
  if (kind == "photometric-solid") return drawWith<SolidPainter>(photometricSolidFromJson(document), files);
  const PlanMap map = planMapFromJson(document);
  const MapLayout layout = layoutOf(map);
  const PlanMapPainter painter(map, layout);
  drawPage({layout.width, layout.height, map.title, map.subtitle, [&](Ink& ink) { painter.paint(ink); }}, files);
}

}  // namespace goniolux::plot
