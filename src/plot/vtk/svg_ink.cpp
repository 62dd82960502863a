#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "core/markup.h"
#include "plot/base64.h"
#include "plot/vtk/ink.h"

namespace goniolux::plot {
namespace {

std::string hex(const Rgb& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

std::string opacityAttribute(const char* name, int opacity) {
  return opacity >= 255 ? std::string() : fmt::format(" {}=\"{:.3g}\"", name, opacity / 255.0);
}

}  // namespace

std::string pngOf(vtkImageData* image) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr) return {};
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

SvgInk::SvgInk(int width, int height, const std::string& title, const std::string& description) : height_(height) {
  svg_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" "
      "width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans, Verdana, sans-serif\" "
      "xml:space=\"preserve\">\n<title>{2}</title>\n"
      "<desc>{3}</desc>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      width, height, core::escapedMarkup(title), core::escapedMarkup(description));
}

std::string SvgInk::pointList(const Polyline& points) const {
  std::string list;
  for (const core::Vec2& p : points) list += fmt::format("{:.2f},{:.2f} ", p.x, height_ - p.y);
  if (!list.empty()) list.pop_back();
  return list;
}

void SvgInk::line(const Polyline& points, const Rgb& colour, double width, int opacity) {
  if (points.size() < 2) return;
  svg_ += fmt::format("<polyline fill=\"none\" stroke=\"{}\"{} stroke-width=\"{:g}\" points=\"{}\"/>\n", hex(colour),
                      opacityAttribute("stroke-opacity", opacity), width, pointList(points));
}

void SvgInk::area(const Polyline& corners, const Rgb& colour, int opacity) {
  if (corners.size() < 3) return;
  svg_ += fmt::format("<polygon fill=\"{}\"{} points=\"{}\"/>\n", hex(colour),
                      opacityAttribute("fill-opacity", opacity), pointList(corners));
}

void SvgInk::text(const std::string& words, const core::Vec2& at, const TextStyle& style) {
  if (words.empty()) return;
  // The base line is half a figure's height below `at`, across the direction of the words. DejaVu Sans: figures are
  // 0.729 em high.
  constexpr double figureHeight = 0.729;
  const core::Vec2 base =
      at + core::Vec2(std::sin(style.angle), -std::cos(style.angle)) * (figureHeight * style.size / 2);
  const char* anchor = style.align == TextStyle::Align::left     ? "start"
                       : style.align == TextStyle::Align::center ? "middle"
                                                                 : "end";
  std::string turn;
  if (style.angle != 0) {
    turn = fmt::format(" transform=\"rotate({:.2f} {:.2f} {:.2f})\"", -style.angle / core::degree, base.x,
                       height_ - base.y);
  }
  svg_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\"{} text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n",
                      base.x, height_ - base.y, style.size, style.bold ? " font-weight=\"bold\"" : "", anchor,
                      hex(style.colour), turn, core::escapedMarkup(words));
}

void SvgInk::image(const core::Vec2& low, const core::Vec2& high, vtkImageData* image) {
  svg_ += fmt::format(
      "<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" preserveAspectRatio=\"none\" "
      "xlink:href=\"data:image/png;base64,{}\"/>\n",
      low.x, height_ - high.y, high.x - low.x, high.y - low.y, base64(pngOf(image)));
}

}  // namespace goniolux::plot
