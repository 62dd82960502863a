#include "display/adopted_white.h"

#include "core/text.h"

namespace goniolux::display {

std::optional<spectrum::Chromaticity> chromaticityFrom(std::string_view text) {
  core::TextScanner scanner(text);
  const auto first = scanner.word(","), second = scanner.word(",");
  if (!first || !second || !scanner.atEnd()) return std::nullopt;
  const auto x = core::parseNumber(first->text), y = core::parseNumber(second->text);
  if (!x || !y || !(*x > 0 && *y > 0 && *x + *y < 1)) return std::nullopt;
  return spectrum::Chromaticity{*x, *y};
}

std::optional<spectrum::Chromaticity> adoptedWhiteOf(const image::XyzImage& image) {
  const auto found = image.attributes.find(image::adoptedWhiteAttribute);
  return found != image.attributes.end() ? chromaticityFrom(found->second) : std::nullopt;
}

}  // namespace goniolux::display
