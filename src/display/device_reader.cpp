#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "core/closest_name.h"
#include "core/document.h"
#include "core/embedded.h"
#include "display/device.h"

namespace goniolux::display {

std::span<const core::EmbeddedText> devicePresets();  // generated from data/devices/*.device.json by cmake/embed.cmake

namespace {

using core::Value;

class Reader {
 public:
  explicit Reader(core::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  Device read(const Value& root) {
    Device device;
    if (!root.isObject()) {
      complain(root, "type", "a device file holds one object");
      return device;
    }
    checkKeys(root, {"format", "version", "name", "source", "primaries", "white", "transfer"});
    const Value* format = root.find("format");
    if (format == nullptr || !format->isString() || format->string() != "goniolux-device") {
      complain(format != nullptr ? *format : root, "format",
               "this is no device file: \"format\" must be \"goniolux-device\"");
      return device;
    }
    const Value* version = root.find("version");
    if (version == nullptr || !version->isNumber() || version->number() != 1) {
      complain(version != nullptr ? *version : root, "version", "\"version\" must be 1");
    }
    device.name = text(root, "name");
    device.source = text(root, "source");
    if (const Value* primaries = member(root, "primaries", Value::Kind::object, "an object")) {
      checkKeys(*primaries, {"red", "green", "blue"});
      device.red = chromaticity(*primaries, "red");
      device.green = chromaticity(*primaries, "green");
      device.blue = chromaticity(*primaries, "blue");
    }
    device.white = chromaticity(root, "white");
    if (const Value* transfer = member(root, "transfer", Value::Kind::object, "an object")) {
      device.transfer = curve(*transfer);
    }
    if (!diagnostics_.hasErrors()) checkTriangle(root, device);
    return device;
  }

 private:
  void complain(const Value& at, const char* rule, std::string message) {
    diagnostics_.error(at.position(), rule, std::move(message));
  }

  void checkKeys(const Value& object, const std::vector<std::string>& known) {
    for (const auto& [key, value] : object.object()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      diagnostics_.error(value.keyPosition(), "unknown-key",
                         fmt::format("unknown key \"{}\"{}", key, core::suggestion(key, known)));
    }
  }

  const Value* member(const Value& object, const char* key, Value::Kind kind, const char* what) {
    const Value* value = object.find(key);
    if (value == nullptr) {
      complain(object, "missing-key", fmt::format("key \"{}\" is missing", key));
      return nullptr;
    }
    if (value->kind() != kind) {
      complain(*value, "type", fmt::format("\"{}\" must be {}", key, what));
      return nullptr;
    }
    return value;
  }

  std::string text(const Value& object, const char* key) {
    if (object.find(key) == nullptr) return "";
    const Value* value = member(object, key, Value::Kind::string, "a text");
    return value != nullptr ? value->string() : "";
  }

  spectrum::Chromaticity chromaticity(const Value& object, const char* key) {
    const Value* value = member(object, key, Value::Kind::array, "the two CIE chromaticity coordinates [x, y]");
    if (value == nullptr) return {};
    const auto& pair = value->array();
    const bool fits = pair.size() == 2 && pair[0].isNumber() && pair[1].isNumber();
    // Primaries may be imaginary, but y divides and white must be a colour.
    if (!fits || pair[1].number() <= 0 || std::abs(pair[0].number()) > 2 || pair[1].number() > 2) {
      complain(*value, "chromaticity",
               fmt::format("\"{}\" must be the two CIE chromaticity coordinates [x, y], y above 0", key));
      return {};
    }
    return {pair[0].number(), pair[1].number()};
  }

  double number(const Value& object, const char* key, double standard, double minimum, double maximum) {
    if (object.find(key) == nullptr) return standard;
    const Value* value = member(object, key, Value::Kind::number, "a number");
    if (value == nullptr) return standard;
    if (!(value->number() >= minimum && value->number() <= maximum)) {
      complain(*value, "range", fmt::format("\"{}\" must lie between {} and {}", key, minimum, maximum));
    }
    return value->number();
  }

  TransferCurve curve(const Value& object) {
    checkKeys(object, {"gamma", "offset", "slope", "threshold"});
    if (object.find("gamma") == nullptr) complain(object, "missing-key", "key \"gamma\" is missing");
    TransferCurve curve{number(object, "gamma", 1, 0.2, 10), number(object, "offset", 0, 0, 1),
                        number(object, "slope", 0, 0, 1000), number(object, "threshold", 0, 0, 1)};
    const double below = curve.slope * curve.threshold;
    const double above = (1 + curve.offset) * std::pow(curve.threshold, 1 / curve.gamma) - curve.offset;
    if ((curve.offset > 0 || curve.threshold > 0) && std::abs(below - above) > 0.01) {
      complain(
          object, "transfer",
          fmt::format(
              "the straight part ends at {:.4f} where the power begins at {:.4f}; check slope, threshold and offset",
              below, above));
    }
    return curve;
  }

  void checkTriangle(const Value& root, const Device& device) {
    const auto& [r, g, b, w] = std::tie(device.red, device.green, device.blue, device.white);
    const auto area = [](const auto& p, const auto& q, const auto& s) {
      return (q.x - p.x) * (s.y - p.y) - (q.y - p.y) * (s.x - p.x);
    };
    const double whole = area(r, g, b);
    if (std::abs(whole) < 1e-4) {
      complain(root, "primaries", "the primaries lie on one line: no colours can be mixed from them");
      return;
    }
    for (const double part : {area(w, g, b), area(r, w, b), area(r, g, w)}) {
      if (part / whole <= 1e-6) {
        complain(*root.find("white"), "white", "the white lies outside the triangle of the primaries");
        return;
      }
    }
  }

  core::Diagnostics& diagnostics_;
};

Device parseDevice(const std::string& text, const std::string& name) {
  core::Diagnostics diagnostics;
  const Value root = core::parseJson(text, name, diagnostics);
  Device device;
  if (!diagnostics.hasErrors()) device = Reader(diagnostics).read(root);
  if (diagnostics.hasErrors()) throw core::InputError(std::move(diagnostics));
  return device;
}

}  // namespace

std::vector<std::string> presetNames() {
  std::vector<std::string> names;
  for (const auto& preset : devicePresets()) names.emplace_back(preset.name);
  return names;
}

Device readDevice(const std::string& presetOrPath) {
  std::string lower = presetOrPath;
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const auto& preset : devicePresets()) {
    if (preset.name == lower) return parseDevice(std::string(preset.text), fmt::format("preset {}", preset.name));
  }
  if (!std::filesystem::exists(presetOrPath) && presetOrPath.find_first_of("./") == std::string::npos) {
    throw core::InputError(
        {presetOrPath, 0, 0}, "unknown-device",
        fmt::format("there is no such device preset or file{}", core::suggestion(lower, presetNames())));
  }
  return parseDevice(core::readFile(presetOrPath), presetOrPath);
}

}  // namespace goniolux::display
