// NumberReader: the numbers of a photometric file in their order, each asked for by name, so that a message can say
// which number is missing or wrong, and where. Every failure is an InputError with line and column.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"
#include "core/text.h"

namespace goniolux::photometry {

enum class DecimalComma { isSeparator, isPoint };

/// What each number of a list has to be; said where it is read, because only there its line and column are known.
enum class ListOf { anything, ascendingAngles, intensities };

class NumberReader {
 public:
  NumberReader(core::TextScanner& scanner, std::string file, DecimalComma comma)
      : scanner_(scanner), file_(std::move(file)), comma_(comma), position_{file_, scanner.lineNumber(), 0} {}

  /// The next number, finite. `what` names it in messages: "input watts".
  double number(std::string_view what) { return read(what, 0, 0); }
  /// The next number if it is whole and within [minimum, maximum].
  int count(std::string_view what, int minimum, int maximum);
  /// The next `count` numbers; `begin`, if given, becomes the position of the first.
  std::vector<double> numbers(std::size_t count, std::string_view what, ListOf kind,
                              core::SourcePosition* begin = nullptr);
  /// Refuses a table that the rest of the file cannot hold (a number needs two bytes), before memory is asked for it.
  void expectRoomFor(std::size_t numbers, std::string_view what);

  /// Where the last number stood.
  [[nodiscard]] core::SourcePosition position() const { return position_; }
  /// Throws an InputError at the last number.
  [[noreturn]] void refuse(const std::string& rule, const std::string& message) const;

 private:
  /// `of` > 0: the number is one of several.
  double read(std::string_view what, std::size_t index, std::size_t of);

  core::TextScanner& scanner_;
  std::string file_;
  DecimalComma comma_;
  core::SourcePosition position_;
};

/// A number in which a comma may stand for the point.
std::optional<double> parseNumber(std::string_view text, DecimalComma comma);

}  // namespace goniolux::photometry
