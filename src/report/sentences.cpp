// Sentences of the calculation in the reader's language: patterns in which {} stands for a number or a name.
#include <array>
#include <vector>

#include "report/words.h"

namespace goniolux::report {
namespace {

struct Pattern {
  const char *english, *german;
};

// What planner, solvers and stages leave out, and the report's own remarks. A sentence that fits none stays as it is.
constexpr std::array patterns = {
    Pattern{"wavelengths between {} spectral samples: at most {} % of E",
            "Wellenlängen zwischen {} Stützstellen: höchstens {} % von E"},
    Pattern{
        "wavelengths between the {} kept of group \"{}\": at most {} % of E with its lamp's spectrum",
        "Wellenlängen zwischen den {} behaltenen der Gruppe „{}“: höchstens {} % von E mit dem Spektrum ihrer Lampe"},
    Pattern{
        "the difference between splines or parametric surfaces and their facets: at most {} m of their place",
        "der Unterschied zwischen Splines oder parametrischen Flächen und ihren Facetten: höchstens {} m in der Lage"},
    Pattern{
        "end effects of tubes: the last centimetres before the electrodes are taken to be as bright as the rest: not "
        "modelled",
        "Enden von Leuchtstofflampen: die letzten Zentimeter vor den Elektroden gelten als so hell wie der Rest: nicht "
        "modelliert"},
    Pattern{"fluorescence, polarisation, and air (no absorption or scattering): not modelled",
            "Fluoreszenz, Polarisation und Luft (keine Absorption oder Streuung): nicht modelliert"},
    Pattern{"light of point and line luminaires that arrives by more than {} plane mirrors in a row",
            "Licht von Punkt- und Linienleuchten, das über mehr als {} ebene Spiegel nacheinander ankommt"},
    Pattern{"glare ratings: they do not add up over groups; calculate a scene by illuminate --scene",
            "Blendungsbewertungen: sie addieren sich nicht über Gruppen; eine Szene berechnet illuminate --scene"},
    Pattern{"the project has changed since these results were calculated: {}",
            "das Projekt hat sich geändert, seit diese Ergebnisse berechnet wurden: {}"},
};

/// What stands in place of each {}; false where the sentence is another one.
bool matches(const std::string& text, const std::string& pattern, std::vector<std::string>& found) {
  found.clear();
  std::size_t at = 0, from = 0;
  for (;;) {
    const std::size_t hole = pattern.find("{}", from);
    const std::string literal = pattern.substr(from, hole == std::string::npos ? hole : hole - from);
    if (from == 0) {
      if (!text.starts_with(literal)) return false;
      at = literal.size();
    } else {
      const std::size_t next = literal.empty() ? text.size() : text.find(literal, at);
      if (next == std::string::npos) return false;
      found.push_back(text.substr(at, next - at));
      at = next + literal.size();
    }
    if (hole == std::string::npos) return at == text.size();
    from = hole + 2;
  }
}

}  // namespace

std::string Words::sentence(const std::string& english) const {
  if (!german_) return english;
  std::vector<std::string> found;
  for (const Pattern& pattern : patterns) {
    if (!matches(english, pattern.english, found)) continue;
    std::string text = pattern.german;
    std::size_t at = 0;
    for (std::string part : found) {
      // A number, that is, one without letters, has the reader's decimal sign.
      const std::size_t point = part.find('.');
      if (point != std::string::npos && part.find_first_not_of("0123456789.+-e") == std::string::npos)
        part[point] = ',';
      at = text.find("{}", at);
      text.replace(at, 2, part);
      at += part.size();
    }
    return text;
  }
  return english;
}

}  // namespace goniolux::report
