// The folder of shared validation material (reference grids, a corpus of real photometric files), which is not part of
// the repository. Tests that use it look for it here and skip, with a sentence, where it is absent:
//
//   const auto shared = goniolux::test::sharedFolder();
//   if (!shared) GTEST_SKIP() << goniolux::test::sharedFolderIsAbsent;
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace goniolux::test {

inline constexpr const char* sharedFolderIsAbsent =
    "the folder of shared validation material is absent: set GONIOLUX_SHARED, or put it beside the source tree as "
    "'shared'";

/// GONIOLUX_SHARED if that names a folder with validation material, else the folder `shared` beside the source tree,
/// else nothing.
inline std::optional<std::filesystem::path> sharedFolder() {
  if (const char* named = std::getenv("GONIOLUX_SHARED"); named != nullptr && *named != '\0') {
    const std::filesystem::path folder = named;
    return std::filesystem::is_directory(folder / "validation") ? std::optional(folder) : std::nullopt;
  }
  const std::filesystem::path beside = std::filesystem::path(GONIOLUX_SOURCE_DIR).parent_path() / "shared";
  return std::filesystem::is_directory(beside / "validation") ? std::optional(beside) : std::nullopt;
}

}  // namespace goniolux::test
