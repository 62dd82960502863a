// The rules of the house. Each returns what breaks it, one line "path:line: what is wrong; what to do" per finding.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "house/house_table.h"
#include "house/source_tree.h"

namespace goniolux::test {

using Findings = std::vector<std::string>;

/// Rooms include their own headers and those of lower floors, by a path from src/ that exists.
Findings brokenFloors(const House& house, const std::vector<SourceFile>& sources);
/// Libraries, printing and exiting stay behind their fences.
Findings brokenFences(const House& house, const std::vector<SourceFile>& sources);
/// No file is longer than the table allows.
Findings longFiles(const House& house, const std::vector<SourceFile>& sources);
/// Every header has #pragma once, and says something itself instead of only including others.
Findings poorHeaders(const std::vector<SourceFile>& sources);
/// No folder is named after having no subject.
Findings poorFolders(const House& house, const std::vector<SourceFile>& sources);
/// No file below these folders of `root` names a path of the machine it was written on.
Findings machinePaths(const std::filesystem::path& root, const std::vector<std::string>& folders);

}  // namespace goniolux::test
