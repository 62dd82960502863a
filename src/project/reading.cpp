#include "project/reading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "core/sha256.h"

namespace goniolux::project {
namespace fs = std::filesystem;

std::vector<fs::path> programDataFolders() {
  std::vector<fs::path> folders;
  if (const char* named = std::getenv("GONIOLUX_DATA"); named && *named) folders.emplace_back(named);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) folders.push_back(program.parent_path().parent_path() / "share" / "goniolux");
  folders.emplace_back(GONIOLUX_SOURCE_DIR);
  return folders;
}

void Reading::addInput(const std::string& name, const std::string& bytes) {
  const bool known =
      std::any_of(inputs_.begin(), inputs_.end(), [&](const InputFile& file) { return file.path == name; });
  if (!known) inputs_.push_back({name, core::sha256(bytes)});
}

std::optional<std::string> Reading::file(const core::Value& name, Library library, const std::string& hint) {
  if (!name.isString() || name.string().empty()) {
    error(name, "wrong-type", "a file name is expected here");
    return std::nullopt;
  }
  const fs::path written = name.string();
  std::vector<fs::path> candidates{folder_ / written};
  if (written.is_relative() && library != Library::none) {
    const char* room = library == Library::luminaires ? "luminaires" : "materials";
    for (const fs::path& folder : programDataFolders()) {
      // The name "luminaires/panel.ies" means the same file as "panel.ies".
      const bool namesRoom = *written.begin() == room;
      candidates.push_back(namesRoom ? folder / written : folder / room / written);
    }
  }
  for (const fs::path& candidate : candidates) {
    std::error_code ignored;
    if (!fs::is_regular_file(candidate, ignored)) continue;
    try {
      addInput(name.string(), core::readFile(candidate.string()));
      return candidate.lexically_normal().string();
    } catch (const core::InputError& unreadable) {
      adopt(unreadable);
      return std::nullopt;
    }
  }
  std::vector<std::string> searched;
  for (const fs::path& candidate : candidates) {
    std::error_code ignored;
    const fs::path folder = candidate.lexically_normal().parent_path();
    // The program's folders are many where it is not installed: those that exist are what a reader can act on.
    if (candidate != candidates.front() && !fs::is_directory(folder, ignored)) continue;
    const std::string text = folder.empty() ? "." : folder.string();
    if (std::find(searched.begin(), searched.end(), text) == searched.end()) searched.push_back(text);
  }
  error(name, "missing-file",
        fmt::format("there is no file '{}'; looked in {}{}", name.string(), fmt::join(searched, ", then "), hint));
  return std::nullopt;
}

const photometry::PhotometricFile* Reading::photometricFile(const std::string& path) {
  const auto known = photometry_.find(path);
  if (known != photometry_.end()) return known->second ? &*known->second : nullptr;
  auto& entry = photometry_[path];
  try {
    entry = photometry::readPhotometricFile(path);
    diagnostics.append(entry->warnings);
  } catch (const core::InputError& unreadable) {
    adopt(unreadable);
  }
  return entry ? &*entry : nullptr;
}

}  // namespace goniolux::project
