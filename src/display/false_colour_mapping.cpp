// False colour: luminance as a colour, with a scale in cd/m2 beside the picture.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/diagnostics.h"
#include "core/parallel.h"
#include "display/mapping_types.h"
#include "display/palette.h"
#include "display/pixel_text.h"

namespace goniolux::display {
namespace {

struct Scale {
  double from = 0, to = 1;
  bool logarithmic = false;
  int steps = 0;  // bands of one colour; 0: gradual
  [[nodiscard]] double place(double luminance) const {
    double at = logarithmic ? std::log(std::max(luminance, 1e-30) / from) / std::log(to / from)
                            : (luminance - from) / (to - from);
    at = std::clamp(at, 0.0, 1.0);
    return steps > 0 ? (std::min(std::floor(at * steps), steps - 1.0) + 0.5) / steps : at;
  }
  [[nodiscard]] double luminance(double place) const {
    return logarithmic ? from * std::pow(to / from, place) : from + place * (to - from);
  }
};

// 1, 2 or 5 times a power of ten, at or above.
double roundUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power * 1.0001) return step * power;
  return 10 * power;
}

// Values that get a line and a number on the scale.
std::vector<double> ticks(const Scale& scale) {
  std::vector<double> values;
  if (scale.logarithmic) {
    const bool wide = scale.to / scale.from > 2000;
    for (double power = std::pow(10.0, std::floor(std::log10(scale.from))); power <= scale.to * 1.001; power *= 10)
      for (const double step : {1.0, 2.0, 5.0})
        if ((step == 1 || !wide) && step * power >= scale.from * 0.999 && step * power <= scale.to * 1.001)
          values.push_back(step * power);
    return values;
  }
  const double step = roundUp((scale.to - scale.from) / 10);
  for (double value = std::ceil(scale.from / step - 1e-6) * step; value <= scale.to * 1.0001; value += step)
    values.push_back(std::abs(value) < 1e-9 * step ? 0 : value);
  return values;
}

class Painter {
 public:
  Painter(const image::XyzImage& source, int legendWidth) : width_(source.width + legendWidth) {
    picture_.width = width_;
    picture_.height = source.height;
    const auto count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(source.height);
    for (auto* plane : {&picture_.x, &picture_.y, &picture_.z}) plane->assign(count, 0);
  }
  void set(int x, int y, const core::Vec3& xyz) {
    if (x < 0 || y < 0 || x >= width_ || y >= picture_.height) return;
    const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    picture_.x[i] = static_cast<float>(xyz.x);
    picture_.y[i] = static_cast<float>(xyz.y);
    picture_.z[i] = static_cast<float>(xyz.z);
  }
  void text(const std::string& text, int x, int y, int size) {
    drawText(text, x, y, size, [&](int u, int v) { set(u, v, paletteWhite() * 0.8); });
  }
  image::XyzImage picture_;

 private:
  int width_;
};

std::string label(double value) {
  return fmt::format("{:.6g}", value);
}

// A bar of the colours with numbers at its right, and the unit above.
void drawLegend(Painter& painter, int left, const Scale& scale, const Palette& palette, const std::string& unit,
                int size) {
  const int height = painter.picture_.height, line = glyphHeight * size;
  const int top = 3 * line, bottom = height - 2 * line, bar = 3 * line;
  if (bottom - top < 4 * line) return;
  painter.text(unit, left + line, line, size);
  for (int y = top; y < bottom; ++y) {
    const double at = 1 - (y - top + 0.5) / (bottom - top);
    const core::Vec3 colour = palette.at(scale.place(scale.luminance(at)));
    for (int x = 0; x < bar; ++x) painter.set(left + line + x, y, colour);
  }
  int last = height;
  std::vector<double> values = ticks(scale);
  for (const double value : values) {
    Scale smooth = scale;
    smooth.steps = 0;
    const int y = top + static_cast<int>(std::lround((1 - smooth.place(value)) * (bottom - top - 1)));
    if (last - y < 3 * line / 2) continue;  // numbers must not touch
    last = y;
    for (int x = 0; x < line / 2; ++x) painter.set(left + line + bar + x, y, paletteWhite() * 0.8);
    painter.text(label(value), left + line + bar + line, y - line / 2, size);
  }
}

ToneMap make(const MappingTask& task, const core::Arguments& arguments) {
  Scale scale;
  scale.to = numberOf(arguments, "max");
  const std::string& kind = textOf(arguments, "scale");
  if (kind != "linear" && kind != "log")
    throw core::InputError({}, "mapping", fmt::format("'scale' of false-colour is linear or log, not '{}'", kind));
  scale.logarithmic = kind == "log";
  if (!(scale.to > 0)) scale.to = roundUp(std::max(1e-3, task.statistics.bright_cd_m2));
  scale.from = numberOf(arguments, "min");
  if (scale.logarithmic && !(scale.from > 0)) scale.from = scale.to / 1000;
  if (!(scale.from < scale.to)) throw core::InputError({}, "mapping", "'min' of false-colour must be below 'max'");
  scale.steps = static_cast<int>(numberOf(arguments, "steps"));
  const Palette palette = paletteNamed(textOf(arguments, "palette"));

  const image::XyzImage& image = task.image;
  const int size = std::max(1, image.height / 300);
  const bool legend = textOf(arguments, "legend") != "no";
  Painter painter(image, legend ? 15 * glyphHeight * size / 2 + glyphHeight * size * 2 : 0);
  constexpr std::size_t entries = 1024;
  std::vector<core::Vec3> colours;
  for (std::size_t i = 0; i < entries; ++i) colours.push_back(palette.at(static_cast<double>(i) / (entries - 1)));
  core::parallelFor(static_cast<std::size_t>(image.height), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (int x = 0; x < image.width; ++x) {
        const float luminance = image.y[y * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)];
        if (!std::isfinite(luminance)) continue;  // black
        const double at = scale.place(static_cast<double>(luminance));
        painter.set(x, static_cast<int>(y), colours[static_cast<std::size_t>(at * (entries - 1) + 0.5)]);
      }
  });
  if (legend) drawLegend(painter, image.width, scale, palette, textOf(arguments, "unit"), size);

  ToneMap map;
  map.curve = std::make_shared<ToneCurve>([](double luminance) { return luminance; });
  map.seen = std::move(painter.picture_);
  map.coloursAreFixed = true;
  map.method = fmt::format("false colour from {:.4g} to {:.4g} {}, {}", scale.from, scale.to, textOf(arguments, "unit"),
                           scale.logarithmic ? "logarithmic" : "linear");
  return map;
}

}  // namespace

MappingType falseColourMapping() {
  return {"false-colour",
          "luminance as a colour, with a scale in cd/m2",
          "",
          {mappingNumber("min", "0", 0, true, "lower end of the scale, cd/m2; of a log scale 0 means max / 1000"),
           mappingNumber("max", "0", 0, true, "upper end, cd/m2; 0: what 5 % of the pixels exceed, rounded up"),
           mappingText("scale", "linear", "linear or log"),
           mappingText("palette", "false-colour", "false-colour, viridis or grey"),
           mappingNumber("steps", "0", 0, true, "bands of one colour; 0: gradual"),
           mappingText("legend", "yes", "yes or no"),
           mappingText("unit", "cd/m2", "what the legend says, for images of something else than luminance")},
          make};
}

}  // namespace goniolux::display
