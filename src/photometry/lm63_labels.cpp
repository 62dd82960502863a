#include "photometry/lm63_labels.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace goniolux::photometry {
namespace {

using core::SourcePosition;

bool isFormatLine(std::string_view line) {
  const std::string upper = core::upperCase(core::trimmed(line));
  return upper.starts_with("IESNA") || upper.starts_with("IES:LM-63");
}

// The value of a "TILT=value" line, if it is one.
std::optional<std::string_view> tiltValue(std::string_view line) {
  const std::string_view text = core::trimmed(line);
  if (core::upperCase(text.substr(0, 4)) != "TILT") return std::nullopt;
  const std::string_view rest = core::trimmed(text.substr(4));
  if (!rest.starts_with('=')) return std::nullopt;
  return core::trimmed(rest.substr(1));
}

class Reader {
 public:
  Reader(core::TextScanner& scanner, core::Encoding encoding, const std::string& fileName, core::Diagnostics& warnings)
      : scanner_(scanner), encoding_(encoding), fileName_(fileName), warnings_(warnings) {}

  Lm63Labels read() {
    readFormatLine();
    readKeywords();
    noteUnits();
    return std::move(labels_);
  }

 private:
  [[nodiscard]] SourcePosition at(int line, int column = 0) const { return {fileName_, line, column}; }
  void warn(SourcePosition position, const char* rule, std::string message) {
    warnings_.warning(std::move(position), rule, std::move(message));
  }

  void readFormatLine() {
    core::TextScanner start = scanner_;
    auto line = scanner_.line();
    while (line && core::trimmed(line->text).empty()) line = scanner_.line();
    if (line && isFormatLine(line->text)) {
      identifyEdition(*line);
    } else {
      scanner_ = start;  // LM-63-1986 has no format line
      warn(at(1), "format-line-missing",
           "the first line does not name an edition; read as LM-63-1986, where the 12th header number multiplies the "
           "candelas");
    }
  }

  void identifyEdition(const core::TextPiece& line) {
    static constexpr std::array<std::pair<std::string_view, Lm63Edition>, 5> exact{
        {{"IESNA86", Lm63Edition::e1986},
         {"IESNA91", Lm63Edition::e1991},
         {"IESNA:LM-63-1995", Lm63Edition::e1995},
         {"IESNA:LM-63-2002", Lm63Edition::e2002},
         {"IES:LM-63-2019", Lm63Edition::e2019}}};
    const std::string text = core::upperCase(core::trimmed(line.text));
    for (const auto& [name, edition] : exact) {
      if (text == name) {
        labels_.edition = edition;
        return;
      }
    }
    // The year that ends the line, with two or four digits.
    std::size_t digits = 0;
    while (digits < text.size() && digits < 4 &&
           std::isdigit(static_cast<unsigned char>(text[text.size() - 1 - digits])))
      ++digits;
    int year = 0;
    for (std::size_t i = text.size() - digits; i < text.size(); ++i) year = 10 * year + (text[i] - '0');
    if (digits == 2) year += year >= 86 ? 1900 : 2000;
    labels_.edition = year >= 2019 || year < 1986 ? Lm63Edition::e2019
                      : year >= 2002              ? Lm63Edition::e2002
                      : year >= 1994              ? Lm63Edition::e1995
                      : year >= 1991              ? Lm63Edition::e1991
                                                  : Lm63Edition::e1986;
    warn(
        at(line.line, line.column), "odd-format-line",
        fmt::format("'{}' is not the format line of any edition; read as {}",
                    core::toUtf8(core::trimmed(line.text).substr(0, 40), encoding_), lm63EditionName(labels_.edition)));
  }

  void readKeywords() {
    std::string last;
    bool warned = false;
    while (const auto line = scanner_.line()) {
      if (const auto tilt = tiltValue(line->text)) {
        labels_.tilt = *tilt;
        labels_.tiltAt = at(line->line, line->column);
        return;
      }
      const std::string_view text = core::trimmed(line->text);
      const std::size_t close = text.find(']');
      if (text.empty()) continue;
      if (!text.starts_with('[') || close == std::string_view::npos) {
        if (labels_.edition > Lm63Edition::e1986 && !warned) {
          warn(at(line->line, line->column), "free-text-label",
               "a label line without [KEYWORD]; kept as text, it changes no value");
          warned = true;
        }
        append("TEXT", text);
        continue;
      }
      const std::string key = core::toUtf8(core::upperCase(core::trimmed(text.substr(1, close - 1))), encoding_);
      if (key == "BLOCK" || key == "ENDBLOCK") continue;
      if (key != "MORE") last = key;
      if (!last.empty()) append(last, core::trimmed(text.substr(close + 1)));
    }
    throw core::InputError(at(scanner_.lineNumber()), "tilt-line-missing",
                           "the file ends without a TILT= line; it is cut short, or no LM-63 file");
  }

  // Keywords may be repeated, and [MORE] continues them: one line each.
  void append(const std::string& key, std::string_view value) {
    auto [entry, isNew] = labels_.keywords.try_emplace(key);
    if (!isNew) entry->second += '\n';
    entry->second += core::toUtf8(value, encoding_);
  }

  void noteUnits() {
    for (const auto& [key, value] : labels_.keywords) {
      const std::string lower = core::lowerCase(value);
      if (lower.find("mw/sr") == std::string::npos && lower.find("radiometric units") == std::string::npos) continue;
      labels_.radiometric = true;
      warn(
          labels_.tiltAt, "radiometric-units",
          fmt::format(
              "[{}] says that the values are radiometric (mW/sr); they are read as candelas, without conversion: every "
              "\"lumen\" of this file is a milliwatt",
              key));
      return;
    }
  }

  core::TextScanner& scanner_;
  core::Encoding encoding_;
  const std::string& fileName_;
  core::Diagnostics& warnings_;
  Lm63Labels labels_;
};

}  // namespace

const char* lm63EditionName(Lm63Edition edition) {
  switch (edition) {
    case Lm63Edition::e1986:
      return "LM-63-1986";
    case Lm63Edition::e1991:
      return "LM-63-1991";
    case Lm63Edition::e1995:
      return "LM-63-1995";
    case Lm63Edition::e2002:
      return "LM-63-2002";
    case Lm63Edition::e2019:
      break;
  }
  return "LM-63-2019";
}

bool looksLikeLm63(std::string_view bytes) {
  core::TextScanner scanner(bytes);
  bool isFirst = true;
  while (const auto line = scanner.line()) {
    if (core::trimmed(line->text).empty()) continue;
    if ((isFirst && isFormatLine(line->text)) || tiltValue(line->text)) return true;
    isFirst = false;
  }
  return false;
}

Lm63Labels readLm63Labels(core::TextScanner& scanner, core::Encoding encoding, const std::string& fileName,
                          core::Diagnostics& warnings) {
  return Reader(scanner, encoding, fileName, warnings).read();
}

}  // namespace goniolux::photometry
