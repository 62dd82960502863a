// Text: reading old text files as they are: line ends CRLF, LF or CR, a ctrl-Z as the end, several encodings, and
// numbers and words that know their line and column. Lines and columns count from 1; a column counts bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/diagnostics.h"

namespace goniolux::core {

enum class Encoding { ascii, utf8, utf16, shiftJis, latin1 };
std::string_view encodingName(Encoding encoding);

/// What the bytes look like: UTF-16 by its mark or its zero bytes, UTF-8 when valid, Shift-JIS when every byte pair is
/// one of that code and one pair lies where Latin-1 has only control codes, else Latin-1.
Encoding detectEncoding(std::string_view bytes);

/// The text as UTF-8, without a byte-order mark. Bytes that mean nothing in the encoding become '?'.
std::string toUtf8(std::string_view bytes, Encoding from);

/// The text without blanks, tabs and line ends at both ends.
std::string_view trimmed(std::string_view text);
/// ASCII letters in lower (upper) case; other bytes unchanged.
std::string lowerCase(std::string_view text);
std::string upperCase(std::string_view text);

/// The number that the whole text is: sign, digits, a point, an exponent e, E, d or D with any number of digits; also
/// "nan" and "inf", which callers refuse. Empty when the text is anything else or too large for a double.
std::optional<double> parseNumber(std::string_view text);

/// A piece of the text and where it stands.
struct TextPiece {
  std::string_view text;
  int line = 0, column = 0;
};

/// Walks through a text by words or by lines. Keeps a view: the text must outlive it.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text);

  /// Nothing but blanks and line ends is left.
  [[nodiscard]] bool atEnd() const;
  [[nodiscard]] std::size_t bytesLeft() const { return text_.size() - at_; }
  [[nodiscard]] int lineNumber() const { return line_; }

  /// The rest of the present line without its end; moves to the next line. Empty at the end of the text.
  std::optional<TextPiece> line();
  /// The next word; words are parted by blanks, tabs, line ends and the characters of `separators`. Empty at the end of
  /// the text.
  std::optional<TextPiece> word(std::string_view separators);

 private:
  [[nodiscard]] static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v' || c == '\0'; }
  void passLineEnd();

  std::string_view text_;
  std::size_t at_ = 0, lineStart_ = 0;
  int line_ = 1;
};

}  // namespace goniolux::core
