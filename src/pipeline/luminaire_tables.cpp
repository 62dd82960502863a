#include "pipeline/luminaire_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "analysis/ugr_table.h"
#include "analysis/utilisation.h"
#include "photometry/comparison.h"

namespace goniolux::pipeline {
namespace {

using analysis::UgrTable;
using analysis::UtilisationTable;
using core::Value;
using photometry::PhotometricFile;

// The reference of factors: the lamps' flux, or the luminaire's own where photometry is absolute.
double referenceFlux(const PhotometricFile& file) {
  return file.declaredLumens.value_or(file.distribution->flux());
}

analysis::GlareSource glareSourceOf(const PhotometricFile& file) {
  using Shape = photometry::StatedOpening::Shape;
  const photometry::StatedOpening& o = file.opening;
  analysis::GlareSource source;
  source.distribution = file.distribution.get();
  if (o.shape == Shape::point || o.shape == Shape::line || o.shape == Shape::other) return source;
  source.extent = {o.lengthAlongC90 ? o.width : o.length, o.lengthAlongC90 ? o.length : o.width, o.height};
  source.round =
      o.axis == photometry::StatedOpening::Axis::aim && (o.shape == Shape::disc || o.shape == Shape::cylinder);
  return source;
}

struct DiagramDistance {
  photometry::DistributionDifference one, two;
};
DiagramDistance diagramDistance(const PhotometricFile& file) {
  const photometry::TabulatedDistribution& d = *file.distribution;
  return {difference(d, *photometry::oneDiagram(d)), difference(d, *photometry::twoDiagrams(d))};
}

Value differenceDocument(const photometry::DistributionDifference& d, double flux) {
  Value value;
  value.set("misplaced_share", flux > 0 ? Value(d.misplaced / flux) : Value());
  value.set("rms_cd", d.rms);
  value.set("largest_cd", d.largest);
  return value;
}

Value tableDocument(const UtilisationTable& table, const char* roomKey) {
  Value value;
  value.set(roomKey, Value::arrayOf(table.rooms));
  Value::Array reflectances, rows;
  for (const auto& rho : table.reflectances)
    reflectances.push_back(Value::arrayOf(std::vector<double>{rho.ceiling, rho.walls, rho.floor}));
  for (const auto& row : table.factors) rows.push_back(Value::arrayOf(row));
  value.set("ceiling_walls_floor", reflectances);
  value.set("factors", rows);
  return value;
}

std::string reflectanceHead(const char* first, const std::vector<analysis::CavityReflectances>& list) {
  std::string text;
  for (const auto& [name, part] : {std::pair{"ceiling", &analysis::CavityReflectances::ceiling},
                                   {"walls", &analysis::CavityReflectances::walls},
                                   {"floor", &analysis::CavityReflectances::floor}}) {
    text += fmt::format("    {:<10}", name);
    for (const auto& rho : list) text += fmt::format("{:>6.0f}", 100 * rho.*part);
    text += " %\n";
  }
  return text + fmt::format("    {}\n", first);
}

std::string tableText(const char* title, const char* room, const UtilisationTable& table) {
  std::string text = fmt::format("  {}\n", title) + reflectanceHead(room, table.reflectances);
  for (std::size_t i = 0; i < table.rooms.size(); ++i) {
    text += fmt::format("    {:<10g}", table.rooms[i]);
    for (const double factor : table.factors[i]) text += fmt::format("{:>6.0f}", 100 * factor);
    text += '\n';
  }
  return text;
}

std::string ugrText(const PhotometricFile& file) {
  const auto table = analysis::ugrTable(glareSourceOf(file));
  if (!table) return "  UGR table         none: the file states no luminous area, or there is no light\n";
  std::string text = fmt::format(
      "  UGR (CIE 117, CIE 190), luminaires every 0.25 H, {:.0f} lm each; crosswise = the view lies in C0-C180\n",
      file.distribution->flux());
  const std::vector<analysis::CavityReflectances> list(UgrTable::reflectances.begin(), UgrTable::reflectances.end());
  std::vector<analysis::CavityReflectances> twice = list;
  twice.insert(twice.end(), list.begin(), list.end());
  text += reflectanceHead("X    Y      crosswise                     endwise", twice);
  for (std::size_t i = 0; i < UgrTable::rooms.size(); ++i) {
    text += fmt::format("    {:<5}{:<5}", fmt::format("{}H", UgrTable::rooms[i][0]),
                        fmt::format("{}H", UgrTable::rooms[i][1]));
    for (const double value : table->crosswise[i]) text += fmt::format("{:>6.1f}", value);
    for (const double value : table->endwise[i]) text += fmt::format("{:>6.1f}", value);
    text += '\n';
  }
  return text;
}

}  // namespace

void addTables(const PhotometricFile& file, Value& document) {
  const double flux = file.distribution->flux();
  const analysis::SpacingCriterion spacing = analysis::spacingCriterion(*file.distribution);
  document.set("spacing_criterion",
               Value(Value::Object{{"c0_180", spacing.c0}, {"c90_270", spacing.c90}, {"diagonal", spacing.diagonal}}));
  const DiagramDistance distance = diagramDistance(file);
  document.set("diagrams", Value(Value::Object{{"one", differenceDocument(distance.one, flux)},
                                               {"two", differenceDocument(distance.two, flux)}}));
  const double reference = referenceFlux(file);
  Value utilisation;
  utilisation.set("reference_lumens", reference);
  utilisation.set("room_index", tableDocument(analysis::roomIndexTable(*file.distribution, reference), "k"));
  utilisation.set("zonal_cavity", tableDocument(analysis::zonalCavityTable(*file.distribution, reference), "rcr"));
  document.set("utilisation", utilisation);
  const auto table = analysis::ugrTable(glareSourceOf(file));
  if (!table) {
    document.set("ugr", Value());
    return;
  }
  Value::Array rooms, crosswise, endwise, reflectances;
  for (std::size_t i = 0; i < UgrTable::rooms.size(); ++i) {
    rooms.push_back(Value::arrayOf(std::vector<double>(UgrTable::rooms[i].begin(), UgrTable::rooms[i].end())));
    crosswise.push_back(Value::arrayOf(std::vector<double>(table->crosswise[i].begin(), table->crosswise[i].end())));
    endwise.push_back(Value::arrayOf(std::vector<double>(table->endwise[i].begin(), table->endwise[i].end())));
  }
  for (const auto& rho : UgrTable::reflectances)
    reflectances.push_back(Value::arrayOf(std::vector<double>{rho.ceiling, rho.walls, rho.floor}));
  document.set("ugr", Value(Value::Object{{"spacing_h", 0.25},
                                          {"rooms_h", rooms},
                                          {"ceiling_walls_floor", reflectances},
                                          {"crosswise", crosswise},
                                          {"endwise", endwise}}));
}

std::string tablesText(const PhotometricFile& file) {
  const double flux = file.distribution->flux();
  if (!(flux > 0)) return "";
  const analysis::SpacingCriterion s = analysis::spacingCriterion(*file.distribution);
  std::string text = "  spacing criterion ";
  text += s.diagonal > 0
              ? fmt::format("{:.2f} in C0-C180, {:.2f} in C90-C270, {:.2f} diagonal (spacing / mounting height)\n",
                            s.c0, s.c90, s.diagonal)
              : "none: no light straight down\n";
  const DiagramDistance distance = diagramDistance(file);
  text += fmt::format(
      "  one diagram       {:.1f} % of the flux misplaced, {:.4g} {} off at most (the paper's model, turned about the "
      "aim)\n",
      100 * distance.one.misplaced / flux, distance.one.largest, file.intensityUnit);
  text += fmt::format(
      "  two diagrams      {:.1f} % of the flux misplaced, {:.4g} {} off at most (C0 and C90, joined between)\n",
      100 * distance.two.misplaced / flux, distance.two.largest, file.intensityUnit);
  const double reference = referenceFlux(file);
  text += tableText(
      fmt::format("utilisation factors, %, of {:.0f} lm: square rooms of room index k, evenly spread", reference)
          .c_str(),
      "k", analysis::roomIndexTable(*file.distribution, reference));
  text += tableText("coefficients of utilisation, %, zonal-cavity method: effective cavity reflectances", "RCR",
                    analysis::zonalCavityTable(*file.distribution, reference));
  return text + ugrText(file);
}

}  // namespace goniolux::pipeline
