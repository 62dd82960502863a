#include "photometry/lm63.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/document.h"
#include "core/text.h"
#include "photometry/candela_table.h"
#include "photometry/lm63_labels.h"
#include "photometry/number_reader.h"

namespace goniolux::photometry {
namespace {

using core::SourcePosition;

constexpr double metresPerFoot = 0.3048;
constexpr int largestCount = 1'000'000'000;
constexpr std::size_t largestTiltFile = 1 << 20;

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
    Lm63Labels labels = readLm63Labels(scanner_, encoding_, file_.file, file_.warnings);
    edition_ = labels.edition;
    tiltAt_ = labels.tiltAt;
    file_.format = lm63EditionName(edition_);
    file_.keywords = std::move(labels.keywords);
    file_.radiometric = labels.radiometric;
    if (labels.radiometric) {
      file_.intensityUnit = "mW/sr";
      file_.fluxUnit = "mW";
    }
    readNumbersWithEitherComma(labels.tilt);
    return std::move(file_);
  }

 private:
  [[nodiscard]] SourcePosition at(int line, int column = 0) const { return {file_.file, line, column}; }
  void warn(SourcePosition position, const char* rule, std::string message) {
    file_.warnings.warning(std::move(position), rule, std::move(message));
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
      factorRemarks_.clear();
      try {
        readNumbers(tilt, DecimalComma::isPoint);
      } catch (const core::InputError&) {
        scanner_ = start;
        file_ = before;
        factorRemarks_.clear();
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
    factor *= readFactors(numbers) * tiltFactorUpright();
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
    for (const FactorRemark& remark : factorRemarks_) {
      const double flux = file_.distribution->flux();
      warn(remark.position, remark.rule,
           fmt::format("{}: {:.6g} {} with it as read, {:.6g} {} otherwise", remark.message, flux, file_.fluxUnit,
                       flux * remark.otherwise, file_.fluxUnit));
    }
  }

  // A remark on a factor; what it changes in lumens is known once the table has been read.
  struct FactorRemark {
    SourcePosition position;
    const char* rule;
    std::string message;
    double otherwise;  ///< the flux with the other reading, relative
  };

  void readOpening(double width, double length, double height, int units, const SourcePosition& position) {
    file_.opening = lm63Opening(edition_, width, length, height, units == 1 ? metresPerFoot : 1.0);
    if (file_.opening.shape == StatedOpening::Shape::other) {
      warn(position, "opening-other", fmt::format("{}; it is taken as a point", file_.opening.note));
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
        factorRemarks_.push_back(
            {numbers.position(), "ballast-lamp-factor",
             fmt::format("the ballast-lamp factor {} of {} multiplies all candelas", twelfth, file_.format),
             1 / twelfth});
      }
    } else if (twelfth != 1 && edition_ < Lm63Edition::e2019) {
      factorRemarks_.push_back(
          {numbers.position(), "future-use",
           fmt::format("the 12th header number is {}; {} keeps it for future use: it multiplies nothing", twelfth,
                       file_.format),
           twelfth});
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
  }

  // LM-63: the candelas are multiplied by the factor of the angle at which the luminaire is installed. It is read as
  // not tilted; a project applies the factor of its own aim.
  double tiltFactorUpright() {
    if (!file_.tilt) return 1;
    const double factor = tiltFactor(*file_.tilt, 0);
    if (!(factor > 0)) {
      throw core::InputError(tiltAt_, "bad-multiplier",
                             fmt::format("the tilt factor at 0 degrees is {}; it must be above 0", factor));
    }
    const auto [low, high] = std::minmax_element(file_.tilt->factors.begin(), file_.tilt->factors.end());
    factorRemarks_.push_back(
        {tiltAt_, "tilt-factor",
         fmt::format("lamp output depends on tilt (factors {} to {}); the factor {} of 0 degrees multiplies, and in a "
                     "project that of the luminaire's own tilt",
                     *low, *high, factor),
         1 / factor});
    return factor;
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
    for (const double factor : tilt.factors)
      if (factor < 0)
        numbers.refuse("bad-multiplier", fmt::format("a tilt factor is {}; it cannot be below 0", factor));
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
  std::vector<FactorRemark> factorRemarks_;
};

}  // namespace

double tiltFactor(const TiltTable& tilt, double degrees) {
  const std::vector<double>&angles = tilt.angles, &factors = tilt.factors;
  const double angle = std::clamp(degrees, angles.front(), angles.back());
  const auto above = std::lower_bound(angles.begin(), angles.end(), angle);
  const auto i = static_cast<std::size_t>(above - angles.begin());
  if (i == 0 || *above == angle) return factors[i];
  return factors[i - 1] + (factors[i] - factors[i - 1]) * (angle - angles[i - 1]) / (angles[i] - angles[i - 1]);
}

PhotometricFile readLm63(std::string_view bytes, const std::string& fileName) {
  return Reader(bytes, fileName).read();
}

}  // namespace goniolux::photometry
