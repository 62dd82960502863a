// The house as data: docs/developer/house.json.
#pragma once

#include <string>
#include <vector>

namespace goniolux::test {

struct Room {
  std::string name, holds;
};

struct Fence {
  std::string name;
  std::vector<std::string> patterns;  ///< beginnings of includes, or words
  std::vector<std::string> only;      ///< files, or folders that end in '/', below src/
};

struct House {
  std::vector<std::vector<Room>> floors;  ///< ground first
  std::vector<Fence> includeFences, oneFilePerRoom, wordFences;
  std::vector<std::string> forbiddenFolders;
  int longestFile = 0;

  /// The floor's number, counted from 0; -1 for a name that is no room.
  [[nodiscard]] int floorOf(const std::string& room) const;
};

/// Reads the table; throws core::InputError when it is no table.
House readHouse(const std::string& file);

/// The picture: floors from the roof down, rooms side by side, in a fenced text block of Markdown.
std::string drawHouse(const House& house);

}  // namespace goniolux::test
