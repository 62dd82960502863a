#include "geometry/ply_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace goniolux::geometry {
namespace {

bool isType(const std::string& word) {
  static const std::array<const char*, 16> types{"char",  "uchar",  "short",   "ushort", "int",   "uint",
                                                 "float", "double", "int8",    "uint8",  "int16", "uint16",
                                                 "int32", "uint32", "float32", "float64"};
  return std::find(types.begin(), types.end(), word) != types.end();
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream text(line);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

// What is wrong with a line of the header; "" when nothing is.
std::string complaint(const std::vector<std::string>& words, std::uintmax_t bytes) {
  if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return "";
  if (words[0] == "format") {
    const bool known = words.size() == 3 &&
                       (words[1] == "ascii" || words[1] == "binary_little_endian" || words[1] == "binary_big_endian");
    return known ? "" : "a format is ascii, binary_little_endian or binary_big_endian, and a version";
  }
  if (words[0] == "element") {
    if (words.size() != 3) return "an element has a name and a count";
    char* end = nullptr;
    const double count = std::strtod(words[2].c_str(), &end);
    if (*end != '\0' || !(count >= 0)) return fmt::format("\"{}\" is no count of elements", words[2]);
    if (count > static_cast<double>(bytes))
      return fmt::format("promises {} elements, more than a file of {} bytes can hold", words[2], bytes);
    return "";
  }
  if (words[0] == "property") {
    const bool isList = words.size() == 5 && words[1] == "list" && isType(words[2]) && isType(words[3]);
    return isList || (words.size() == 3 && isType(words[1])) ? "" : "a property has a type that is known, and a name";
  }
  return fmt::format("\"{}\" is no word of a PLY header", words[0]);
}

}  // namespace

void checkPlyHeader(const std::string& path, std::uintmax_t bytes) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  for (int number = 1; number < 1000 && std::getline(file, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (number == 1) {
      if (line != "ply") throw std::invalid_argument(path + ":1: is no PLY file: it does not begin with \"ply\"");
      continue;
    }
    if (line == "end_header") {
      if (file.peek() == std::ifstream::traits_type::eof()) break;
      return;
    }
    if (const std::string wrong = complaint(wordsOf(line), bytes); !wrong.empty())
      throw std::invalid_argument(fmt::format("{}:{}: {}; export it again", path, number, wrong));
  }
  throw std::invalid_argument(path + ": ends within its header; export it again");
}

}  // namespace goniolux::geometry
