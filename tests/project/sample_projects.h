// The project files that stand in the repository.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace goniolux::test {

/// Every project.json below projects/, in the order of their paths; results folders hold none.
inline std::vector<std::filesystem::path> sampleProjects() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(GONIOLUX_SOURCE_DIR) / "projects")) {
    if (entry.path().filename() == "project.json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace goniolux::test
