// The repository's own projects: they are read without a complaint, follow the schema, and survive being damaged.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "core/document.h"
#include "project/project.h"
#include "project/schema.h"
#include "sample_projects.h"
#include "support/temporary_folder.h"

namespace goniolux::project {
namespace {

namespace fs = std::filesystem;

core::Value parsed(const fs::path& file) {
  core::Diagnostics diagnostics;
  core::Value value = core::parseJson(core::readFile(file.string()), file.string(), diagnostics);
  EXPECT_FALSE(diagnostics.hasErrors()) << file;
  return value;
}

TEST(SampleProjects, AreReadWithoutErrorsOrWarnings) {
  ASSERT_GE(test::sampleProjects().size(), 11U);
  for (const fs::path& file : test::sampleProjects()) {
    try {
      const Project project = readProject(file.string());
      for (const auto& warning : project.warnings.all()) ADD_FAILURE() << core::toString(warning);
      EXPECT_FALSE(project.grids.empty() && project.views.empty()) << file;
    } catch (const core::InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

/// Enough of JSON Schema to hold the sample projects against ours: $ref, anyOf, type, enum, const, properties,
/// required, additionalProperties, items, minItems, maxItems, minimum, maximum, exclusiveMinimum, exclusiveMaximum.
class SchemaCheck {
 public:
  explicit SchemaCheck(const core::Value& root) : root_(root) {}

  bool accepts(const core::Value& value, const core::Value& schema) {
    if (const auto* reference = schema.find("$ref")) {
      return accepts(value, *root_.find("$defs")->find(reference->string().substr(8)));
    }
    if (const auto* options = schema.find("anyOf")) {
      const auto& list = options->array();
      if (std::none_of(list.begin(), list.end(), [&](const auto& option) { return accepts(value, option); }))
        return false;
    }
    if (const auto* constant = schema.find("const"); constant && core::toJson(*constant) != core::toJson(value))
      return false;
    if (const auto* choices = schema.find("enum")) {
      const auto& list = choices->array();
      if (std::none_of(list.begin(), list.end(), [&](const auto& c) { return core::toJson(c) == core::toJson(value); }))
        return false;
    }
    return isType(value, schema) && (!value.isNumber() || inLimits(value.number(), schema)) &&
           (!value.isArray() || itemsFit(value, schema)) && (!value.isObject() || membersFit(value, schema));
  }

 private:
  static bool isType(const core::Value& value, const core::Value& schema) {
    const auto* type = schema.find("type");
    if (!type) return true;
    const std::string& name = type->string();
    if (name == "integer") return value.isNumber() && value.number() == std::floor(value.number());
    return (name == "number" && value.isNumber()) || (name == "string" && value.isString()) ||
           (name == "boolean" && value.isBoolean()) || (name == "array" && value.isArray()) ||
           (name == "object" && value.isObject()) || (name == "null" && value.isNull());
  }
  static bool inLimits(double number, const core::Value& schema) {
    const auto limit = [&](const char* key, double otherwise) {
      const auto* value = schema.find(key);
      return value ? value->number() : otherwise;
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return number >= limit("minimum", -infinity) && number <= limit("maximum", infinity) &&
           number > limit("exclusiveMinimum", -infinity) && number < limit("exclusiveMaximum", infinity);
  }
  bool itemsFit(const core::Value& value, const core::Value& schema) {
    const auto size = static_cast<double>(value.array().size());
    if (const auto* least = schema.find("minItems"); least && size < least->number()) return false;
    if (const auto* most = schema.find("maxItems"); most && size > most->number()) return false;
    const auto* items = schema.find("items");
    return !items || std::all_of(value.array().begin(), value.array().end(),
                                 [&](const auto& item) { return accepts(item, *items); });
  }
  bool membersFit(const core::Value& value, const core::Value& schema) {
    if (const auto* required = schema.find("required")) {
      for (const auto& key : required->array()) {
        if (!value.find(key.string())) return false;
      }
    }
    const auto* properties = schema.find("properties");
    const auto* others = schema.find("additionalProperties");
    for (const auto& [key, member] : value.object()) {
      const auto* property = properties ? properties->find(key) : nullptr;
      if (property ? !accepts(member, *property) : others && (others->isBoolean() || !accepts(member, *others)))
        return false;
    }
    return true;
  }

  const core::Value& root_;
};

TEST(ProjectSchema, AcceptsTheSampleProjects) {
  const core::Value schema = projectSchema();
  for (const fs::path& file : test::sampleProjects())
    EXPECT_TRUE(SchemaCheck(schema).accepts(parsed(file), schema)) << file;
}

TEST(ProjectSchema, RefusesWhatTheReaderRefuses) {
  const core::Value schema = projectSchema();
  const std::string text =
      core::readFile((fs::path(GONIOLUX_SOURCE_DIR) / "projects/validation/R4/project.json").string());
  const std::vector<std::pair<std::string, std::string>> faults{
      {"\"photometry\"", "\"photometri\""},
      {"\"reflectance\": 0.85", "\"reflectance\": 1.85"},
      {"\"flux\": 3600", "\"flux\": -3600"},
      {"\"lambert\"", "\"lambrt\""},
      {"[30, 20]", "[30]"},
      {"\"version\": 1", "\"version\": 2"},
  };
  for (const auto& [from, to] : faults) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    core::Diagnostics diagnostics;
    const core::Value value = core::parseJson(changed, "x", diagnostics);
    EXPECT_FALSE(SchemaCheck(schema).accepts(value, schema)) << to;
    const test::TemporaryFolder folder;
    folder.write("project.json", changed);
    EXPECT_THROW(readProject(folder.path().string()), core::InputError) << to;
  }
}

/// Damage, a little at a time, that files meet in life: cut short, a piece lost, a byte changed, a piece doubled.
std::string damaged(const std::string& text, std::mt19937& random) {
  std::string result = text;
  const auto below = [&](std::size_t limit) { return random() % std::max<std::size_t>(limit, 1); };
  static const std::string replacements = "0123456789-+.eE\"'{}[],: \n\t/\\*xNtfn\xC3\x80";
  const std::size_t at = below(result.size());
  switch (below(6)) {
    case 0:
      result.resize(at);
      break;
    case 1:
      result.erase(at, 1 + below(40));
      break;
    case 2:
      result[at] = replacements[below(replacements.size())];
      break;
    case 3:
      result[at] = static_cast<char>(below(256));
      break;
    case 4:
      result.insert(at, result.substr(below(result.size()), 1 + below(60)));
      break;
    default: {  // a number becomes another
      const std::size_t digit = result.find_first_of("0123456789", at);
      static const std::vector<std::string> numbers{"-1",          "0",   "1e308", "-1e308", "1e-320",
                                                    "99999999999", "0.5", "1e7",   "null",   "\"\""};
      if (digit != std::string::npos) result.replace(digit, 1, numbers[below(numbers.size())]);
    }
  }
  return result;
}

TEST(SampleProjects, DamagedFilesAreRefusedOrReadButNeverCrash) {
  const fs::path source = GONIOLUX_SOURCE_DIR;
  std::mt19937 random(20240607);
  int refused = 0, accepted = 0;
  for (const char* name : {"small-office", "gallery", "corridor-fluorescent", "validation/R2", "validation/cube"}) {
    const std::string text = core::readFile((source / "projects" / name / "project.json").string());
    const test::TemporaryFolder folder;
    for (int i = 0; i < 500; ++i) {
      folder.write("project.json", damaged(text, random));
      try {
        const Project project = readProject(folder.path().string());
        for (const auto& grid : project.grids) {
          for (const auto& point : grid.points) ASSERT_TRUE(std::isfinite(point.x + point.y + point.z));
        }
        ++accepted;
      } catch (const core::InputError& error) {
        ++refused;
        ASSERT_TRUE(error.diagnostics().hasErrors());
        for (const auto& diagnostic : error.diagnostics().all()) ASSERT_FALSE(diagnostic.message.empty());
      }
    }
  }
  // Damage inside names and comments is harmless; most is not.
  EXPECT_GT(refused, 1000);
  EXPECT_GT(accepted, 50);
}

}  // namespace
}  // namespace goniolux::project
