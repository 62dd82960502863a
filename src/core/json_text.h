// JsonText: where things stand in a JSON text, found in one pass before the JSON library reads it: lines, keys,
// nesting, and the mistakes that the library either lets pass or reports far from their cause (open strings, bytes that
// are not UTF-8).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"

namespace goniolux::core {

class JsonText {
 public:
  /// Deeper nesting is refused: no file of ours comes near, and a parser's stack is finite.
  static constexpr int deepestNesting = 200;

  struct Problem {
    std::size_t offset;
    std::string message;
  };

  explicit JsonText(std::string_view text);

  [[nodiscard]] const std::optional<Problem>& problem() const { return problem_; }
  /// Line and column of a byte offset, both from 1; columns count characters (UTF-8 code points), as editors do.
  [[nodiscard]] SourcePosition position(std::size_t offset, const std::string& file) const;
  /// Byte offset of a line and a column in bytes, both from 1.
  [[nodiscard]] std::size_t offset(std::size_t line, std::size_t column) const;
  /// Offset of the key whose value begins at `valueOffset`.
  [[nodiscard]] std::size_t keyBefore(std::size_t valueOffset) const;
  /// The text with comments turned into blanks, so that offsets stay the same.
  [[nodiscard]] const std::string& withoutComments() const { return text_; }
  /// The library's message about a syntax error at `offset`, in words that say what to do.
  [[nodiscard]] std::string explain(const std::string& message, std::size_t offset) const;

 private:
  void scan();
  void scanString(std::size_t& i);
  void blankComment(std::size_t& i);
  void checkUtf8();

  std::string text_;
  std::vector<std::size_t> lineStarts_;
  std::vector<std::size_t> keys_;  // offsets of the opening quotes of keys, ascending
  std::vector<std::size_t> open_;  // brackets never closed
  std::optional<Problem> problem_;
};

}  // namespace goniolux::core
