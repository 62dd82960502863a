#include "photometry/lm63.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/document.h"
#include "core/text.h"
#include "photometry/candela_table.h"
#include "photometry/number_reader.h"

namespace goniolux::photometry {
namespace {

using core::SourcePosition;

constexpr double metresPerFoot = 0.3048;
constexpr int largestCount = 1'000'000'000;
constexpr std::size_t largestTiltFile = 1 << 20;

const char* editionName(Lm63Edition edition) {
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
  Reader(std::string_view bytes, const std::string& fileName)
      : encoding_(core::detectEncoding(bytes)), scanner_(bytes) {
    file_.file = fileName;
  }

  PhotometricFile read() {
    if (encoding_ == core::Encoding::utf16) {
      throw core::InputError(at(1), "utf-16", "the file is UTF-16 text; LM-63 is ASCII: save it as ASCII or UTF-8");
    }
    if (scanner_.atEnd()) throw core::InputError(at(1), "empty-file", "the file is empty; fetch it again");
    readFormatLine();
    const std::string tilt = readKeywords();
    noteUnits();
    readNumbersWithEitherComma(tilt);
    return std::move(file_);
  }

 private:
  [[nodiscard]] SourcePosition at(int line, int column = 0) const { return {file_.file, line, column}; }
  void warn(SourcePosition position, const char* rule, std::string message) {
    file_.warnings.warning(std::move(position), rule, std::move(message));
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
    file_.format = editionName(edition_);
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
        edition_ = edition;
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
    edition_ = year >= 2019 || year < 1986 ? Lm63Edition::e2019
               : year >= 2002              ? Lm63Edition::e2002
               : year >= 1994              ? Lm63Edition::e1995
               : year >= 1991              ? Lm63Edition::e1991
                                           : Lm63Edition::e1986;
    warn(at(line.line, line.column), "odd-format-line",
         fmt::format("'{}' is not the format line of any edition; read as {}",
                     core::toUtf8(core::trimmed(line.text).substr(0, 40), encoding_), editionName(edition_)));
  }

  // Label lines up to TILT=; returns what stands after the equals sign.
  std::string readKeywords() {
    std::string last;
    bool warned = false;
    while (const auto line = scanner_.line()) {
      if (const auto tilt = tiltValue(line->text)) {
        tiltAt_ = at(line->line, line->column);
        return std::string(*tilt);
      }
      const std::string_view text = core::trimmed(line->text);
      const std::size_t close = text.find(']');
      if (text.empty()) continue;
      if (!text.starts_with('[') || close == std::string_view::npos) {
        if (edition_ > Lm63Edition::e1986 && !warned) {
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
    auto [entry, isNew] = file_.keywords.try_emplace(key);
    if (!isNew) entry->second += '\n';
    entry->second += core::toUtf8(value, encoding_);
  }

  void noteUnits() {
    for (const auto& [key, value] : file_.keywords) {
      const std::string lower = core::lowerCase(value);
      if (lower.find("mw/sr") == std::string::npos && lower.find("radiometric") == std::string::npos) continue;
      file_.radiometric = true;
      warn(
          tiltAt_, "radiometric-units",
          fmt::format(
              "[{}] says that the values are radiometric (mW/sr); they are read as candelas, without conversion: every "
              "\"lumen\" of this file is a milliwatt",
              key));
      return;
    }
  }

  // In LM-63 a comma parts numbers. Where that makes no sense and a comma stands inside of numbers, it is tried as
  // decimal point.
  void readNumbersWithEitherComma(const std::string& tilt) {
    const core::TextScanner start = scanner_;
    const PhotometricFile before = file_;
    try {
      readNumbers(tilt, DecimalComma::isSeparator);
    } catch (const core::InputError&) {
      scanner_ = start;
      const int line = firstCommaWithinNumber();
      if (line == 0) throw;
      scanner_ = start;
      file_ = before;
      try {
        readNumbers(tilt, DecimalComma::isPoint);
      } catch (const core::InputError&) {
        scanner_ = start;
        file_ = before;
        readNumbers(tilt, DecimalComma::isSeparator);  // its message is about the standard's reading
      }
      warn(at(line), "decimal-comma", "numbers with a decimal comma; read as decimal points");
    }
  }

  // Line of the first "1,5"; 0 if there is none.
  int firstCommaWithinNumber() {
    while (const auto word = scanner_.word("")) {
      const std::size_t comma = word->text.find(',');
      if (comma != std::string_view::npos && comma + 1 < word->text.size()) return word->line;
    }
    return 0;
  }

  void readNumbers(const std::string& tilt, DecimalComma comma) {
    NumberReader numbers(scanner_, file_.file, comma);
    readTilt(tilt, numbers);
    const double lamps = numbers.number("the number of lamps");
    const SourcePosition lampsAt = numbers.position();
    const double lumensPerLamp = numbers.number("the lumens per lamp");
    double factor = numbers.number("the candela multiplier");
    if (!(factor > 0))
      numbers.refuse("bad-multiplier", fmt::format("the candela multiplier is {}; it must be above 0", factor));
    const int verticals = numbers.count("the number of vertical angles", 2, largestCount);
    const int horizontals = numbers.count("the number of horizontal angles", 1, largestCount);
    const auto values = static_cast<std::size_t>(verticals) * static_cast<std::size_t>(horizontals);
    numbers.expectRoomFor(values, "candelas");
    const int type = numbers.count("the photometry type", 1, 3);
    const int units = numbers.count("the units type (1 feet, 2 metres)", 1, 2);
    const double width = numbers.number("the width of the opening"),
                 length = numbers.number("the length of the opening"),
                 height = numbers.number("the height of the opening");
    readOpening(width, length, height, units, numbers.position());
    factor *= readFactors(numbers);
    readLampFlux(lamps, lumensPerLamp, lampsAt);

    CandelaTable table;
    table.type = type == 1 ? PhotometryType::c : type == 2 ? PhotometryType::b : PhotometryType::a;
    table.factor = factor;
    table.vertical = numbers.numbers(static_cast<std::size_t>(verticals), "the vertical angles",
                                     ListOf::ascendingAngles, &table.verticalAt);
    table.horizontal = numbers.numbers(static_cast<std::size_t>(horizontals), "the horizontal angles",
                                       ListOf::ascendingAngles, &table.horizontalAt);
    table.candelas.reserve(values);
    for (int h = 0; h < horizontals; ++h) {
      const std::vector<double> row = numbers.numbers(static_cast<std::size_t>(verticals),
                                                      fmt::format("the candelas of plane {} of {}", h + 1, horizontals),
                                                      ListOf::intensities, h == 0 ? &table.candelasAt : nullptr);
      table.candelas.insert(table.candelas.end(), row.begin(), row.end());
    }
    warnOfRest();
    file_.distribution = makeDistribution(std::move(table), file_.warnings);
    file_.symmetry = symmetryName(file_.distribution->symmetry());
  }

  void readOpening(double width, double length, double height, int units, const SourcePosition& position) {
    file_.opening = lm63Opening(edition_, width, length, height, units == 1 ? metresPerFoot : 1.0);
    if (file_.opening.shape == StatedOpening::Shape::other) {
      warn(position, "opening-other",
           fmt::format("the luminous opening is a shape that is kept as text only: {}", file_.opening.note));
    }
  }

  // Ballast factor, the 12th number and the input watts; returns what multiplies the candelas.
  double readFactors(NumberReader& numbers) {
    const double ballast = numbers.number("the ballast factor");
    if (!(ballast > 0)) {
      numbers.refuse(
          "bad-multiplier",
          fmt::format(
              "the ballast factor is {}; it must be above 0. Is the line with ballast factor, future use and input "
              "watts missing?",
              ballast));
    }
    const double twelfth = numbers.number("the ballast-lamp factor (1986, 1991) or number for future use");
    double factor = ballast;
    // LM-63-1986 and -1991: ballast-lamp photometric factor; 1995 and 2002: future use; 2019: file generation type.
    if (edition_ <= Lm63Edition::e1991) {
      if (!(twelfth > 0)) {
        numbers.refuse("bad-multiplier",
                       fmt::format("the ballast-lamp factor is {}; it must be above 0 in {}", twelfth, file_.format));
      }
      factor *= twelfth;
      if (twelfth != 1) {
        warn(numbers.position(), "ballast-lamp-factor",
             fmt::format("the ballast-lamp factor {} of {} multiplies all candelas and lumens", twelfth, file_.format));
      }
    } else if (twelfth != 1 && edition_ < Lm63Edition::e2019) {
      warn(numbers.position(), "future-use",
           fmt::format("the 12th header number is {}; {} keeps it for future use: it changes nothing", twelfth,
                       file_.format));
    }
    file_.inputWatts = numbers.number("the input watts");
    if (file_.inputWatts <= 0) {
      if (file_.inputWatts < 0)
        warn(numbers.position(), "negative-watts", "the input watts are negative; taken as not stated");
      file_.inputWatts = 0;
    }
    return factor;
  }

  void readLampFlux(double lamps, double lumensPerLamp, const SourcePosition& position) {
    if (lumensPerLamp < 0) {
      file_.absolute = true;
      if (lumensPerLamp != -1) {
        warn(position, "negative-lumens",
             fmt::format("{} lumens per lamp; read as -1, absolute photometry", lumensPerLamp));
      }
    } else if (lumensPerLamp * lamps > 0) {
      file_.declaredLumens = lumensPerLamp * lamps;
    } else {
      warn(position, "no-lamp-flux",
           fmt::format(
               "{} lamps of {} lm give no lamp flux; the candelas are used as they are, no light output ratio follows",
               lamps, lumensPerLamp));
    }
    for (const char* key : {"TOTALLUMINAIRELUMENS", "_TOTALLUMINAIRELUMENS", "_ABSOLUTELUMENS", "ABSOLUTELUMENS"}) {
      const auto entry = file_.keywords.find(key);
      if (entry == file_.keywords.end()) continue;
      const auto lumens = core::parseNumber(core::trimmed(entry->second));
      if (lumens && std::isfinite(*lumens) && *lumens > 0) file_.declaredLuminaireLumens = *lumens;
    }
  }

  void readTilt(const std::string& value, NumberReader& numbers) {
    const std::string upper = core::upperCase(value);
    if (upper == "NONE") return;
    if (value.empty()) {
      throw core::InputError(tiltAt_, "tilt-empty",
                             "TILT= is followed by nothing; write TILT=NONE, TILT=INCLUDE or a file's name");
    }
    if (upper == "INCLUDE") {
      readTiltTable(numbers);
    } else {
      readTiltFile(value);
    }
    if (!file_.tilt) return;
    const auto [low, high] = std::minmax_element(file_.tilt->factors.begin(), file_.tilt->factors.end());
    warn(tiltAt_, "tilt-not-applied",
         fmt::format("the lamp output against tilt (factors {} to {}) is kept but not applied: the lumens are those of "
                     "the luminaire "
                     "as it was measured",
                     *low, *high));
  }

  void readTiltTable(NumberReader& numbers) {
    TiltTable tilt;
    tilt.lampToLuminaireGeometry = numbers.count("the lamp-to-luminaire geometry", 1, 3);
    const auto pairs = static_cast<std::size_t>(numbers.count("the number of tilt angles", 1, largestCount));
    SourcePosition begin;
    numbers.expectRoomFor(2 * pairs, "tilt angles and factors");
    tilt.angles = numbers.numbers(pairs, "the tilt angles", ListOf::ascendingAngles, &begin);
    checkAngles(tilt.angles, "tilt angles", -360, 360, begin);
    tilt.factors = numbers.numbers(pairs, "the tilt factors", ListOf::anything);
    file_.tilt = std::move(tilt);
  }

  void readTiltFile(std::string_view value) {
    if (core::upperCase(value.substr(0, 5)) == "FILE ") value = core::trimmed(value.substr(5));
    // Only beside the photometric file: a file that is passed on must not reach into other folders.
    const std::filesystem::path name = std::filesystem::path(std::string(value)).filename();
    const std::filesystem::path path = std::filesystem::path(file_.file).parent_path() / name;
    std::error_code error;
    const std::string shownName = core::toUtf8(name.string(), core::detectEncoding(name.string()));
    if (name.empty() || !std::filesystem::is_regular_file(path, error) ||
        std::filesystem::file_size(path, error) > largestTiltFile) {
      warn(tiltAt_, "tilt-file-missing",
           fmt::format("the tilt file '{}' is not beside this file; read as TILT=NONE: the lumens are those of the "
                       "luminaire as it "
                       "was measured",
                       shownName));
      return;
    }
    const std::string bytes = core::readFile(path.string());
    core::TextScanner scanner(bytes);
    NumberReader numbers(scanner, path.string(), DecimalComma::isSeparator);
    readTiltTable(numbers);
  }

  void warnOfRest() {
    if (scanner_.atEnd()) return;
    const auto word = scanner_.word(",");
    if (!word) return;
    const SourcePosition position = at(word->line, word->column);
    if (core::parseNumber(word->text)) {
      warn(position, "trailing-numbers",
           "numbers follow the last candela; they are left out. Are the counts of angles right?");
    } else {
      warn(position, "trailing-text", "text follows the last candela; it is left out");
    }
  }

  core::Encoding encoding_;
  core::TextScanner scanner_;
  PhotometricFile file_;
  Lm63Edition edition_ = Lm63Edition::e1986;
  SourcePosition tiltAt_;
};

}  // namespace

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

PhotometricFile readLm63(std::string_view bytes, const std::string& fileName) {
  return Reader(bytes, fileName).read();
}

}  // namespace goniolux::photometry
