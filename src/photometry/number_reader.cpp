#include "photometry/number_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace goniolux::photometry {
namespace {

// What a message shows of the file: printable, and short.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result;
  for (const char c : text.substr(0, longest)) result += c >= 0x20 && c < 0x7F ? c : '?';
  return text.size() > longest ? result + "..." : result;
}

}  // namespace

std::optional<double> parseNumber(std::string_view text, DecimalComma comma) {
  if (comma == DecimalComma::isSeparator) return core::parseNumber(text);
  std::string pointed(text);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  return core::parseNumber(pointed);
}

void NumberReader::refuse(const std::string& rule, const std::string& message) const {
  throw core::InputError(position_, rule, message);
}

double NumberReader::read(std::string_view what, std::size_t index, std::size_t of) {
  const auto named = [&] { return of > 0 ? fmt::format("{}, number {} of {}", what, index, of) : std::string(what); };
  const auto word = scanner_.word(comma_ == DecimalComma::isSeparator ? "," : "");
  if (!word) {
    position_ = {file_, scanner_.lineNumber(), 0};
    refuse("file-ends-early",
           fmt::format("the file ends before {}; numbers are missing, or a count is too large", named()));
  }
  position_ = {file_, word->line, word->column};
  const auto value = parseNumber(word->text, comma_);
  if (!value) {
    refuse("not-a-number",
           fmt::format("{}: '{}' is not a number; remove the text or supply the number", named(), shown(word->text)));
  }
  if (!std::isfinite(*value)) {
    refuse("not-finite", fmt::format("{}: '{}' is not a finite number", named(), shown(word->text)));
  }
  return *value;
}

int NumberReader::count(std::string_view what, int minimum, int maximum) {
  const double value = number(what);
  if (value != std::floor(value) || value < minimum || value > maximum) {
    refuse("bad-count",
           fmt::format("{} is {}; it must be a whole number from {} to {}", what, value, minimum, maximum));
  }
  return static_cast<int>(value);
}

std::vector<double> NumberReader::numbers(std::size_t count, std::string_view what, ListOf kind,
                                          core::SourcePosition* begin) {
  std::vector<double> values;
  values.reserve(std::min(count, scanner_.bytesLeft() / 2 + 1));  // never more than the file can hold
  for (std::size_t i = 0; i < count; ++i) {
    const double value = read(what, i + 1, count);
    if (i == 0 && begin != nullptr) *begin = position_;
    if (kind == ListOf::ascendingAngles && i > 0 && !(value > values.back())) {
      refuse("angles-not-ascending",
             fmt::format("{}: {} follows {}; they must ascend without repeats. Is the number of angles right?", what,
                         value, values.back()));
    }
    if (kind == ListOf::intensities && value < 0) {
      refuse("negative-candela",
             fmt::format("{}, number {} of {}: {} is below 0, which no intensity can be; correct it", what, i + 1,
                         count, value));
    }
    values.push_back(value);
  }
  return values;
}

void NumberReader::expectRoomFor(std::size_t numbers, std::string_view what) {
  if (numbers <= scanner_.bytesLeft() / 2 + 1) return;
  refuse("file-ends-early", fmt::format("the file declares {} numbers ({}), but only {} bytes follow; check the counts",
                                        numbers, what, scanner_.bytesLeft()));
}

}  // namespace goniolux::photometry
