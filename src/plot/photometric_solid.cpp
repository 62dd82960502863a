#include "plot/photometric_solid.h"

#include <algorithm>

#include "plot/figure_members.h"

namespace goniolux::plot {

using core::Value;

Value toJson(const PhotometricSolid& solid) {
  Value json = figureHead("photometric-solid", solid.title, solid.subtitle, solid.facts, solid.footer);
  json.set("unit", solid.unit);
  json.set("planes", Value::arrayOf(solid.planes));
  json.set("gammas", Value::arrayOf(solid.gammas));
  json.set("values", Value::arrayOf(solid.values));
  return json;
}

PhotometricSolid photometricSolidFromJson(const Value& document) {
  PhotometricSolid solid;
  solid.title = figureText(document, "title");
  solid.subtitle = figureText(document, "subtitle");
  solid.footer = figureText(document, "footer");
  solid.facts = figureTexts(document, "facts");
  solid.unit = figureText(document, "unit");
  solid.planes = figureNumbers(document, "planes");
  solid.gammas = figureNumbers(document, "gammas");
  solid.values = figureNumbers(document, "values");
  const auto ascends = [](const std::vector<double>& list, double last) {
    return list.size() >= 2 && list.front() >= 0 && list.back() <= last &&
           std::adjacent_find(list.begin(), list.end(), [](double a, double b) { return b <= a; }) == list.end();
  };
  if (!ascends(solid.planes, 360)) badFigure(document, "\"planes\" must ascend from 0 to 360 degrees");
  if (!ascends(solid.gammas, 180)) badFigure(document, "\"gammas\" must ascend from 0 to 180 degrees");
  if (solid.values.size() != solid.planes.size() * solid.gammas.size() ||
      *std::min_element(solid.values.begin(), solid.values.end()) < 0)
    badFigure(document, "\"values\" must hold one number from 0 up per direction");
  return solid;
}

}  // namespace goniolux::plot
