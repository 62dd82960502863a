#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <span>
#include <tuple>

#include "core/closest_name.h"
#include "core/document.h"
#include "core/embedded.h"
#include "core/text.h"
#include "display/device.h"
#include "display/device_section.h"
#include "display/icc_device.h"

namespace goniolux::display {

std::span<const core::EmbeddedText> devicePresets();  // generated from data/devices/*.device.json by cmake/embed.cmake

namespace {

using core::Value;

class Reader {
 public:
  explicit Reader(core::Diagnostics& diagnostics) : section_(diagnostics) {}

  Device read(const Value& root) {
    Device device;
    if (!root.isObject()) {
      section_.complain(root, "type", "a device file holds one object");
      return device;
    }
    const Value* format = root.find("format");
    if (format == nullptr || !format->isString() || format->string() != "goniolux-device") {
      section_.complain(format != nullptr ? *format : root, "format",
                        "this is no device file: \"format\" must be \"goniolux-device\"");
      return device;
    }
    const Value* version = root.find("version");
    if (version == nullptr || !version->isNumber() || version->number() != 1) {
      section_.complain(version != nullptr ? *version : root, "version", "\"version\" must be 1");
    }
    device.name = section_.text(root, "name");
    device.source = section_.text(root, "source");
    device.white_cd_m2 = section_.number(root, "white_cd_m2", 0, 1, 1e5);
    device.black_cd_m2 = section_.number(root, "black_cd_m2", 0, 0, 1e4);
    device.flare_cd_m2 = section_.number(root, "flare_cd_m2", 0, 0, 1e4);
    checkDark(root, device);
    const std::string kind = root.find("kind") != nullptr ? section_.text(root, "kind") : "monitor";
    if (kind == "monitor") {
      readMonitor(root, device);
    } else if (kind == "film-recorder") {
      device.kind = Device::Kind::film;
      readFilm(root, section_, device);
    } else if (!section_.hasErrors()) {
      section_.complain(*root.find("kind"), "kind",
                        fmt::format("there is no kind \"{}\" of device{}", kind,
                                    core::suggestion(kind, {"monitor", "film-recorder"})));
    }
    return device;
  }

 private:
  void checkDark(const Value& root, const Device& device) {
    const double dark = device.black_cd_m2 + device.flare_cd_m2;
    if (dark > 0 && device.white_cd_m2 == 0)
      section_.complain(root, "missing-key", "\"black_cd_m2\" and \"flare_cd_m2\" need \"white_cd_m2\" beside them");
    else if (dark > 0.5 * device.white_cd_m2)
      section_.complain(root, "range", "black and flare together exceed half of the white: nothing can be shown");
  }

  void readMonitor(const Value& root, Device& device) {
    section_.checkKeys(root, {"format", "version", "kind", "name", "source", "primaries", "white", "transfer",
                              "white_cd_m2", "black_cd_m2", "flare_cd_m2"});
    if (const Value* primaries = section_.member(root, "primaries", Value::Kind::object, "an object")) {
      section_.checkKeys(*primaries, {"red", "green", "blue"});
      device.red = section_.chromaticity(*primaries, "red");
      device.green = section_.chromaticity(*primaries, "green");
      device.blue = section_.chromaticity(*primaries, "blue");
    }
    device.white = section_.chromaticity(root, "white");
    if (const Value* transfer = section_.member(root, "transfer", Value::Kind::object, "an object")) {
      if (transfer->find("red") != nullptr) {
        section_.checkKeys(*transfer, {"red", "green", "blue"});
        const char* channels[] = {"red", "green", "blue"};
        for (std::size_t c = 0; c < 3; ++c)
          if (const Value* each = section_.member(*transfer, channels[c], Value::Kind::object, "an object"))
            device.transfer[c] = curve(*each, device);
      } else {
        device.transfer.fill(curve(*transfer, device));
      }
    }
    if (!section_.hasErrors()) checkTriangle(root, device);
  }

  TransferCurve curve(const Value& object, const Device& device) {
    TransferCurve curve;
    if (object.find("table") != nullptr) {
      section_.checkKeys(object, {"table"});
      curve.form = TransferCurve::Form::table;
      curve.light = table(*object.find("table"));
      return curve;
    }
    if (object.find("curve") != nullptr) {
      section_.checkKeys(object, {"curve"});
      curve.form = TransferCurve::Form::pq;
      curve.white_cd_m2 = device.white_cd_m2;
      if (section_.text(object, "curve") != "pq")
        section_.complain(*object.find("curve"), "transfer", "the one curve with a name is \"pq\"");
      else if (!(device.white_cd_m2 > 0))
        section_.complain(object, "missing-key", "the curve \"pq\" is absolute: it needs \"white_cd_m2\"");
      return curve;
    }
    section_.checkKeys(object, {"gamma", "offset", "slope", "threshold"});
    if (object.find("gamma") == nullptr) section_.complain(object, "missing-key", "key \"gamma\" is missing");
    curve.gamma = section_.number(object, "gamma", 1, 0.2, 10);
    curve.offset = section_.number(object, "offset", 0, 0, 1);
    curve.slope = section_.number(object, "slope", 0, 0, 1000);
    curve.threshold = section_.number(object, "threshold", 0, 0, 1);
    const double below = curve.slope * curve.threshold;
    const double above = (1 + curve.offset) * std::pow(curve.threshold, 1 / curve.gamma) - curve.offset;
    if ((curve.offset > 0 || curve.threshold > 0) && std::abs(below - above) > 0.01) {
      section_.complain(
          object, "transfer",
          fmt::format(
              "the straight part ends at {:.4f} where the power begins at {:.4f}; check slope, threshold and offset",
              below, above));
    }
    return curve;
  }

  // Measured light at code values in equal steps: ascending, scaled to 0..1.
  std::vector<double> table(const Value& value) {
    std::vector<double> light{0, 1};
    const bool fits = value.isArray() && value.array().size() >= 2 && value.array().size() <= 65536;
    if (!fits) {
      section_.complain(value, "transfer",
                        "\"table\" must be a list of 2 to 65536 values of light, ascending from 0 to 1");
      return light;
    }
    std::vector<double> read;
    for (const Value& each : value.array()) {
      if (!each.isNumber() || !(read.empty() ? each.number() == 0 : each.number() > read.back())) {
        section_.complain(each, "transfer", "the table must begin at 0 and ascend from value to value");
        return light;
      }
      read.push_back(each.number());
    }
    if (std::abs(read.back() - 1) > 1e-9)
      section_.complain(value.array().back(), "transfer", "the table must end at 1");
    return read;
  }

  void checkTriangle(const Value& root, const Device& device) {
    const auto& [r, g, b, w] = std::tie(device.red, device.green, device.blue, device.white);
    const auto area = [](const auto& p, const auto& q, const auto& s) {
      return (q.x - p.x) * (s.y - p.y) - (q.y - p.y) * (s.x - p.x);
    };
    const double whole = area(r, g, b);
    if (std::abs(whole) < 1e-4) {
      section_.complain(root, "primaries", "the primaries lie on one line: no colours can be mixed from them");
      return;
    }
    for (const double part : {area(w, g, b), area(r, w, b), area(r, g, w)}) {
      if (part / whole <= 1e-6) {
        section_.complain(*root.find("white"), "white", "the white lies outside the triangle of the primaries");
        return;
      }
    }
  }

  DeviceSection section_;
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
  const std::string lower = core::lowerCase(presetOrPath);
  for (const auto& preset : devicePresets()) {
    if (preset.name == lower) return parseDevice(std::string(preset.text), fmt::format("preset {}", preset.name));
  }
  if (!std::filesystem::exists(presetOrPath) && presetOrPath.find_first_of("./") == std::string::npos) {
    throw core::InputError(
        {presetOrPath, 0, 0}, "unknown-device",
        fmt::format("there is no such device preset or file{}", core::suggestion(lower, presetNames())));
  }
  std::string bytes = core::readFile(presetOrPath);
  if (isIccProfile(bytes)) return iccDevice(std::move(bytes), presetOrPath);
  return parseDevice(bytes, presetOrPath);
}

}  // namespace goniolux::display
