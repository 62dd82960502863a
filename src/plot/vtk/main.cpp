// goniolux-plot: draws a figure that `goniolux plot` has written. A program of its own: it alone loads VTK, and
// whatever becomes of it, the calculation and its data stay.
//
//   goniolux-plot FIGURE.json OUT.png|OUT.svg ...     draws
//   goniolux-plot --read-back FILE.vtp OUT.json       reads a .vtp or .vtu with VTK and writes what it found
//
// Exit: 0 drawn; 2 bad figure or usage; 3 drawing is not possible here (no OpenGL) or a file cannot be written.
#include <vtkObject.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "core/document.h"
#include "plot/vtk/offscreen_window.h"
#include "plot/vtk/picture.h"
#include "plot/vtk/read_back.h"

namespace {

using namespace goniolux;

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() < 2) {
    std::fputs("usage: goniolux-plot FIGURE.json OUT.png|OUT.svg ...\n", stderr);
    return 2;
  }
  if (arguments[0] == "--read-back" && arguments.size() == 3) {
    core::writeFile(arguments[2], core::toJson(plot::readBackVtp(arguments[1])));
    return 0;
  }
  const std::vector<std::string> files(arguments.begin() + 1, arguments.end());
  for (const std::string& file : files) {
    if (!file.ends_with(".png") && !file.ends_with(".svg")) {
      throw core::InputError({}, "picture-format", file + ": pictures are written as .png or .svg; name the file so");
    }
  }
  core::Diagnostics diagnostics;
  const core::Value document = core::parseJson(core::readFile(arguments[0]), arguments[0], diagnostics);
  if (diagnostics.hasErrors()) throw core::InputError(diagnostics);
  plot::drawFigure(document, files);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  vtkObject::GlobalWarningDisplayOff();  // what matters comes as an exception
  try {
    return run({arguments + 1, arguments + count});
  } catch (const core::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
