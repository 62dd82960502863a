#include "core/text.h"

#include <iconv.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>

namespace goniolux::core {
namespace {

unsigned char byteAt(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

// RFC 3629; over-long forms and surrogates count as invalid.
bool isUtf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const unsigned char lead = byteAt(bytes, i);
    std::size_t length = 0;
    if (lead < 0x80)
      length = 1;
    else if (lead >= 0xC2 && lead <= 0xDF)
      length = 2;
    else if (lead >= 0xE0 && lead <= 0xEF)
      length = 3;
    else if (lead >= 0xF0 && lead <= 0xF4)
      length = 4;
    if (length == 0 || i + length > bytes.size()) return false;
    for (std::size_t j = 1; j < length; ++j) {
      if ((byteAt(bytes, i + j) & 0xC0) != 0x80) return false;
    }
    if (length > 2) {
      const unsigned char second = byteAt(bytes, i + 1);
      if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F)) return false;
      if ((lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F)) return false;
    }
    i += length;
  }
  return true;
}

// JIS X 0208 in Shift-JIS: half-width katakana A1..DF, pairs led by 81..9F or E0..FC. Latin-1 text has no bytes 80..9F.
bool isShiftJis(std::string_view bytes) {
  bool sawLowLead = false;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const unsigned char lead = byteAt(bytes, i);
    if (lead < 0x80 || (lead >= 0xA1 && lead <= 0xDF)) continue;
    const bool isLead = (lead >= 0x81 && lead <= 0x9F) || (lead >= 0xE0 && lead <= 0xFC);
    if (!isLead || ++i >= bytes.size()) return false;
    const unsigned char trail = byteAt(bytes, i);
    if (trail < 0x40 || trail == 0x7F || trail > 0xFC) return false;
    sawLowLead = sawLowLead || lead <= 0x9F;
  }
  return sawLowLead;
}

// Characters 80..9F as Windows-1252 has them, which is what files called Latin-1 mean; 0 where it has none.
constexpr std::uint16_t windows1252[32] = {0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                           0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                           0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                           0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

std::string latin1ToUtf8(std::string_view bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const unsigned char byte = byteAt(bytes, i);
    std::uint32_t code = byte;
    if (byte >= 0x80 && byte <= 0x9F) code = windows1252[byte - 0x80] != 0 ? windows1252[byte - 0x80] : '?';
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xC0 | (code >> 6));
      text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
      text += static_cast<char>(0xE0 | (code >> 12));
      text += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return text;
}

// The C library's converter; what it cannot convert becomes '?'.
std::string convertToUtf8(std::string_view bytes, const char* from) {
  const iconv_t converter = iconv_open("UTF-8", from);
  if (converter == iconv_t(-1)) return latin1ToUtf8(bytes);  // a system without this code's table
  std::string input(bytes), text;
  char* in = input.data();
  std::size_t inLeft = input.size();
  char buffer[4096];
  while (inLeft > 0) {
    char* out = buffer;
    std::size_t outLeft = sizeof buffer;
    const std::size_t before = inLeft;
    const bool failed = iconv(converter, &in, &inLeft, &out, &outLeft) == std::size_t(-1);
    text.append(buffer, sizeof buffer - outLeft);
    if (failed && inLeft == before && outLeft == sizeof buffer) {  // stuck at a byte that means nothing
      text += '?';
      ++in;
      --inLeft;
    }
  }
  iconv_close(converter);
  return text;
}

std::string mapped(std::string_view text, char from, char to, int shift) {
  std::string result(text);
  for (char& c : result) {
    if (c >= from && c <= to) c = static_cast<char>(c + shift);
  }
  return result;
}

}  // namespace

std::string_view encodingName(Encoding encoding) {
  switch (encoding) {
    case Encoding::ascii:
      return "ASCII";
    case Encoding::utf8:
      return "UTF-8";
    case Encoding::utf16:
      return "UTF-16";
    case Encoding::shiftJis:
      return "Shift-JIS";
    case Encoding::latin1:
      break;
  }
  return "Latin-1";
}

Encoding detectEncoding(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return Encoding::utf16;
  const std::string_view head = bytes.substr(0, 256);
  if (head.size() >= 8 && std::count(head.begin(), head.end(), '\0') * 3 >= std::ptrdiff_t(head.size()) &&
      std::any_of(head.begin(), head.end(), [](char c) { return c != '\0'; })) {
    return Encoding::utf16;
  }
  if (std::all_of(bytes.begin(), bytes.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; })) {
    return Encoding::ascii;
  }
  if (isUtf8(bytes)) return Encoding::utf8;
  return isShiftJis(bytes) ? Encoding::shiftJis : Encoding::latin1;
}

std::string toUtf8(std::string_view bytes, Encoding from) {
  switch (from) {
    case Encoding::ascii:
      return std::string(bytes);
    case Encoding::utf8:
      return std::string(bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes);
    case Encoding::utf16:
      return convertToUtf8(bytes, "UTF-16");
    case Encoding::shiftJis:
      return convertToUtf8(bytes, "CP932");
    case Encoding::latin1:
      break;
  }
  return latin1ToUtf8(bytes);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks(" \t\r\n\f\v\0", 7);
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lowerCase(std::string_view text) {
  return mapped(text, 'A', 'Z', 'a' - 'A');
}
std::string upperCase(std::string_view text) {
  return mapped(text, 'a', 'z', 'A' - 'a');
}

std::optional<double> parseNumber(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('+') || text.starts_with('-')) return std::nullopt;
  }
  if (text.empty()) return std::nullopt;
  std::string fortran;  // 1.0D+03
  if (const std::size_t d = text.find_first_of("dD"); d != std::string_view::npos && d > 0) {
    fortran = text;
    fortran[d] = 'e';
    text = fortran;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

TextScanner::TextScanner(std::string_view text) : text_(text) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  // ctrl-Z ends a text of CP/M and MS-DOS; what follows is what was left on the disk.
  if (const std::size_t end = text_.find('\x1A'); end != std::string_view::npos) text_ = text_.substr(0, end);
}

bool TextScanner::atEnd() const {
  for (std::size_t i = at_; i < text_.size(); ++i) {
    if (!isBlank(text_[i]) && text_[i] != '\n' && text_[i] != '\r') return false;
  }
  return true;
}

void TextScanner::passLineEnd() {
  if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
  ++at_;
  ++line_;
  lineStart_ = at_;
}

std::optional<TextPiece> TextScanner::line() {
  if (at_ >= text_.size()) return std::nullopt;
  const std::size_t begin = at_;
  const int number = line_, column = static_cast<int>(begin - lineStart_) + 1;
  at_ = std::min(text_.find_first_of("\r\n", begin), text_.size());
  const std::string_view content = text_.substr(begin, at_ - begin);
  if (at_ < text_.size()) passLineEnd();
  return TextPiece{content, number, column};
}

std::optional<TextPiece> TextScanner::word(std::string_view separators) {
  const auto isSeparator = [&](char c) { return isBlank(c) || separators.find(c) != std::string_view::npos; };
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '\n' || c == '\r')
      passLineEnd();
    else if (isSeparator(c))
      ++at_;
    else
      break;
  }
  if (at_ >= text_.size()) return std::nullopt;
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r' && !isSeparator(text_[at_])) ++at_;
  return TextPiece{text_.substr(begin, at_ - begin), line_, static_cast<int>(begin - lineStart_) + 1};
}

}  // namespace goniolux::core
