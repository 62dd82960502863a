#include "validation/projects.h"

#include <fmt/format.h>

#include <cmath>

#include "core/progress.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"

namespace goniolux::validation {
namespace {

void add(std::string& to, const std::string& members) {
  if (!to.empty()) to += ",\n";
  to += "{ " + members + " }";
}

std::string list(const std::vector<core::Vec3>& vectors) {
  std::string text;
  for (const core::Vec3& v : vectors) text += (text.empty() ? "" : ",") + validation::list(v);
  return "[" + text + "]";
}

// Replicates of an exact value differ in their last digits, by the order of sums: no chance.
double byChance(double value, double halfWidth) {
  return halfWidth > 1e-9 * std::abs(value) ? halfWidth : 0;
}

pipeline::StageRequest requestFor(const ProjectText& project) {
  pipeline::StageRequest request;
  request.inputs = {std::string(GONIOLUX_SOURCE_DIR) + "/projects/validation"};
  request.projectText = project.text();
  return request;
}

project::Results calculate(pipeline::StageRequest request, const std::string& accuracy, const std::string& solver) {
  request.common.accuracy = accuracy;
  if (!solver.empty()) request.common.solver = solver;
  const project::Project project = pipeline::readProjectFor(request, pipeline::AccuracyOf::grids);
  const pipeline::Engine engine(project, false);
  core::SilentProgress silent;
  return pipeline::calculateGrids(project, engine, silent);
}

}  // namespace

std::string list(const core::Vec3& v) {
  return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

void ProjectText::material(const std::string& name, const std::string& members) {
  if (!materials_.empty()) materials_ += ",\n";
  materials_ += fmt::format("\"{}\": {{ {} }}", name, members);
}
void ProjectText::paint(const std::string& name, double rho, double exitance) {
  material(name, fmt::format(R"("model": "lambert", "diffuse": {}{})", rho,
                             exitance > 0 ? fmt::format(R"(, "exitance_lm_m2": {})", exitance) : ""));
}
void ProjectText::object(const std::string& members) {
  add(objects_, members);
}
void ProjectText::room(const core::Vec3& size, const std::string& material, const core::Vec3& min) {
  object(fmt::format(R"("shape": "box", "min": {}, "max": {}, "facing": "inward", "material": "{}")",
                     validation::list(min), validation::list(min + size), material));
}
void ProjectText::surround(double half) {
  paint("surround", 0);
  room(core::Vec3(2 * half), "surround", core::Vec3(-half));
}
void ProjectText::rectangle(const core::Vec3& origin, const core::Vec3& u, const core::Vec3& v,
                            const std::string& material) {
  object(fmt::format(R"("shape": "rectangle", "origin": {}, "u": {}, "v": {}, "material": "{}")",
                     validation::list(origin), validation::list(u), validation::list(v), material));
}
void ProjectText::luminaire(const core::Vec3& position, const std::string& members) {
  add(luminaires_, fmt::format(R"("position": {}, {})", validation::list(position), members));
}
void ProjectText::points(const std::string& name, const std::vector<core::Vec3>& points,
                         const std::vector<core::Vec3>& normals, const std::string& members) {
  add(grids_, fmt::format(R"("name": "{}", "points": {}, {}{}{})", name, list(points),
                          normals.size() == 1 ? R"("normal": )" + validation::list(normals[0])
                                              : R"("normals": )" + list(normals),
                          members.empty() ? "" : ", ", members));
}
void ProjectText::plane(const std::string& name, const core::Vec3& origin, const core::Vec3& u, const core::Vec3& v,
                        int along, int across, const core::Vec3& normal) {
  add(grids_, fmt::format(R"("name": "{}", "origin": {}, "u": {}, "v": {}, "counts": [{},{}], "normal": {})", name,
                          validation::list(origin), validation::list(u), validation::list(v), along, across,
                          validation::list(normal)));
}
void ProjectText::observer(const std::string& name, const core::Vec3& eye, const core::Vec3& direction) {
  add(observers_, fmt::format(R"("name": "{}", "eye": {}, "direction": {})", name, validation::list(eye),
                              validation::list(direction)));
}

std::string ProjectText::text() const {
  // A project has a luminaire; where only surfaces shine it is switched off.
  const std::string off = R"({ "position": [0.01,0.01,0.01], "photometry": "isotropic", "flux": 1, "dimming": 0 })";
  return fmt::format(
      "{{ \"format\": \"goniolux-project\", \"version\": 1, \"name\": \"case\",\n\"materials\": {{ {} "
      "}},\n\"objects\": "
      "[ {} ],\n\"luminaires\": [ {} ],\n\"grids\": [ {} ],\n\"observers\": [ {} ] }}\n",
      materials_, objects_, luminaires_.empty() ? off : luminaires_, grids_, observers_);
}

project::Project projectOf(const ProjectText& text) {
  return pipeline::readProjectFor(requestFor(text), pipeline::AccuracyOf::grids);
}

project::Results calculate(const ProjectText& project, const std::string& accuracy, const std::string& solver) {
  return calculate(requestFor(project), accuracy, solver);
}

project::Results calculateProject(const std::string& folder, const std::string& accuracy) {
  pipeline::StageRequest request;
  request.inputs = {std::string(GONIOLUX_SOURCE_DIR) + "/projects/" + folder};
  return calculate(std::move(request), accuracy, "");
}

Number numberAt(const std::string& what, double reference, const project::GridResult& grid, std::size_t index,
                double uncertainty) {
  return {what, reference, grid.values.at(index), byChance(grid.values.at(index), grid.halfWidths.at(index)),
          uncertainty};
}

Number numberOf(const std::string& what, double reference, const core::Estimate& estimate, double uncertainty) {
  return {what, reference, estimate.value, byChance(estimate.value, estimate.halfWidth()), uncertainty};
}

}  // namespace goniolux::validation
