#include "app/gui/document/placement.h"

#include <cmath>
#include <optional>

#include "app/gui/document/document.h"
#include "app/gui/document/json_pointer.h"

namespace goniolux::gui {
namespace {

using core::Value;
using core::Vec3;

/// The digits that one would type: a micrometre, a millionth of a degree.
double tidy(double value) {
  const double rounded = std::round(value * 1e6) / 1e6;
  return rounded == 0 ? 0 : rounded;  // no "-0"
}

Value valueOf(const Vec3& v) {
  return Value::Array{tidy(v.x), tidy(v.y), tidy(v.z)};
}

std::optional<Vec3> vectorAt(const Value& root, const std::string& pointer) {
  const Value* value = valueAt(root, pointer);
  if (value == nullptr || !value->isArray() || value->array().size() != 3) return std::nullopt;
  Vec3 v;
  for (int k = 0; k < 3; ++k) {
    const Value& part = value->array()[static_cast<std::size_t>(k)];
    if (!part.isNumber()) return std::nullopt;
    v[k] = part.number();
  }
  return v;
}

bool shift(project::ProjectText& text, const std::string& pointer, const Vec3& by) {
  const auto old = vectorAt(text.root(), pointer);
  if (!old) return false;
  setIn(text, pointer, valueOf(*old + by));
  return true;
}

/// The last step of an object's transform, where it is of a kind: its pointer; "" otherwise.
std::string lastStepOf(const Value& root, const std::string& object, const char* kind) {
  const std::string transform = under(object, "transform");
  const Value* steps = valueAt(root, transform);
  if (steps == nullptr || !steps->isArray() || steps->array().empty()) return {};
  const std::string step = under(under(transform, steps->array().size() - 1), kind);
  return valueAt(root, step) != nullptr ? step : std::string();
}

void addStep(project::ProjectText& text, const std::string& object, const char* kind, const Value& value) {
  const std::string transform = under(object, "transform");
  const Value step = Value::Object{{kind, value}};
  if (const Value* steps = valueAt(text.root(), transform)) {
    text.append(*steps, step);
  } else {
    setIn(text, transform, Value::Array{step});
  }
}

bool moveObject(project::ProjectText& text, const std::string& object, const Vec3& by) {
  const bool hasTransform = valueAt(text.root(), under(object, "transform")) != nullptr;
  const std::string low = under(object, "min"), high = under(object, "max");
  const Value* shape = valueAt(text.root(), under(object, "shape"));
  if (!hasTransform && shape != nullptr && shape->isString() && shape->string() == "box" &&
      vectorAt(text.root(), low) && vectorAt(text.root(), high))
    return shift(text, low, by) && shift(text, high, by);
  if (const std::string step = lastStepOf(text.root(), object, "translate"); !step.empty())
    return shift(text, step, by);
  addStep(text, object, "translate", valueOf(by));
  return true;
}

bool turnObject(project::ProjectText& text, const std::string& object, double degrees, const Vec3& center) {
  if (const std::string step = lastStepOf(text.root(), object, "rotate"); !step.empty()) {
    // The same turn goes on: one step of the transform, not one for each pull of the mouse.
    const auto axis = vectorAt(text.root(), under(step, "axis")), about = vectorAt(text.root(), under(step, "center"));
    const Value* angle = valueAt(text.root(), under(step, "degrees"));
    if (axis && about && *axis == Vec3(0, 0, 1) &&
        glm::length(Vec3(about->x - center.x, about->y - center.y, 0)) < 0.01 && angle != nullptr &&
        angle->isNumber()) {
      setIn(text, under(step, "degrees"), tidy(std::remainder(angle->number() + degrees, 360)));
      return true;
    }
  }
  addStep(text, object, "rotate",
          Value::Object{{"axis", valueOf({0, 0, 1})}, {"degrees", tidy(degrees)}, {"center", valueOf(center)}});
  return true;
}

bool turnLuminaire(project::ProjectText& text, const std::string& luminaire, double degrees) {
  const auto add = [&](const char* key, double by) {
    const Value* old = valueAt(text.root(), under(luminaire, key));
    const double before = old != nullptr && old->isNumber() ? old->number() : 0;
    setIn(text, under(luminaire, key), tidy(std::remainder(before + by, 360)));
    return true;
  };
  for (const char* key : {"rotation", "tilt"})
    if (valueAt(text.root(), under(luminaire, key)) != nullptr) return add("rotation", degrees);
  const std::string aimed = under(luminaire, "aim"), side = under(luminaire, "c0");
  const Vec3 aim = vectorAt(text.root(), aimed).value_or(Vec3(0, 0, -1));
  // "turn" is right-handed about the aim: down it runs the other way round.
  if (std::abs(aim.x) + std::abs(aim.y) < 1e-9) return add("turn", aim.z < 0 ? -degrees : degrees);
  const Vec3 c0 =
      vectorAt(text.root(), side).value_or(std::abs(aim.y) + std::abs(aim.z) < 1e-9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0));
  const double c = std::cos(degrees * core::degree), s = std::sin(degrees * core::degree);
  const auto turned = [&](const Vec3& v) { return Vec3(c * v.x - s * v.y, s * v.x + c * v.y, v.z); };
  setIn(text, aimed, valueOf(turned(aim)));
  setIn(text, side, valueOf(turned(c0)));
  return true;
}

}  // namespace

double metresPerUnit(const Value& root) {
  const Value* units = root.find("units");
  const std::string unit = units != nullptr && units->isString() ? units->string() : "m";
  return unit == "mm" ? 0.001 : unit == "cm" ? 0.01 : unit == "ft" ? 0.3048 : unit == "in" ? 0.0254 : 1;
}

bool moveIn(project::ProjectText& text, const std::string& pointer, const Vec3& metres) {
  const Vec3 by = metres / metresPerUnit(text.root());
  if (pointer.starts_with("/luminaires/")) return shift(text, under(pointer, "position"), by);
  if (pointer.starts_with("/objects/")) return moveObject(text, pointer, by);
  if (pointer.starts_with("/observers/")) return shift(text, under(pointer, "eye"), by);
  if (pointer.starts_with("/grids/")) return shift(text, under(pointer, "origin"), by);
  if (pointer.starts_with("/views/"))
    return shift(text, under(pointer, "eye"), by) && shift(text, under(pointer, "target"), by);
  return false;
}

bool turnIn(project::ProjectText& text, const std::string& pointer, double degrees, const Vec3& center) {
  if (pointer.starts_with("/luminaires/")) return turnLuminaire(text, pointer, degrees);
  if (pointer.starts_with("/objects/")) return turnObject(text, pointer, degrees, center / metresPerUnit(text.root()));
  return false;
}

}  // namespace goniolux::gui
