#include "plot/vtk/picture.h"

#include <fmt/format.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderer.h>
#include <vtkSVGExporter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <filesystem>

#include "core/diagnostics.h"
#include "core/document.h"
#include "plot/vtk/offscreen_window.h"
#include "plot/vtk/plan_map_item.h"

namespace goniolux::plot {
namespace {

void writePng(vtkRenderWindow* window, const std::string& file) {
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0) throw CannotDraw("VTK made no picture");
  core::writeFile(file, {reinterpret_cast<const char*>(bytes->GetPointer(0)),
                         static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

void writeSvg(vtkRenderWindow* window, const PlanMap& map, const std::string& file) {
  // VTK writes to a file of its own choice; it replaces the wanted one only when it is whole.
  const std::string beside = file + ".part";
  vtkNew<vtkSVGExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileName(beside.c_str());
  exporter->SetTitle(map.title.c_str());
  exporter->SetDescription(map.subtitle.c_str());
  exporter->TextAsPathOff();  // words stay words: searchable, editable
  exporter->DrawBackgroundOn();
  exporter->Write();
  std::error_code error;
  std::filesystem::rename(beside, file, error);
  if (error) throw core::RunError(fmt::format("{}: cannot be written: {}", file, error.message()));
}

}  // namespace

void drawPlanMap(const PlanMap& map, const std::vector<std::string>& files) {
  const MapLayout layout = layoutOf(map);
  OffscreenWindow offscreen(layout.width, layout.height);
  vtkNew<PlanMapItem> item;
  item->setMap(map, layout);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(actor);
  offscreen.window()->AddRenderer(renderer);
  offscreen.window()->Render();
  for (const std::string& file : files) {
    if (file.ends_with(".svg")) {
      writeSvg(offscreen.window(), map, file);
    } else {
      writePng(offscreen.window(), file);
    }
  }
}

}  // namespace goniolux::plot
