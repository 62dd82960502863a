#include "house/source_tree.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "support/temporary_folder.h"

namespace goniolux::test {
namespace {

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Comments and the content of string and character literals become spaces; line breaks stay.
std::string blankCommentsAndStrings(const std::string& text) {
  enum class State { code, lineComment, blockComment, string, character, rawString };
  State state = State::code;
  std::string out, rawEnd;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto ahead = [&](const std::string& expected) { return text.compare(i, expected.size(), expected) == 0; };
    const auto blank = [&](std::size_t count) {
      for (std::size_t k = 0; k < count; ++k) out += text[i + k] == '\n' ? '\n' : ' ';
      i += count - 1;
    };
    switch (state) {
      case State::code:
        if (ahead("//")) {
          state = State::lineComment;
          blank(2);
        } else if (ahead("/*")) {
          state = State::blockComment;
          blank(2);
        } else if (ahead("R\"") && (i == 0 || !isWordCharacter(text[i - 1])) &&
                   text.find('(', i) != std::string::npos) {
          const std::size_t open = text.find('(', i);
          rawEnd = ")" + text.substr(i + 2, open - i - 2) + "\"";
          state = State::rawString;
          blank(open - i + 1);
        } else {
          // A ' between digits separates them and opens nothing.
          const bool separator = c == '\'' && i > 0 && isWordCharacter(text[i - 1]);
          if (c == '"') state = State::string;
          if (c == '\'' && !separator) state = State::character;
          out += c;
        }
        break;
      case State::lineComment:
        if (c == '\n') state = State::code;
        blank(1);
        break;
      case State::blockComment:
        if (ahead("*/")) {
          state = State::code;
          blank(2);
        } else {
          blank(1);
        }
        break;
      case State::string:
      case State::character:
        if (c == '\\' && i + 1 < text.size()) {
          blank(2);
        } else if (c == (state == State::string ? '"' : '\'')) {
          state = State::code;
          out += c;
        } else {
          blank(1);
        }
        break;
      case State::rawString:
        if (ahead(rawEnd)) {
          state = State::code;
          blank(rawEnd.size());
        } else {
          blank(1);
        }
        break;
    }
  }
  return out;
}

std::vector<Include> includesOf(const std::vector<std::string>& lines, const std::vector<std::string>& code) {
  std::vector<Include> includes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t hash = code[i].find_first_not_of(" \t");
    if (hash == std::string::npos || code[i].compare(hash, 8, "#include") != 0) continue;
    const std::size_t open = lines[i].find_first_of("\"<", hash);
    const std::size_t close = open == std::string::npos ? open : lines[i].find_first_of("\">", open + 1);
    if (close == std::string::npos) continue;
    includes.push_back({static_cast<int>(i) + 1, lines[i].substr(open + 1, close - open - 1), lines[i][open] == '"'});
  }
  return includes;
}

}  // namespace

std::vector<SourceFile> readSources(const std::filesystem::path& root) {
  std::vector<SourceFile> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string extension = entry.path().extension().string();
    if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp")) continue;
    SourceFile file;
    file.path = entry.path().lexically_relative(root).generic_string();
    const std::string text = contentOf(entry.path());
    file.lines = split(text);
    file.code = split(blankCommentsAndStrings(text));
    file.includes = includesOf(file.lines, file.code);
    files.push_back(std::move(file));
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

std::vector<int> linesWithWord(const SourceFile& file, const std::string& word) {
  std::vector<int> found;
  for (std::size_t i = 0; i < file.code.size(); ++i) {
    const std::string& line = file.code[i];
    for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      const bool begins = at == 0 || !isWordCharacter(line[at - 1]);
      if (!begins || (end < line.size() && isWordCharacter(line[end]))) continue;
      found.push_back(static_cast<int>(i) + 1);
      break;
    }
  }
  return found;
}

}  // namespace goniolux::test
