#include "geometry/ply_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/document.h"

namespace goniolux::geometry {
namespace {

bool isType(const std::string& word) {
  static const std::array<const char*, 16> types{"char",  "uchar",  "short",   "ushort", "int",   "uint",
                                                 "float", "double", "int8",    "uint8",  "int16", "uint16",
                                                 "int32", "uint32", "float32", "float64"};
  return std::find(types.begin(), types.end(), word) != types.end();
}

class Check {
 public:
  explicit Check(const std::string& path) : path_(path), bytes_(core::readFile(path)) {}

  void run() {
    header();
    if (isText_) lists();
  }

 private:
  struct Element {
    double count = 0;
    std::vector<bool> isList;  ///< of its properties
  };

  [[noreturn]] void refuse(const std::string& why) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}; export it again", path_, line_, why));
  }

  void header() {
    while (at_ < bytes_.size() && line_ < 1000) {
      const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
      std::string line = bytes_.substr(at_, end - at_);
      at_ = end + 1;
      ++line_;
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line_ == 1 && line != "ply") refuse("is no PLY file: it does not begin with \"ply\"");
      if (line == "end_header" && at_ < bytes_.size()) return;
      std::istringstream text(line);
      std::vector<std::string> words;
      for (std::string word; text >> word;) words.push_back(word);
      if (line_ > 1 && line != "end_header") take(words);
    }
    throw std::invalid_argument(path_ + ": ends within its header; export it again");
  }

  void take(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return;
    if (words[0] == "format") {
      if (words.size() != 3 ||
          (words[1] != "ascii" && words[1] != "binary_little_endian" && words[1] != "binary_big_endian"))
        refuse("a format is ascii, binary_little_endian or binary_big_endian, and a version");
      isText_ = words[1] == "ascii";
    } else if (words[0] == "element") {
      // The importer takes a number in the place of a name that it does not know for the count.
      if (words.size() != 3 || std::isalpha(static_cast<unsigned char>(words[1][0])) == 0)
        refuse("an element has a name, which begins with a letter, and a count");
      char* end = nullptr;
      const double count = std::strtod(words[2].c_str(), &end);
      if (*end != '\0' || !(count >= 0)) refuse(fmt::format("\"{}\" is no count of elements", words[2]));
      if (count > static_cast<double>(bytes_.size()))
        refuse(fmt::format("promises {} elements, more than a file of {} bytes can hold", words[2], bytes_.size()));
      elements_.push_back({count, {}});
    } else if (words[0] == "property") {
      const bool isList = words.size() == 5 && words[1] == "list" && isType(words[2]) && isType(words[3]);
      if (!isList && !(words.size() == 3 && isType(words[1])))
        refuse("a property has a type that is known, and a name");
      if (elements_.empty()) refuse("a property belongs to an element");
      elements_.back().isList.push_back(isList);
    } else {
      refuse(fmt::format("\"{}\" is no word of a PLY header", words[0]));
    }
  }

  // Every list of a text file has as many members as it says.
  void lists() {
    for (const Element& element : elements_)
      for (double i = 0; i < element.count; ++i)
        for (const bool isList : element.isList) {
          const std::string_view word = nextWord();
          if (!isList) continue;
          char* end = nullptr;
          const std::string text(word);
          const double members = std::strtod(text.c_str(), &end);
          if (*end != '\0' || !(members >= 0 && members <= static_cast<double>(bytes_.size() - at_)))
            refuse(fmt::format("\"{}\" is no number of corners that the file could hold", text));
          for (double k = 0; k < members; ++k) (void)nextWord();
        }
  }

  std::string_view nextWord() {
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    for (; at_ < bytes_.size() && isBlank(bytes_[at_]); ++at_) line_ += bytes_[at_] == '\n' ? 1 : 0;
    const std::size_t from = at_;
    while (at_ < bytes_.size() && !isBlank(bytes_[at_])) ++at_;
    if (from == at_) refuse("the file ends before its elements do");
    return std::string_view(bytes_).substr(from, at_ - from);
  }

  std::string path_, bytes_;
  std::size_t at_ = 0;
  int line_ = 0;
  bool isText_ = false;
  std::vector<Element> elements_;
};

}  // namespace

void checkPly(const std::string& path) {
  Check(path).run();
}

}  // namespace goniolux::geometry
