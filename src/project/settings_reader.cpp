#include "project/settings_reader.h"

#include <fmt/format.h>

#include <charconv>

#include "project/section_reader.h"
#include "project/spectrum_reader.h"

namespace goniolux::project {
namespace {

/// `tree` with the member at `path` ("tree.cutoff") replaced; what stands in the way of the path gives way to an
/// object.
core::Value withMember(const core::Value& tree, std::string_view path, const core::Value& value,
                       const core::SourcePosition& position) {
  const std::size_t dot = path.find('.');
  const std::string key(path.substr(0, dot));
  core::Value::Object members = tree.isObject() ? tree.object() : core::Value::Object{};
  const core::Value* before = tree.find(key);
  core::Value after = dot == std::string_view::npos
                          ? value
                          : withMember(before ? *before : core::Value(), path.substr(dot + 1), value, position);
  if (!after.isObject() || !before) after.setPosition(position);
  after.setKeyPosition(position);
  bool replaced = false;
  for (auto& [name, member] : members) {
    if (name != key) continue;
    member = after;
    replaced = true;
  }
  if (!replaced) members.emplace_back(key, after);
  core::Value result(std::move(members));
  result.setPosition(tree.isObject() ? tree.position() : position);
  result.setKeyPosition(tree.isObject() ? tree.keyPosition() : position);
  return result;
}

core::Value withOverrides(const core::Value* section, const std::vector<std::string>& overrides, Reading& reading) {
  core::Value tree = section ? *section : core::Value(core::Value::Object{});
  for (const std::string& text : overrides) {
    const core::SourcePosition position{"--set " + text, 0, 0};
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) {
      reading.diagnostics.error(position, "usage", "write KEY=VALUE, e.g. tree.cutoff=0.01");
      continue;
    }
    // 0.01, true, null and { … } are JSON; anything else is a text: no quotes are needed on the command line.
    core::Diagnostics notJson;
    core::Value value = core::parseJson(text.substr(equals + 1), position.file, notJson);
    if (notJson.hasErrors()) value = core::Value(text.substr(equals + 1));
    value.setPosition(position);
    tree = withMember(tree, std::string_view(text).substr(0, equals), value, position);
  }
  return tree;
}

void readAccuracy(const core::Value& value, AccuracyAsked& accuracy, Reading& reading) {
  SectionReader section(value, accuracySection(), reading);
  if (!section.isObject()) return;
  accuracy.grid = section.percentage("grid").value_or(accuracy.grid);
  accuracy.u0 = section.percentage("u0").value_or(accuracy.u0);
  accuracy.ugr = section.number("ugr").value_or(accuracy.ugr);
  accuracy.image = section.percentage("image").value_or(accuracy.image);
  accuracy.colourDe = section.number("colour_de").value_or(accuracy.colourDe);
  accuracy.confidence = section.number("confidence").value_or(accuracy.confidence);
}

/// "auto", "uniform:9" (as on the command line) or { "scheme": …, "samples": … }.
void readSpectral(const core::Value& value, Settings& settings, Reading& reading) {
  core::Value::Object members;
  const core::Value* object = &value;
  core::Value fromText;
  if (value.isString()) {
    const std::string& text = value.string();
    const std::size_t colon = text.find(':');
    members.emplace_back("scheme", text.substr(0, colon));
    if (colon != std::string::npos) {
      double samples = 0;
      const char* end = text.data() + text.size();
      const auto result = std::from_chars(text.data() + colon + 1, end, samples);
      if (result.ec != std::errc() || result.ptr != end) {
        reading.error(value, "wrong-type",
                      fmt::format("\"spectral\" is \"{}\"; write SCHEME or SCHEME:N, e.g. uniform:9", text));
        return;
      }
      members.emplace_back("samples", samples);
    }
    for (auto& [name, member] : members) {
      member.setPosition(value.position());
      member.setKeyPosition(value.position());
    }
    fromText = core::Value(std::move(members));
    fromText.setPosition(value.position());
    object = &fromText;
  }
  SectionReader section(*object, spectralSection(), reading);
  if (section.failed()) return;
  settings.spectralScheme = section.choice("scheme").value_or(settings.spectralScheme);
  settings.spectralSamples = section.integer("samples").value_or(settings.spectralSamples);
}

void readTree(const core::Value& value, Settings& settings, Reading& reading) {
  SectionReader section(value, treeSection(), reading);
  if (!section.isObject()) return;
  settings.treeMaxDepth = section.integer("max_depth").value_or(settings.treeMaxDepth);
  settings.treeCutoff = section.number("cutoff").value_or(settings.treeCutoff);
  settings.treeAdaptive = section.boolean("adaptive").value_or(settings.treeAdaptive);
}

void readPixel(const core::Value& value, Settings& settings, Reading& reading) {
  SectionReader section(value, pixelSection(), reading);
  if (!section.isObject()) return;
  settings.pixelMinSamples = section.integer("min_samples").value_or(settings.pixelMinSamples);
  settings.pixelMaxSamples = section.integer("max_samples").value_or(settings.pixelMaxSamples);
  settings.pixelContrast = section.number("contrast").value_or(settings.pixelContrast);
  settings.pixelFilter = section.choice("filter").value_or(settings.pixelFilter);
  if (settings.pixelMinSamples > settings.pixelMaxSamples) {
    reading.error(value, "out-of-range",
                  fmt::format("\"min_samples\" ({}) exceeds \"max_samples\" ({})", settings.pixelMinSamples,
                              settings.pixelMaxSamples));
  }
}

}  // namespace

Settings readSettings(const core::Value* given, const std::vector<std::string>& overrides, Reading& reading) {
  Settings settings;
  const core::Value tree = withOverrides(given, overrides, reading);
  SectionReader section(tree, settingsSection(), reading);
  if (!section.isObject()) return settings;
  if (const core::Value* accuracy = section.find("accuracy")) readAccuracy(*accuracy, settings.accuracy, reading);
  if (const core::Value* ambient = section.find("ambient")) {
    const auto spectrum =
        readSpectrum(*ambient, *settingsSection().find("ambient"), spectrum::Role::coefficient, reading);
    if (spectrum) settings.ambient = *spectrum;
  }
  settings.solver = section.choice("solver").value_or(settings.solver);
  settings.reflectionModel = section.choice("reflection_model").value_or(settings.reflectionModel);
  settings.asPrinted = section.boolean("as_printed").value_or(settings.asPrinted);
  if (const core::Value* spectral = section.find("spectral")) readSpectral(*spectral, settings, reading);
  if (const core::Value* treeSettings = section.find("tree")) readTree(*treeSettings, settings, reading);
  if (const core::Value* pixel = section.find("pixel")) readPixel(*pixel, settings, reading);
  settings.timeLimit_s = section.number("time_limit_s");
  if (const auto seed = section.number("seed")) {
    if (*seed != static_cast<double>(static_cast<std::uint64_t>(*seed))) {
      section.refuse("seed", "wrong-type", fmt::format("\"seed\" is {}; a whole number is expected", *seed));
    } else {
      settings.seed = static_cast<std::uint64_t>(*seed);
    }
  }
  return settings;
}

core::Value settingsDocument(const Settings& settings) {
  core::Value accuracy;
  accuracy.set("grid", settings.accuracy.grid);
  accuracy.set("u0", settings.accuracy.u0);
  accuracy.set("ugr", settings.accuracy.ugr);
  accuracy.set("image", settings.accuracy.image);
  accuracy.set("colour_de", settings.accuracy.colourDe);
  accuracy.set("confidence", settings.accuracy.confidence);
  core::Value spectral;
  spectral.set("scheme", settings.spectralScheme);
  spectral.set("samples", settings.spectralSamples);
  core::Value tree;
  tree.set("max_depth", settings.treeMaxDepth);
  tree.set("cutoff", settings.treeCutoff);
  tree.set("adaptive", settings.treeAdaptive);
  core::Value pixel;
  pixel.set("min_samples", settings.pixelMinSamples);
  pixel.set("max_samples", settings.pixelMaxSamples);
  pixel.set("contrast", settings.pixelContrast);
  pixel.set("filter", settings.pixelFilter);
  core::Value document;
  document.set("accuracy", std::move(accuracy));
  document.set("solver", settings.solver);
  document.set("reflection_model", settings.reflectionModel);
  document.set("as_printed", settings.asPrinted);
  document.set("spectral", std::move(spectral));
  document.set("tree", std::move(tree));
  document.set("pixel", std::move(pixel));
  document.set("seed", settings.seed);
  return document;
}

}  // namespace goniolux::project
