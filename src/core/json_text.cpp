#include "core/json_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace goniolux::core {
namespace {

/// Length of the well-formed UTF-8 sequence at `i`, 0 when there is none (Unicode 15, table 3-7).
std::size_t sequenceLength(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U; };
  const auto between = [&](std::size_t k, unsigned low, unsigned high) { return byte(k) >= low && byte(k) <= high; };
  const auto follows = [&](std::size_t k) { return between(k, 0x80, 0xBF); };
  const unsigned first = byte(i);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(i + 1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool second = first == 0xE0   ? between(i + 1, 0xA0, 0xBF)
                        : first == 0xED ? between(i + 1, 0x80, 0x9F)
                                        : follows(i + 1);
    return second && follows(i + 2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool second = first == 0xF0   ? between(i + 1, 0x90, 0xBF)
                        : first == 0xF4 ? between(i + 1, 0x80, 0x8F)
                                        : follows(i + 1);
    return second && follows(i + 2) && follows(i + 3) ? 4 : 0;
  }
  return 0;
}

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

JsonText::JsonText(std::string_view text) : text_(text) {
  lineStarts_.push_back(0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    const bool lineEnd = text_[i] == '\n' || (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'));
    if (lineEnd) lineStarts_.push_back(i + 1);
  }
  checkUtf8();
  if (!problem_) scan();
  if (!problem_ && text_.find_first_not_of(" \t\r\n") == std::string::npos) problem_ = {0, "the file is empty"};
}

void JsonText::checkUtf8() {
  for (std::size_t i = 0; i < text_.size();) {
    const std::size_t length = text_[i] == '\0' ? 0 : sequenceLength(text_, i);
    if (length == 0) {
      problem_ = {i, fmt::format("byte 0x{:02X} is not UTF-8 text; save the file as UTF-8",
                                 static_cast<unsigned>(static_cast<unsigned char>(text_[i])))};
      return;
    }
    i += length;
  }
}

void JsonText::scan() {
  std::size_t lastString = 0;
  bool afterString = false;  // nothing but space and comments since a string
  for (std::size_t i = 0; i < text_.size() && !problem_;) {
    const char c = text_[i];
    if (isSpace(c)) {
      ++i;
    } else if (c == '"') {
      lastString = i;
      scanString(i);
      afterString = true;
    } else if (c == '/') {
      blankComment(i);
    } else {
      if (c == ':' && afterString) keys_.push_back(lastString);
      afterString = false;
      if (c == '{' || c == '[') open_.push_back(i);
      if ((c == '}' || c == ']') && !open_.empty()) open_.pop_back();
      if (open_.size() > static_cast<std::size_t>(deepestNesting)) {
        problem_ = {i, fmt::format("brackets are nested more than {} deep; no file of this program needs that",
                                   deepestNesting)};
      }
      ++i;
    }
  }
}

void JsonText::scanString(std::size_t& i) {
  const std::size_t start = i++;
  while (i < text_.size() && text_[i] != '"' && text_[i] != '\n' && text_[i] != '\r') {
    i += text_[i] == '\\' && i + 1 < text_.size() && text_[i + 1] != '\n' && text_[i + 1] != '\r' ? 2U : 1U;
  }
  if (i >= text_.size() || text_[i] != '"') {
    problem_ = {start, "this string does not end on its line; close it with \" (a line break inside is written \\n)"};
    return;
  }
  ++i;
}

void JsonText::blankComment(std::size_t& i) {
  const std::size_t start = i;
  const char kind = i + 1 < text_.size() ? text_[i + 1] : '\0';
  if (kind == '/') {
    i = std::min(text_.find_first_of("\r\n", i), text_.size());
  } else if (kind == '*') {
    const std::size_t end = text_.find("*/", i + 2);
    if (end == std::string::npos) problem_ = {start, "this comment is never closed; end it with */"};
    i = end == std::string::npos ? text_.size() : end + 2;
  } else {
    problem_ = {start, "a single '/' means nothing here; a comment begins with //"};
    return;
  }
  for (std::size_t k = start; k < i; ++k) {
    if (text_[k] != '\n' && text_[k] != '\r') text_[k] = ' ';
  }
}

SourcePosition JsonText::position(std::size_t offset, const std::string& file) const {
  offset = std::min(offset, text_.size());
  const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
  const std::size_t start = *(next - 1);
  const auto characters = std::count_if(text_.begin() + static_cast<std::ptrdiff_t>(start),
                                        text_.begin() + static_cast<std::ptrdiff_t>(offset),
                                        [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return {file, static_cast<int>(next - lineStarts_.begin()), static_cast<int>(characters) + 1};
}

std::size_t JsonText::offset(std::size_t line, std::size_t column) const {
  const std::size_t start = lineStarts_[std::min(std::max<std::size_t>(line, 1), lineStarts_.size()) - 1];
  return std::min(start + std::max<std::size_t>(column, 1) - 1, text_.size());
}

std::size_t JsonText::keyBefore(std::size_t valueOffset) const {
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), valueOffset);
  return next == keys_.begin() ? valueOffset : *(next - 1);
}

std::string JsonText::explain(const std::string& message, std::size_t offset) const {
  const std::string_view rest = std::string_view(text_).substr(std::min(offset, text_.size()));
  if (rest.find_first_not_of(" \t\r\n") == std::string_view::npos && !open_.empty()) {
    const SourcePosition bracket = position(open_.back(), "");
    return fmt::format("the text ends before the '{}' of line {}, column {} is closed; is the file complete?",
                       text_[open_.back()], bracket.line, bracket.column);
  }
  for (const char* word : {"NaN", "nan", "-NaN", "-nan", "Infinity", "-Infinity", "inf", "-inf"}) {
    if (rest.starts_with(word))
      return fmt::format("{} is not a number that can be calculated with; give a finite value", word);
  }
  if (rest.starts_with("}") || rest.starts_with("]")) {
    std::size_t before = offset;
    while (before > 0 && isSpace(text_[before - 1])) --before;
    if (before > 0 && text_[before - 1] == ',') return "the comma before this bracket has nothing after it; remove it";
  }
  if (message.starts_with("Duplicate key: ")) {
    return fmt::format("the key {} stands twice in this object; keep one of them", message.substr(15));
  }
  if (message.starts_with("Syntax error: value, object or array expected")) {
    return "a value is expected here: a number, a \"string\", true, false, null, [ or {";
  }
  if (message.starts_with("Missing '}' or object member name")) return "a \"key\" or a closing } is expected here";
  if (message.starts_with("Missing ':'")) return "a colon is expected here, after the key";
  if (message.starts_with("Missing ',' or '}'")) return "a comma or a closing } is expected here";
  if (message.starts_with("Missing ',' or ']'")) return "a comma or a closing ] is expected here";
  if (message.starts_with("Extra non-whitespace")) return "something stands after the end of the document; remove it";
  return message;
}

}  // namespace goniolux::core
