#include "pipeline/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "core/document.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* outcomeFileName = "outcome.json";

void collect(const fs::path& folder, std::set<std::string>& found) {
  std::error_code error;
  fs::recursive_directory_iterator entries(folder, fs::directory_options::skip_permission_denied, error), end;
  if (error)
    throw core::InputError({folder.string(), 0, 0}, "unreadable-folder",
                           "this folder cannot be read: " + error.message());
  for (; entries != end; entries.increment(error)) {
    if (error) break;
    const fs::path& path = entries->path();
    std::error_code ignored;
    if (entries->is_directory(ignored) && (path.filename() == "results" || fs::exists(path / "verify.json", ignored)))
      entries.disable_recursion_pending();
    else if (path.filename() == "project.json")
      found.insert(path.parent_path().string());
  }
}

}  // namespace

const char* wordFor(BatchProject::Verdict verdict) {
  switch (verdict) {
    case BatchProject::Verdict::passed:
      return "pass";
    case BatchProject::Verdict::changed:
      return "fail";
    case BatchProject::Verdict::broken:
      return "error";
    case BatchProject::Verdict::noBaseline:
      return "no-baseline";
    case BatchProject::Verdict::notRun:
      break;
  }
  return "not-run";
}

std::vector<std::string> findProjects(const std::vector<std::string>& inputs) {
  std::set<std::string> found;
  for (const std::string& input : inputs) {
    std::error_code ignored;
    if (fs::is_directory(input, ignored)) {
      fs::path folder = fs::path(input).lexically_normal();
      if (!folder.has_filename() && folder.has_parent_path()) folder = folder.parent_path();
      collect(folder, found);
    } else if (fs::is_regular_file(input, ignored)) {
      const fs::path parent = fs::path(input).parent_path();
      found.insert(parent.empty() ? "." : parent.lexically_normal().string());
    } else {
      throw core::InputError({input, 0, 0}, "missing-file",
                             "there is no such folder; give folders with projects in them");
    }
  }
  if (found.empty())
    throw core::InputError({inputs.front(), 0, 0}, "no-projects",
                           "there is no project.json here or in the folders below; give a folder with projects");
  return {found.begin(), found.end()};
}

std::optional<Outcome> readOutcome(const std::string& folder) {
  const std::string file = (fs::path(folder) / outcomeFileName).string();
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  core::Diagnostics diagnostics;
  const core::Value json = core::parseJson(core::readFile(file), file, diagnostics);
  const core::Value* key = json.find("key");
  const core::Value* seconds = json.find("seconds");
  if (diagnostics.hasErrors() || !key || !key->isString() || !seconds || !seconds->isNumber()) return std::nullopt;
  return Outcome{key->string(), seconds->number()};
}

void writeOutcome(const std::string& folder, const Outcome& outcome) {
  core::Value json;
  json.set("key", outcome.key);
  json.set("seconds", outcome.seconds);
  core::writeFile((fs::path(folder) / outcomeFileName).string(), core::toJson(json));
}

void forgetOutcome(const std::string& folder) {
  std::error_code ignored;
  fs::remove(fs::path(folder) / outcomeFileName, ignored);
}

Shard shardFrom(const std::string& text) {
  Shard shard{0, 0};
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    std::from_chars(text.data(), text.data() + slash, shard.index);
    std::from_chars(text.data() + slash + 1, text.data() + text.size(), shard.count);
  }
  if (shard.index < 1 || shard.count < 1 || shard.index > shard.count ||
      text != fmt::format("{}/{}", shard.index, shard.count))
    throw core::InputError({}, "bad-option",
                           fmt::format("--shard \"{}\": write I/N, part I of N, e.g. --shard 2/5", text));
  return shard;
}

}  // namespace goniolux::pipeline
