// Embedded data: files of data/ that are compiled into the program (cmake/embed.cmake), as the generated sources
// present them.
#pragma once

#include <span>
#include <string_view>

namespace goniolux::core {

/// A table of numbers, row by row; `name` is the file's name without folder and extension.
struct EmbeddedTable {
  std::string_view name;
  std::span<const std::string_view> columns;
  std::span<const double> values;  ///< columns.size() numbers a row
};

/// A text file as it stands.
struct EmbeddedText {
  std::string_view name, text;
};

}  // namespace goniolux::core
