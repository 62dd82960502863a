#include "house/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "support/temporary_folder.h"

namespace goniolux::test {
namespace {

bool isInside(const std::string& path, const std::vector<std::string>& places) {
  return std::any_of(places.begin(), places.end(), [&](const std::string& place) {
    return place.ends_with('/') ? path.starts_with(place) : path == place;
  });
}

// "vtk" is the beginning of an include's path, "=thread" the whole of it; "Q" is Qt's: a Q and another capital.
bool matches(const Include& include, const std::string& pattern) {
  if (pattern.starts_with('=')) return include.path == pattern.substr(1);
  if (pattern == "Q")
    return include.path.size() > 1 && include.path[0] == 'Q' && include.path[1] >= 'A' && include.path[1] <= 'Z';
  return include.path.starts_with(pattern);
}

bool matchesAny(const Include& include, const Fence& fence) {
  return !include.quoted && std::any_of(fence.patterns.begin(), fence.patterns.end(),
                                        [&](const std::string& pattern) { return matches(include, pattern); });
}

}  // namespace

Findings brokenFloors(const House& house, const std::vector<SourceFile>& sources) {
  std::set<std::string> paths;
  for (const SourceFile& file : sources) paths.insert(file.path);
  Findings findings;
  for (const SourceFile& file : sources) {
    const int floor = house.floorOf(file.room());
    if (floor < 0) {
      findings.push_back(fmt::format("src/{}:1: the room '{}' is not in the table of the house; add it to its floor",
                                     file.path, file.room()));
      continue;
    }
    for (const Include& include : file.includes) {
      if (!include.quoted) continue;
      if (!paths.contains(include.path)) {
        findings.push_back(fmt::format("src/{}:{}: there is no src/{}; write the path from src/", file.path,
                                       include.line, include.path));
        continue;
      }
      const std::string room = include.path.substr(0, include.path.find('/'));
      if (room != file.room() && house.floorOf(room) >= floor)
        findings.push_back(fmt::format("src/{}:{}: '{}' (floor {}) must not include '{}' (floor {}); only lower floors",
                                       file.path, include.line, file.room(), floor, include.path, house.floorOf(room)));
    }
  }
  return findings;
}

Findings brokenFences(const House& house, const std::vector<SourceFile>& sources) {
  Findings findings;
  std::map<std::pair<std::string, std::string>, std::string> oneFile;  // (fence, room) -> the file that has it
  for (const SourceFile& file : sources) {
    for (const Include& include : file.includes) {
      for (const Fence& fence : house.includeFences)
        if (matchesAny(include, fence) && !isInside(file.path, fence.only))
          findings.push_back(fmt::format("src/{}:{}: {} (<{}>) belongs in {} only", file.path, include.line, fence.name,
                                         include.path, fmt::join(fence.only, ", ")));
      for (const Fence& fence : house.oneFilePerRoom) {
        if (!matchesAny(include, fence)) continue;
        const auto [first, isNew] = oneFile.try_emplace({fence.name, file.room()}, file.path);
        if (!isNew && first->second != file.path)
          findings.push_back(fmt::format("src/{}:{}: {} is in src/{} already; one file of a room has it", file.path,
                                         include.line, fence.name, first->second));
      }
    }
    for (const Fence& fence : house.wordFences) {
      if (isInside(file.path, fence.only)) continue;
      for (const std::string& word : fence.patterns)
        for (const int line : linesWithWord(file, word))
          findings.push_back(fmt::format("src/{}:{}: {} ('{}') belongs in {} only; return a report or throw", file.path,
                                         line, fence.name, word, fmt::join(fence.only, ", ")));
    }
  }
  return findings;
}

Findings longFiles(const House& house, const std::vector<SourceFile>& sources) {
  Findings findings;
  for (const SourceFile& file : sources)
    if (static_cast<int>(file.lines.size()) > house.longestFile)
      findings.push_back(fmt::format("{}:{}: {} lines; over {} a file usually holds two ideas: part them", file.path,
                                     house.longestFile + 1, file.lines.size(), house.longestFile));
  return findings;
}

Findings poorHeaders(const std::vector<SourceFile>& sources) {
  Findings findings;
  for (const SourceFile& file : sources) {
    if (!file.isHeader()) continue;
    bool once = false, saysSomething = false;
    for (const std::string& line : file.code) {
      const std::size_t begin = line.find_first_not_of(" \t\r");
      if (begin == std::string::npos) continue;
      if (line.compare(begin, 12, "#pragma once") == 0)
        once = true;
      else if (line.compare(begin, 8, "#include") != 0)
        saysSomething = true;
    }
    if (!once) findings.push_back(file.path + ":1: #pragma once is missing; add it below the opening comment");
    if (!saysSomething)
      findings.push_back(file.path + ":1: this header only includes others; include those where they are used");
  }
  return findings;
}

Findings poorFolders(const House& house, const std::vector<SourceFile>& sources) {
  std::set<std::string> findings;
  for (const SourceFile& file : sources)
    for (const std::string& folder : house.forbiddenFolders)
      if (("/" + file.path).find("/" + folder + "/") != std::string::npos)
        findings.insert(
            fmt::format("{}:1: a folder '{}' has no subject; put its content where it belongs", file.path, folder));
  return {findings.begin(), findings.end()};
}

Findings machinePaths(const std::filesystem::path& root, const std::vector<std::string>& folders) {
  // Put together here, so that this file does not name them.
  static const std::vector<std::string> prefixes = {std::string("/") + "root/", std::string("/") + "home/",
                                                    std::string("/") + "work/"};
  Findings findings;
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file()) continue;
      const std::string text = contentOf(entry.path());
      for (const std::string& prefix : prefixes) {
        const std::size_t at = text.find(prefix);
        if (at == std::string::npos) continue;
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        findings.push_back(fmt::format("{}:{}: '{}' is a path of one machine; name a place in the repository",
                                       entry.path().lexically_relative(root).generic_string(), line, prefix));
      }
    }
  }
  return findings;
}

}  // namespace goniolux::test
