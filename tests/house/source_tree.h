// The C++ files below a folder as the rules of the house see them: includes, and code without comments and strings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace goniolux::test {

struct Include {
  int line = 0;
  std::string path;
  bool quoted = false;  ///< "path" rather than <path>
};

struct SourceFile {
  std::string path;                ///< relative to the tree's root, with '/'
  std::vector<std::string> lines;  ///< as they stand
  std::vector<std::string> code;   ///< the same lines, comments and the content of strings blanked
  std::vector<Include> includes;

  [[nodiscard]] bool isHeader() const { return path.ends_with(".h"); }
  /// The first folder of the path: "tracer" of "tracer/visibility.h".
  [[nodiscard]] std::string room() const { return path.substr(0, path.find('/')); }
};

/// All *.h and *.cpp files below `root`, in the order of their paths.
std::vector<SourceFile> readSources(const std::filesystem::path& root);

/// Line numbers (from 1) of the code where `word` stands as a whole word.
std::vector<int> linesWithWord(const SourceFile& file, const std::string& word);

}  // namespace goniolux::test
