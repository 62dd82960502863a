#include "plot/vtk/ink.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

namespace goniolux::plot {
namespace {

constexpr int dpi = 72;

/// VTK's own font lacks letters (no Greek); DejaVu has them. "" where DejaVu is not installed.
const std::string& fontFile(bool bold) {
  static const std::array<std::string, 2> files = [] {
    std::array<std::string, 2> found;
    for (const char* folder : {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts",
                               "/usr/share/fonts/TTF", "/usr/share/fonts/dejavu", "/usr/local/share/fonts"}) {
      const std::filesystem::path base = folder;
      std::error_code ignored;
      if (found[0].empty() && std::filesystem::exists(base / "DejaVuSans.ttf", ignored)) {
        found[0] = base / "DejaVuSans.ttf";
        const bool hasBold = std::filesystem::exists(base / "DejaVuSans-Bold.ttf", ignored);
        found[1] = hasBold ? base / "DejaVuSans-Bold.ttf" : base / "DejaVuSans.ttf";
      }
    }
    return found;
  }();
  return files[bold ? 1 : 0];
}

void apply(const TextStyle& style, vtkTextProperty* property) {
  if (fontFile(style.bold).empty()) {
    property->SetFontFamilyToArial();
    property->SetBold(style.bold ? 1 : 0);
  } else {
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(fontFile(style.bold).c_str());
    property->SetBold(0);
  }
  property->SetItalic(0);
  property->SetShadow(0);
  property->SetFontSize(style.size);
  property->SetColor(style.colour[0] / 255.0, style.colour[1] / 255.0, style.colour[2] / 255.0);
  property->SetOpacity(1);
  property->SetOrientation(style.angle / core::degree);
  property->SetJustificationToLeft();
  property->SetVerticalJustificationToBottom();
}

/// Box of the drawn letters about the left end of their base line: x from, x to, y from, y to.
std::array<int, 4> bounds(const std::string& words, const TextStyle& style) {
  vtkNew<vtkTextProperty> property;
  TextStyle level = style;
  level.angle = 0;
  apply(level, property);
  std::array<int, 4> box{0, 0, 0, 0};
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, vtkStdString(words), box.data(), dpi);
  return box;
}

struct Letters {
  vtkSmartPointer<vtkImageData> image;  ///< RGBA, one empty pixel around; null if nothing is to be seen
  core::Vec2 offset{0};                 ///< of its lower left corner from the text's anchor
};

Letters lettersOf(const std::string& words, vtkTextProperty* property) {
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  renderer->SetScaleToPowerOfTwo(false);
  std::array<int, 4> box{0, 0, 0, 0};
  std::array<int, 2> size{0, 0};
  vtkNew<vtkImageData> tight;
  if (!renderer->GetBoundingBox(property, vtkStdString(words), box.data(), dpi)) return {};
  if (!renderer->RenderString(property, vtkStdString(words), tight, size.data(), dpi)) return {};
  const int width = tight->GetDimensions()[0], height = tight->GetDimensions()[1];
  if (tight->GetScalarType() != VTK_UNSIGNED_CHAR || tight->GetNumberOfScalarComponents() != 4) return {};
  Letters letters{vtkSmartPointer<vtkImageData>::New(), core::Vec2(box[0] - 1, box[2] - 1)};
  letters.image->SetDimensions(width + 2, height + 2, 1);
  letters.image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const auto* from = static_cast<const unsigned char*>(tight->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(letters.image->GetScalarPointer());
  std::fill_n(to, std::ptrdiff_t{4} * (width + 2) * (height + 2), static_cast<unsigned char>(0));
  for (int row = 0; row < height; ++row) {
    std::copy_n(from + std::ptrdiff_t{4} * width * row, std::ptrdiff_t{4} * width,
                to + std::ptrdiff_t{4} * ((width + 2) * (row + 1) + 1));
  }
  return letters;
}

std::vector<float> flatten(const Polyline& points) {
  std::vector<float> flat;
  flat.reserve(2 * points.size());
  for (const core::Vec2& p : points) {
    flat.push_back(static_cast<float>(p.x));
    flat.push_back(static_cast<float>(p.y));
  }
  return flat;
}

}  // namespace

core::Vec2 textSize(const std::string& words, const TextStyle& style) {
  const std::array<int, 4> line = bounds(words, style), capital = bounds("0", style);
  return {line[1] - line[0] + 1.0, capital[3] - capital[2] + 1.0};
}

TextStyle fitting(const std::string& words, TextStyle style, double width) {
  while (style.size > 10 && textSize(words, style).x > width) --style.size;
  return style;
}

void ContextInk::line(const Polyline& points, const Rgb& colour, double width, int opacity) {
  if (points.size() < 2) return;
  vtkPen* pen = context_.GetPen();
  pen->SetColor(colour[0], colour[1], colour[2], static_cast<unsigned char>(opacity));
  pen->SetWidth(static_cast<float>(width));
  pen->SetLineType(vtkPen::SOLID_LINE);
  std::vector<float> flat = flatten(points);
  context_.DrawPoly(flat.data(), static_cast<int>(points.size()));
}

void ContextInk::area(const Polyline& corners, const Rgb& colour, int opacity) {
  if (corners.size() < 3) return;
  context_.GetPen()->SetLineType(vtkPen::NO_PEN);
  context_.GetBrush()->SetColor(colour[0], colour[1], colour[2], static_cast<unsigned char>(opacity));
  std::vector<float> flat = flatten(corners);
  context_.DrawPolygon(flat.data(), static_cast<int>(corners.size()));
}

void ContextInk::text(const std::string& words, const core::Vec2& at, const TextStyle& style) {
  if (words.empty()) return;
  const std::array<int, 4> box = bounds(words, style), capital = bounds("0", style);
  // Left end of the box that VTK places, in the frame of the turned text.
  const double width = box[1] - box[0] + 1.0;
  const double back = style.align == TextStyle::Align::left     ? 0
                      : style.align == TextStyle::Align::center ? width / 2
                                                                : width;
  const double down = (capital[2] + capital[3]) / 2.0 - box[2];
  const core::Vec2 along(std::cos(style.angle), std::sin(style.angle)), up(-along.y, along.x);
  const core::Vec2 start = at - along * back - up * down;
  // Drawn as a picture with an empty rim on whole pixels: DrawString shows the upper edge of some words again below
  // them.
  vtkNew<vtkTextProperty> property;
  apply(style, property);
  const Letters letters = lettersOf(words, property);
  if (letters.image == nullptr) return;
  const core::Vec2 low = glm::round(start + letters.offset);
  const int* pixels = letters.image->GetDimensions();
  image(low, low + core::Vec2(pixels[0], pixels[1]), letters.image);
}

void ContextInk::image(const core::Vec2& low, const core::Vec2& high, vtkImageData* image) {
  context_.DrawImage(vtkRectf(static_cast<float>(low.x), static_cast<float>(low.y), static_cast<float>(high.x - low.x),
                              static_cast<float>(high.y - low.y)),
                     image);
}

}  // namespace goniolux::plot
