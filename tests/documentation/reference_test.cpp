// The reference tables in the pages are written from the tables that the program itself uses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/objects.h"
#include "pipeline/stage.h"
#include "project/format.h"
#include "support/generated_block.h"
#include "support/program.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;
using project::Form;
using project::Key;
using project::Section;

std::string quoted(const std::vector<std::string>& words) {
  return fmt::format("`\"{}\"`", fmt::join(words, "\"`, `\""));
}

std::string describe(const Key& key) {
  switch (key.form) {
    case Form::number:
      return "number";
    case Form::numberOrNull:
      return "number or `null`";
    case Form::integer:
      return "whole number";
    case Form::boolean:
      return "`true` or `false`";
    case Form::text:
      return "text";
    case Form::choice:
      return key.choices.empty() ? "text" : quoted(key.choices);
    case Form::file:
      return "file";
    case Form::length:
      return "length";
    case Form::point:
      return "three lengths";
    case Form::direction:
      return "three numbers";
    case Form::points:
      return "list of points";
    case Form::directions:
      return "list of directions";
    case Form::profile:
      return "list of pairs of lengths";
    case Form::faces:
      return "list of lists of vertex numbers";
    case Form::loops:
      return "list of lists of points";
    case Form::counts:
      return "two whole numbers";
    case Form::percentage:
      return "`\"2 %\"` or 0.02";
    case Form::reflectance:
      return "SPECTRUM from 0 to 1";
    case Form::source:
      return "SPECTRUM of a source";
    case Form::quantity:
      return "SPECTRUM";
    case Form::index:
      return "SPECTRUM, or a formula: `{\"cauchy\": [A, B, C]}`, `{\"sellmeier\": {\"b\": […], \"c\": […]}}`";
    case Form::numbers:
      return "list of numbers";
    case Form::curve:
      return "list of pairs";
    case Form::section:
      return "object";
    case Form::sections:
      return "list of objects";
    case Form::numberMap:
      return "object: number by name";
    case Form::materials:
      return "object: material by name";
    case Form::objects:
      return "list of objects";
    case Form::partMaterials:
      return "object: material by part";
    case Form::transform:
      return "list of steps";
    case Form::scale:
      return "number, or three";
    case Form::photometry:
      return "see Luminaires";
    case Form::opening:
      return "see Luminaires";
    case Form::fieldOfView:
      return "degrees";
    case Form::spectral:
      return "`\"auto\"` or object";
  }
  return "";
}

std::string range(const Key& key) {
  std::string text;
  if (std::isfinite(key.minimum)) text += fmt::format("{} {}", key.minimumIsAllowed ? "≥" : ">", key.minimum);
  if (std::isfinite(key.maximum)) text += fmt::format("{}≤ {}", text.empty() ? "" : ", ", key.maximum);
  return text;
}

std::string keyTable(const std::vector<Key>& keys) {
  std::string out = "| key | value | range | |\n|---|---|---|---|\n";
  for (const Key& key : keys) {
    std::string help = key.help;
    if (key.required) help += " (required)";
    out += fmt::format("| `{}` | {} | {} | {} |\n", key.name, describe(key), range(key), help);
  }
  return out + "\n";
}

std::string sectionText(const std::string& heading, const Section& section) {
  return "### " + heading + "\n\n" + keyTable(section.keys);
}

// The keys that all of the sections have, in the order of the first one.
std::vector<Key> sharedKeys(const std::vector<Section>& sections) {
  std::vector<Key> shared;
  for (const Key& key : sections.front().keys) {
    const auto has = [&](const Section& section) { return section.find(key.name) != nullptr; };
    if (std::all_of(sections.begin(), sections.end(), has)) shared.push_back(key);
  }
  return shared;
}

std::vector<Key> without(const std::vector<Key>& keys, const std::vector<Key>& shared) {
  std::vector<Key> own;
  for (const Key& key : keys) {
    const auto same = [&](const Key& other) { return other.name == key.name; };
    if (std::none_of(shared.begin(), shared.end(), same)) own.push_back(key);
  }
  return own;
}

std::string materialsText() {
  std::vector<Section> sections;
  for (const project::MaterialForm& form : project::materialForms()) sections.push_back(form.section);
  const std::vector<Key> shared = sharedKeys(sections);
  std::string out = "### A material\n\n" + keyTable(shared);
  for (const project::MaterialForm& form : project::materialForms())
    out += fmt::format("`\"{}\"` also has\n\n{}", form.model, keyTable(without(form.section.keys, shared)));
  return out;
}

std::string objectsText() {
  std::vector<Section> sections;
  std::vector<std::string> names;
  for (const geometry::ObjectType& type : geometry::objectTypes()) {
    sections.push_back(project::objectSection(type));
    names.push_back(type.name);
  }
  std::vector<Key> shared = sharedKeys(sections);
  for (Key& key : shared) {
    if (key.name != "shape") continue;
    key.choices = names;
    key.choices.emplace_back("group");
    key.help = "which of the shapes below";
  }
  std::string out = "### An object\n\n" + keyTable(shared);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const geometry::ObjectType& type = geometry::objectTypes()[i];
    out += fmt::format("`\"{}\"`: {}.", type.name, type.title);
    if (!type.parts.empty()) out += fmt::format(" Parts: `{}`", fmt::join(type.parts, "`, `"));
    for (const auto& [group, parts] : type.partGroups)
      out += fmt::format("; `{}` = `{}`", group, fmt::join(parts, "`, `"));
    out += fmt::format("{}\n\n{}", type.parts.empty() ? "" : ".", keyTable(without(sections[i].keys, shared)));
  }
  return out + "`\"group\"`: objects placed together.\n\n" + keyTable(project::groupSection().keys);
}

std::string openingsText() {
  std::string out = "### A luminaire's `shape`\n\n| form | keys |\n|---|---|\n";
  for (const project::OpeningForm& form : project::openingForms()) {
    std::vector<std::string> keys;
    for (const Key& key : form.section.keys)
      keys.push_back(fmt::format("`{}` ({}{})", key.name, key.help, key.required ? "" : ", optional"));
    out += fmt::format("| `\"{}\"` | {} |\n", form.name, fmt::join(keys, ", "));
  }
  return out + "\n";
}

TEST(Reference, TheKeysOfTheProjectFileAreWrittenFromTheReadersTables) {
  std::string text = sectionText("The project", project::rootSection()) + materialsText() + objectsText();
  text += sectionText("A material's `texture`", project::textureSection());
  text += sectionText("A material's `bump`", project::bumpSection());
  text += sectionText("A step of a `transform`", project::transformStepSection());
  text += sectionText("`rotate`", project::rotationSection());
  text += sectionText("A luminaire", project::luminaireSection());
  text += sectionText("A luminaire's `array`", project::arraySection());
  text += openingsText();
  text += sectionText("A grid", project::gridSection());
  text += sectionText("An observer", project::observerSection());
  text += sectionText("A view", project::viewSection());
  text += sectionText("A lighting scene", project::lightingSceneSection());
  text += sectionText("A requirement", project::requirementSection());
  text += sectionText("A limit of a requirement", project::limitSection());
  text += sectionText("`settings`", project::settingsSection());
  text += sectionText("`settings.accuracy`", project::accuracySection());
  text += sectionText("`settings.spectral`", project::spectralSection());
  text += sectionText("`settings.tree`", project::treeSection());
  text += sectionText("`settings.pixel`", project::pixelSection());
  text.pop_back();
  expectGeneratedBlock(fs::path(GONIOLUX_SOURCE_DIR) / "docs/project-format.md", "the keys", text);
}

TEST(Reference, TheVerbsAreWrittenFromTheHelpOfTheProgram) {
  const std::string commonBegins = "\ncommon options:\n";
  std::string text, common;
  for (const pipeline::Stage& stage : pipeline::stages()) {
    const std::string help = goniolux({stage.name, "--help"}).out;
    const std::size_t at = help.find(commonBegins);
    ASSERT_NE(at, std::string::npos) << help;
    text += "```text\n" + help.substr(0, at) + "```\n\n";
    // The longest list is that of the verbs that read a project; the others have a part of it.
    if (help.size() - at > common.size()) common = help.substr(at + commonBegins.size());
  }
  text += "**Common options.** Those that steer a calculation are for the verbs that read a PROJECT.\n\n```text\n" +
          common + "```\n";
  expectGeneratedBlock(fs::path(GONIOLUX_SOURCE_DIR) / "docs/interface.md", "the verbs", text);
}

}  // namespace
}  // namespace goniolux::test
