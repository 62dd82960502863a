#include "documentation/pages.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include "support/temporary_folder.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> linesOf(const fs::path& page) {
  std::vector<std::string> lines;
  std::istringstream stream(contentOf(page));
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> shellWords(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  bool inWord = false;
  char quote = 0;
  for (const char c : line) {
    if (quote != 0) {
      if (c == quote)
        quote = 0;
      else
        word += c;
    } else if (c == '"' || c == '\'') {
      quote = c;
      inWord = true;
    } else if (c == ' ') {
      if (inWord) words.push_back(word);
      word.clear();
      inWord = false;
    } else if (c == '#' && !inWord) {
      return words;
    } else {
      word += c;
      inWord = true;
    }
  }
  if (inWord) words.push_back(word);
  return words;
}

}  // namespace

std::string toString(const Place& place) {
  return place.page.lexically_relative(GONIOLUX_SOURCE_DIR).generic_string() + ":" + std::to_string(place.line);
}

std::vector<fs::path> pages() {
  const fs::path root = GONIOLUX_SOURCE_DIR;
  std::vector<fs::path> list = {root / "README.md", root / "CHANGELOG.md"};
  for (const char* folder : {"docs", "projects"}) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".md") list.push_back(entry.path());
  }
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<Command> commandsOf(const fs::path& page) {
  std::vector<Command> commands;
  bool inShell = false;
  int number = 0;
  for (const std::string& line : linesOf(page)) {
    ++number;
    if (line.starts_with("```")) {
      inShell = line == "```sh";
      continue;
    }
    if (!inShell) continue;
    std::vector<std::string> words = shellWords(line);
    static const std::regex assignment("[A-Z_]+=.*");
    while (!words.empty() && std::regex_match(words.front(), assignment)) words.erase(words.begin());
    if (!words.empty()) commands.push_back({{page, number}, words});
  }
  return commands;
}

std::vector<Link> linksOf(const fs::path& page) {
  static const std::regex pattern(R"(\]\(([^)\s]+)\))");
  std::vector<Link> links;
  bool inCode = false;
  int number = 0;
  for (const std::string& line : linesOf(page)) {
    ++number;
    if (line.starts_with("```")) inCode = !inCode;
    if (inCode) continue;
    for (std::sregex_iterator match(line.begin(), line.end(), pattern), none; match != none; ++match)
      links.push_back({{page, number}, (*match)[1]});
  }
  return links;
}

}  // namespace goniolux::test
