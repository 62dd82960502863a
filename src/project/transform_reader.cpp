#include "project/transform_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "project/section_reader.h"

namespace goniolux::project {
namespace {

core::Mat4 translation(const core::Vec3& by) {
  core::Mat4 matrix(1.0);
  matrix[3] = {by, 1.0};
  return matrix;
}

core::Mat4 readRotation(const core::Value& value, Reading& reading) {
  SectionReader section(value, rotationSection(), reading);
  if (!section.isObject()) return core::Mat4(1.0);
  const auto axis = section.direction("axis");
  const auto degrees = section.number("degrees");
  const core::Vec3 center = section.point("center").value_or(core::Vec3(0));
  if (!axis || !degrees) return core::Mat4(1.0);
  return translation(center) * core::Mat4(rotation(*axis, *degrees * core::degree)) * translation(-center);
}

core::Mat4 readScale(const core::Value& value, const Key& key, Reading& reading) {
  core::Mat4 matrix(1.0);
  if (!value.isArray()) {
    if (const auto factor = readNumber(value, key, reading)) matrix = core::Mat4(core::Mat3(*factor));
  } else if (const auto factors = readVector(value, key, reading)) {
    for (int axis = 0; axis < 3; ++axis) {
      // A negative factor would turn the object inside out.
      if (!readNumber(value.array()[static_cast<std::size_t>(axis)], key, reading)) return core::Mat4(1.0);
      matrix[axis][axis] = (*factors)[axis];
    }
  }
  return matrix;
}

core::Mat4 readShear(const core::Value& value, Reading& reading) {
  SectionReader section(value, shearSection(), reading);
  core::Mat4 matrix(1.0);
  if (!section.isObject()) return matrix;
  constexpr const char* axes = "xyz";
  for (int to = 0; to < 3; ++to)
    for (int from = 0; from < 3; ++from)
      if (to != from) matrix[from][to] = section.number({axes[to], axes[from]}).value_or(0);
  if (!(std::abs(glm::determinant(core::Mat3(matrix))) > 1e-9)) {
    reading.error(value, "flat-shear", "this shear presses everything into a plane; make its numbers smaller");
    return core::Mat4(1.0);
  }
  return matrix;
}

core::Mat4 readStep(const core::Value& value, Reading& reading) {
  SectionReader step(value, transformStepSection(), reading);
  if (!step.isObject() || step.failed()) return core::Mat4(1.0);
  if (value.object().size() != 1) {
    reading.error(value, "transform-step",
                  "a step is one of \"translate\", \"rotate\", \"scale\" or \"shear\"; list several in order");
    return core::Mat4(1.0);
  }
  if (const core::Value* rotate = step.find("rotate")) return readRotation(*rotate, reading);
  if (const core::Value* shear = step.find("shear")) return readShear(*shear, reading);
  if (const core::Value* scale = step.find("scale"))
    return readScale(*scale, *transformStepSection().find("scale"), reading);
  return translation(step.point("translate").value_or(core::Vec3(0)));
}

}  // namespace

core::Mat3 rotation(const core::Vec3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
  const core::Vec3& a = axis;
  // Columns.
  return {core::Vec3(t * a.x * a.x + c, t * a.x * a.y + s * a.z, t * a.x * a.z - s * a.y),
          core::Vec3(t * a.x * a.y - s * a.z, t * a.y * a.y + c, t * a.y * a.z + s * a.x),
          core::Vec3(t * a.x * a.z + s * a.y, t * a.y * a.z - s * a.x, t * a.z * a.z + c)};
}

core::Mat4 readTransform(const core::Value& steps, Reading& reading) {
  core::Mat4 matrix(1.0);
  if (!steps.isArray()) {
    reading.error(steps, "wrong-type", "\"transform\" must be a list of steps [{ \"translate\": [x, y, z] }, …]");
    return matrix;
  }
  for (const core::Value& step : steps.array()) matrix = readStep(step, reading) * matrix;
  return matrix;
}

}  // namespace goniolux::project
