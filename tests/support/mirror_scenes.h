// Scenes of quads, balls and mirrors that several test programs look into.
#pragma once

#include <cmath>
#include <string>

#include "geometry/objects.h"
#include "scene/environment.h"
#include "scene/view.h"

namespace goniolux::test {

inline material::Material flatFinish(const std::string& model, const char* key, double value) {
  material::Material material;
  material.name = material.model = model;
  material.spectra[key] = spectrum::SpectralDistribution::flat(value);
  return material;
}

inline void addQuad(scene::Environment& environment, const core::Vec3& origin, const core::Vec3& u, const core::Vec3& v,
                    std::uint32_t material) {
  scene::Object quad;
  quad.shape.partNames = {"surface"};
  quad.shape.mesh.vertices = {origin, origin + u, origin + u + v, origin + v};
  quad.shape.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  quad.shape.mesh.parts = {0, 0};
  quad.materials = {material};
  environment.objects.push_back(quad);
}

inline void addBall(scene::Environment& environment, const core::Vec3& center, double radius, double luminance) {
  scene::Luminaire lamp;
  lamp.name = lamp.type = "ball";
  lamp.center = center;
  lamp.opening = {.shape = emitter::Opening::Shape::sphere, .diameter = 2 * radius};
  lamp.flux_lm = luminance * 4 * core::pi * core::pi * radius * radius;
  environment.luminaires.push_back(lamp);
}

/// Gallery G1: 12 x 4 x 4 m, four mirrors of reflectance `rho` on each long wall, eight lamps of 105 mm (catalogue of
/// validation cases, 7.2).
inline scene::Environment gallery(double rho) {
  scene::Environment environment;
  environment.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
  environment.materials = {flatFinish("lambert", "diffuse", 0.5), flatFinish("mirror", "reflectance", rho)};
  scene::Object room;
  room.shape = geometry::findObjectType("box")->make({{"min", core::Vec3(0)}, {"max", core::Vec3(12, 4, 4)}});
  room.materials.assign(room.shape.partNames.size(), 0);
  environment.objects = {room};
  for (int i = 0; i < 4; ++i)
    for (const double y : {1e-3, 4 - 1e-3}) addQuad(environment, {0.3 + 3 * i, y, 0.5}, {2.4, 0, 0}, {0, 0, 2.02}, 1);
  for (const double x : {1.5, 4.5, 7.5, 10.5})
    for (const double y : {1.0, 3.0}) addBall(environment, {x, y, 3.7}, 0.0525, 1);
  return environment;
}

inline scene::View galleryView() {
  scene::View view;
  view.eye = {1.5, 0.5, 1.6};
  view.target = {3, 4, 1.6};
  view.width = 640, view.height = 480;
  view.verticalFov = 2 * std::atan(std::tan(35 * core::degree) * 480 / 640);
  return view;
}

}  // namespace goniolux::test
