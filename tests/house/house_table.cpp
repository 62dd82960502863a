#include "house/house_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/document.h"

namespace goniolux::test {
namespace {

const core::Value& member(const core::Value& object, const char* key) {
  const core::Value* value = object.find(key);
  if (value == nullptr) throw core::InputError(object.position(), "house", fmt::format("'{}' is missing; add it", key));
  return *value;
}

std::vector<std::string> strings(const core::Value& list) {
  std::vector<std::string> out;
  for (const core::Value& value : list.array()) out.push_back(value.string());
  return out;
}

std::vector<Fence> readFences(const core::Value& list, const char* patternKey, bool hasOnly) {
  std::vector<Fence> fences;
  for (const core::Value& entry : list.array()) {
    Fence fence;
    fence.name = member(entry, "name").string();
    fence.patterns = strings(member(entry, patternKey));
    if (hasOnly) fence.only = strings(member(entry, "only"));
    fences.push_back(fence);
  }
  return fences;
}

}  // namespace

int House::floorOf(const std::string& room) const {
  for (std::size_t floor = 0; floor < floors.size(); ++floor)
    for (const Room& candidate : floors[floor])
      if (candidate.name == room) return static_cast<int>(floor);
  return -1;
}

House readHouse(const std::string& file) {
  core::Diagnostics diagnostics;
  const core::Value table = core::parseJson(core::readFile(file), file, diagnostics);
  if (diagnostics.hasErrors()) throw core::InputError(diagnostics);
  House house;
  for (const core::Value& floor : member(table, "floors").array()) {
    std::vector<Room>& rooms = house.floors.emplace_back();
    for (const core::Value& room : floor.array())
      rooms.push_back({member(room, "room").string(), member(room, "holds").string()});
  }
  house.includeFences = readFences(member(table, "fences"), "includes", true);
  house.oneFilePerRoom = readFences(member(table, "one_file_per_room"), "includes", false);
  house.wordFences = readFences(member(table, "words"), "words", true);
  house.forbiddenFolders = strings(member(table, "forbidden_folders"));
  house.longestFile = static_cast<int>(member(table, "longest_file").number());
  return house;
}

std::string drawHouse(const House& house) {
  constexpr std::size_t inside = 64;
  const std::string line = "+" + std::string(inside, '-') + "+\n";
  std::string out = "```text\n" + line;
  for (std::size_t floor = house.floors.size(); floor-- > 0;) {
    const std::vector<Room>& rooms = house.floors[floor];
    std::string row = "|";
    std::size_t used = 0;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      const bool last = i + 1 == rooms.size();
      // The rooms share the floor evenly; the last takes what rounding leaves.
      const std::size_t width = last ? inside - used : inside / rooms.size() - 1;
      row += fmt::format("{:^{}}|", rooms[i].name, width);
      used += width + 1;
    }
    out += fmt::format("{}  floor {}\n{}", row, floor, line);
  }
  out += "```\n\n| floor | room | holds |\n|---|---|---|\n";
  for (std::size_t floor = house.floors.size(); floor-- > 0;)
    for (const Room& room : house.floors[floor])
      out += fmt::format("| {} | `{}/` | {} |\n", floor, room.name, room.holds);
  out += "\n| fence | may stand only in `src/` |\n|---|---|\n";
  for (const std::vector<Fence>* fences : {&house.includeFences, &house.wordFences})
    for (const Fence& fence : *fences) out += fmt::format("| {} | `{}` |\n", fence.name, fmt::join(fence.only, "`, `"));
  for (const Fence& fence : house.oneFilePerRoom) out += fmt::format("| {} | one file of a room |\n", fence.name);
  return out;
}

}  // namespace goniolux::test
