#include "plot/spectrum_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/markup.h"
#include "spectrum/cie_data.h"

namespace goniolux::plot {
namespace {

constexpr double width = 900, height = 480;
constexpr double left = 64, right = 24, top = 78, bottom = 58;
constexpr double from = 360, to = 830;

double xOf(double wavelength) {
  return left + (wavelength - from) / (to - from) * (width - left - right);
}
double yOf(double value) {
  return height - bottom - value * (height - top - bottom);
}

// A wavelength's colour, drawn to the sRGB gamut by adding white, dimmed at the ends of the spectrum.
std::string colourOf(double wavelength) {
  const auto& observer = spectrum::cie1931();
  const double X = observer.xbar.continuum(wavelength), Y = observer.ybar.continuum(wavelength),
               Z = observer.zbar.continuum(wavelength);
  double rgb[] = {3.2406 * X - 1.5372 * Y - 0.4986 * Z, -0.9689 * X + 1.8758 * Y + 0.0415 * Z,
                  0.0557 * X - 0.2040 * Y + 1.0570 * Z};
  const double least = std::min({rgb[0], rgb[1], rgb[2], 0.0});
  for (double& c : rgb) c -= least;
  const double most = std::max({rgb[0], rgb[1], rgb[2], 0.05});
  int code[3];
  for (int i = 0; i < 3; ++i) {
    const double c = rgb[i] / most;
    code[i] = static_cast<int>(std::lround(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", code[0], code[1], code[2]);
}

// Power at every half nanometre and at the samples, divided by the highest.
std::vector<std::pair<double, double>> curveOf(const spectrum::SpectralDistribution& distribution) {
  std::vector<double> wavelengths;
  for (double w = from; w <= to; w += 0.5) wavelengths.push_back(w);
  for (const auto& sample : distribution.samples())
    if (sample.wavelength > from && sample.wavelength < to) wavelengths.push_back(sample.wavelength);
  std::sort(wavelengths.begin(), wavelengths.end());
  wavelengths.erase(std::unique(wavelengths.begin(), wavelengths.end()), wavelengths.end());
  std::vector<std::pair<double, double>> curve;
  double highest = 0;
  for (const double w : wavelengths) {
    curve.emplace_back(w, std::max(0.0, distribution.continuum(w)));
    highest = std::max(highest, curve.back().second);
  }
  for (auto& point : curve) point.second = highest > 0 ? point.second / highest : 0;
  return curve;
}

std::string pathOf(const std::vector<std::pair<double, double>>& curve) {
  std::string path;
  for (const auto& [w, value] : curve)
    path += fmt::format("{}{:.2f},{:.2f}", path.empty() ? "M" : "L", xOf(w), yOf(value));
  return path;
}

void drawAxes(std::string& svg) {
  auto out = std::back_inserter(svg);
  for (int percent = 0; percent <= 100; percent += 20) {
    const double y = yOf(percent / 100.0);
    fmt::format_to(out, "<line x1='{:.1f}' y1='{:.2f}' x2='{:.1f}' y2='{:.2f}' stroke='#dddddd'/>\n", left, y,
                   width - right, y);
    fmt::format_to(out, "<text x='{:.1f}' y='{:.2f}' text-anchor='end'>{:.1f}</text>\n", left - 8, y + 4,
                   percent / 100.0);
  }
  for (int nm = 400; nm <= 800; nm += 50) {
    fmt::format_to(out, "<line x1='{0:.2f}' y1='{1:.1f}' x2='{0:.2f}' y2='{2:.1f}' stroke='#555555'/>\n", xOf(nm),
                   yOf(0), yOf(0) + 5);
    fmt::format_to(out, "<text x='{:.2f}' y='{:.1f}' text-anchor='middle'>{}</text>\n", xOf(nm), yOf(0) + 20, nm);
  }
  fmt::format_to(out, "<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>wavelength / nm</text>\n",
                 (left + width - right) / 2, height - 14);
  fmt::format_to(
      out, "<text transform='translate(18 {:.1f}) rotate(-90)' text-anchor='middle'>relative spectral power</text>\n",
      (top + height - bottom) / 2);
}

void drawComparison(std::string& svg) {
  const struct {
    const spectrum::SpectralDistribution& curve;
    const char* dashes;
    const char* name;
    double at;
  } curves[] = {{spectrum::cie1931().ybar, "6 4", "V(λ)", 575}, {spectrum::melanopicAction(), "2 3", "melanopic", 470}};
  auto out = std::back_inserter(svg);
  for (const auto& [curve, dashes, name, at] : curves) {
    fmt::format_to(out, "<path d='{}' fill='none' stroke='#777777' stroke-width='1.2' stroke-dasharray='{}'/>\n",
                   pathOf(curveOf(curve)), dashes);
    fmt::format_to(out,
                   "<text x='{:.2f}' y='{:.2f}' fill='#555555' text-anchor='{}' stroke='white' stroke-width='3' "
                   "paint-order='stroke'>{}</text>\n",
                   xOf(at) + (at > 500 ? 8 : -8), yOf(curve.continuum(at)) - 4, at > 500 ? "start" : "end", name);
  }
}

}  // namespace

std::string spectrumSvg(const SpectrumPlot& plot) {
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{0:.0f}' height='{1:.0f}' viewBox='0 0 {0:.0f} {1:.0f}' "
      "font-family='DejaVu Sans, Helvetica, Arial, sans-serif' font-size='12' fill='#222222'>\n"
      "<rect width='100%' height='100%' fill='white'/>\n<defs><linearGradient id='spectrum' x1='{2:.1f}' x2='{3:.1f}' "
      "y1='0' "
      "y2='0' gradientUnits='userSpaceOnUse'>\n",
      width, height, left, width - right);
  auto out = std::back_inserter(svg);
  for (double w = from; w <= to; w += 5)
    fmt::format_to(out, "<stop offset='{:.4f}' stop-color='{}'/>\n", (w - from) / (to - from), colourOf(w));
  svg += "</linearGradient></defs>\n";
  fmt::format_to(out, "<text x='{:.1f}' y='32' font-size='18' font-weight='bold'>{}</text>\n", left,
                 core::escapedMarkup(plot.title));
  std::string facts;
  for (const std::string& fact : plot.facts) facts += (facts.empty() ? "" : "   ·   ") + core::escapedMarkup(fact);
  fmt::format_to(out, "<text x='{:.1f}' y='54'>{}</text>\n", left, facts);
  drawAxes(svg);
  const auto curve = curveOf(plot.source);
  const std::string path = pathOf(curve);
  const bool dark = std::all_of(curve.begin(), curve.end(), [](const auto& point) { return point.second == 0; });
  if (!dark) {
    fmt::format_to(out, "<path d='{}L{:.2f},{:.2f}L{:.2f},{:.2f}Z' fill='url(#spectrum)' fill-opacity='0.85'/>\n", path,
                   xOf(to), yOf(0), xOf(from), yOf(0));
    fmt::format_to(out, "<path d='{}' fill='none' stroke='#222222' stroke-width='1.4' stroke-linejoin='round'/>\n",
                   path);
  }
  double strongest = 0;
  for (const auto& line : plot.source.lines()) strongest = std::max(strongest, line.power);
  for (const auto& line : plot.source.lines()) {
    if (line.wavelength < from || line.wavelength > to || !(strongest > 0)) continue;
    fmt::format_to(out, "<line x1='{0:.2f}' y1='{1:.2f}' x2='{0:.2f}' y2='{2:.2f}' stroke='{3}' stroke-width='2.5'/>\n",
                   xOf(line.wavelength), yOf(0), yOf(line.power / strongest), colourOf(line.wavelength));
  }
  drawComparison(svg);
  fmt::format_to(out, "<line x1='{:.1f}' y1='{:.2f}' x2='{:.1f}' y2='{:.2f}' stroke='#222222'/>\n</svg>\n", left,
                 yOf(0), width - right, yOf(0));
  return svg;
}

}  // namespace goniolux::plot
