#include "photometry/eulumdat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.h"
#include "photometry/candela_table.h"
#include "photometry/number_reader.h"

namespace goniolux::photometry {
namespace {

using core::SourcePosition;

constexpr int largestCount = 1'000'000'000;
constexpr int largestLampSets = 20;  // EULUMDAT/2
constexpr double metresPerMillimetre = 0.001;

struct LampSet {
  double lamps = 0;  ///< negative: absolute photometry
  std::string type;
  double flux = 0, watts = 0;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& fileName)
      : encoding_(core::detectEncoding(bytes)), scanner_(bytes) {
    file_.file = fileName;
    file_.format = "EULUMDAT";
  }

  PhotometricFile read() {
    if (encoding_ == core::Encoding::utf16) {
      throw core::InputError(at(1), "utf-16",
                             "the file is UTF-16 text; EULUMDAT is Latin-1: save it as Latin-1 or UTF-8");
    }
    if (scanner_.atEnd()) throw core::InputError(at(1), "empty-file", "the file is empty; fetch it again");
    text("MANUFAC", "the company's name");
    number("the type indicator");
    const int symmetry = count("the symmetry code", 0, 4);
    const int planes = count("the number of C planes", 1, largestCount);
    number("the distance between C planes");
    const int gammas = count("the number of intensities per plane", 2, largestCount);
    number("the distance between intensities");
    text("TEST", "the report number");
    text("LUMINAIRE", "the luminaire's name");
    text("LUMCAT", "the luminaire's number");
    text("FILENAME", "the file's name");
    text("DATE", "the date");
    for (const char* what : {"the luminaire's length", "the luminaire's width", "the luminaire's height"}) number(what);
    readOpening();
    readRatios();
    const double conversion = readConversion();
    number("the tilt during measurement");
    readLampSets();
    for (int i = 1; i <= 10; ++i) number(fmt::format("direct ratio {}", i));
    readTable(symmetry, planes, gammas, conversion);
    return std::move(file_);
  }

 private:
  [[nodiscard]] SourcePosition at(int line, int column = 0) const { return {file_.file, line, column}; }
  void warn(SourcePosition position, const char* rule, std::string message) {
    file_.warnings.warning(std::move(position), rule, std::move(message));
  }

  core::TextPiece next(const std::string& what) {
    const auto line = scanner_.line();
    if (!line) {
      throw core::InputError(at(scanner_.lineNumber()), "file-ends-early",
                             fmt::format("the file ends before {}; it is cut short", what));
    }
    return *line;
  }

  std::string text(const char* keyword, const std::string& what) {
    std::string value = core::toUtf8(core::trimmed(next(what).text), encoding_);
    if (*keyword != '\0' && !value.empty()) file_.keywords[keyword] = value;
    return value;
  }

  // A field of its own line; empty when it is blank.
  std::optional<double> optionalNumber(const std::string& what) {
    const core::TextPiece line = next(what);
    position_ = at(line.line, 1);
    const std::string_view content = core::trimmed(line.text);
    if (content.empty()) return std::nullopt;
    const auto value = parseNumber(content, DecimalComma::isPoint);
    if (!value || !std::isfinite(*value)) {
      throw core::InputError(position_, "not-a-number",
                             fmt::format("{}: '{}' is not a number; correct line {}", what,
                                         core::toUtf8(content.substr(0, 40), encoding_), line.line));
    }
    if (content.find(',') != std::string_view::npos) noteDecimalComma(position_);
    return value;
  }

  double number(const std::string& what) {
    const auto value = optionalNumber(what);
    if (!value && !warnedOfBlank_) {
      warn(position_, "blank-field", fmt::format("{} is blank; read as 0, and so are further blank numbers", what));
      warnedOfBlank_ = true;
    }
    return value.value_or(0);
  }

  int count(const std::string& what, int minimum, int maximum) {
    const auto value = optionalNumber(what);
    if (!value)
      throw core::InputError(position_, "bad-count", fmt::format("{} is blank; it must be a whole number", what));
    if (*value != std::floor(*value) || *value < minimum || *value > maximum) {
      throw core::InputError(
          position_, "bad-count",
          fmt::format("{} is {}; it must be a whole number from {} to {}", what, *value, minimum, maximum));
    }
    return static_cast<int>(*value);
  }

  void noteDecimalComma(const SourcePosition& position) {
    if (warnedOfComma_) return;
    warn(position, "decimal-comma", "numbers with a decimal comma; read as decimal points");
    warnedOfComma_ = true;
  }

  // Luminous area: width 0 means round; the four heights are those at C0, C90, C180, C270.
  void readOpening() {
    const double length = std::abs(number("the length of the luminous area")) * metresPerMillimetre;
    const double width = std::abs(number("the width of the luminous area")) * metresPerMillimetre;
    double height = 0;
    for (const char* plane : {"C0", "C90", "C180", "C270"}) {
      height =
          std::max(height, number(fmt::format("the height of the luminous area at {}", plane)) * metresPerMillimetre);
    }
    StatedOpening& opening = file_.opening;
    opening.height = height;
    opening.lengthAlongC90 = true;
    if (length > 0 && width > 0) {
      opening.shape = height > 0 ? StatedOpening::Shape::box : StatedOpening::Shape::rectangle;
      opening.length = length;
      opening.width = width;
    } else if (length > 0 || width > 0) {
      opening.shape = height > 0 ? StatedOpening::Shape::cylinder : StatedOpening::Shape::disc;
      opening.length = opening.width = std::max(length, width);
    } else if (height > 0) {
      opening.shape = StatedOpening::Shape::line;
    }
  }

  void readRatios() {
    const double downward = number("the downward flux fraction");
    const double ratio = number("the light output ratio");
    if (downward >= 0 && downward <= 100) file_.downwardFraction = downward / 100;
    if (ratio > 0) file_.lightOutputRatio = ratio / 100;
  }

  double readConversion() {
    const double conversion = number("the conversion factor for intensities");
    if (!(conversion > 0)) {
      warn(position_, "bad-conversion",
           fmt::format("the conversion factor for intensities is {}; read as 1", conversion));
      return 1;
    }
    if (conversion != 1) {
      warn(position_, "conversion-factor",
           fmt::format("the conversion factor {} multiplies all candelas and lumens", conversion));
    }
    return conversion;
  }

  void readLampSets() {
    const int sets = count("the number of lamp sets", 1, largestLampSets);
    const int line = position_.line;
    std::vector<LampSet> list;
    for (int i = 0; i < sets; ++i) {  // set by set, as real files have them
      LampSet set;
      set.lamps = number("the number of lamps");
      set.type = text(i == 0 ? "LAMP" : "", "the type of lamps");
      set.flux = number("the total flux of the lamps");
      if (i == 0) fluxAt_ = position_;
      text(i == 0 ? "COLOUR" : "", "the colour of the lamps");
      text(i == 0 ? "COLOURRENDERING" : "", "the colour rendering of the lamps");
      set.watts = number("the watts with ballast");
      list.push_back(std::move(set));
    }
    const LampSet& used = list.front();
    if (!(used.flux > 0)) {
      throw core::InputError(
          fluxAt_, "no-lamp-flux",
          fmt::format("the flux of the lamps is {} lm; the intensities are per 1000 lm of it: state it", used.flux));
    }
    lampFlux_ = used.flux;
    file_.inputWatts = std::max(0.0, used.watts);
    file_.absolute = used.lamps < 0;
    if (!file_.absolute) file_.declaredLumens = used.flux;
    if (file_.lightOutputRatio) file_.declaredLuminaireLumens = used.flux * *file_.lightOutputRatio;
    if (sets > 1) {
      std::string others;
      for (std::size_t i = 1; i < list.size(); ++i) {
        others += fmt::format("{}{} {} lm", i > 1 ? ", " : "", list[i].type, list[i].flux);
      }
      warn(at(line, 1), "lamp-sets",
           fmt::format("the first of {} lamp sets is used, {} {} lm; with the others ({}) all candelas scale", sets,
                       used.type, used.flux, others));
    }
  }

  void readTable(int symmetry, int planes, int gammas, double conversion) {
    const core::TextScanner start = scanner_;
    while (const auto word = scanner_.word("")) {
      if (word->text.find(',') == std::string_view::npos) continue;
      noteDecimalComma(at(word->line, word->column));
      break;
    }
    scanner_ = start;
    NumberReader numbers(scanner_, file_.file, DecimalComma::isPoint);
    const auto n = static_cast<std::size_t>(gammas);
    numbers.expectRoomFor(static_cast<std::size_t>(planes) + n, "angles");
    const std::vector<std::size_t> stored = storedPlanes(symmetry, planes);
    numbers.expectRoomFor(stored.size() * n, "intensities");

    CandelaTable table;
    table.factor = conversion * lampFlux_ / 1000;
    const std::vector<double> angles =
        numbers.numbers(static_cast<std::size_t>(planes), "the C angles", ListOf::anything, &table.horizontalAt);
    table.vertical = numbers.numbers(n, "the gamma angles", ListOf::ascendingAngles, &table.verticalAt);
    for (const std::size_t i : stored) table.horizontal.push_back(angles[i]);
    for (std::size_t h = 0; h < stored.size(); ++h) {
      const std::vector<double> row =
          numbers.numbers(n, fmt::format("the intensities of stored plane {} of {}", h + 1, stored.size()),
                          ListOf::intensities, h == 0 ? &table.candelasAt : nullptr);
      table.candelas.insert(table.candelas.end(), row.begin(), row.end());
    }
    if (!scanner_.atEnd()) {
      warn(at(scanner_.lineNumber()), "trailing-text", "text follows the last intensity; it is left out");
    }
    if (symmetry == 1) table.horizontal = {0};
    if (symmetry == 3) mirror(table);
    if (symmetry == 0) closeFewPlanes(table);
    file_.distribution = makeDistribution(std::move(table), file_.warnings);
    file_.symmetry = symmetryName(file_.distribution->symmetry());
  }

  // Which of the Mc listed planes have intensities, in the file's order.
  std::vector<std::size_t> storedPlanes(int symmetry, int planes) const {
    const auto mc = static_cast<std::size_t>(planes);
    std::size_t first = 0, count = mc;
    if (symmetry == 1) count = 1;
    if (symmetry == 2 || symmetry == 3) count = mc / 2 + 1;
    if (symmetry == 3) first = 3 * (mc / 4);
    if (symmetry == 4) count = mc / 4 + 1;
    const std::size_t divisor = symmetry == 2 ? 2 : symmetry >= 3 ? 4 : 1;
    if (mc % divisor != 0) {
      throw core::InputError(at(4, 1), "bad-count",
                             fmt::format("{} C planes do not fit symmetry code {}; they must be a multiple of {}",
                                         planes, symmetry, divisor));
    }
    std::vector<std::size_t> stored;
    for (std::size_t i = 0; i < count; ++i) stored.push_back((first + i) % mc);
    return stored;
  }

  // Symmetry code 3 stores C270 through C0 to C90. About the C90-C270 plane, plane C equals plane 180 - C.
  static void mirror(CandelaTable& table) {
    const std::size_t planes = table.horizontal.size(), n = table.vertical.size();
    std::vector<double> angles, candelas;
    for (std::size_t i = planes; i-- > 0;) {
      const double mirrored = 180 - table.horizontal[i];
      angles.push_back(mirrored < 0 ? mirrored + 360 : mirrored);
      const auto row = table.candelas.begin() + static_cast<std::ptrdiff_t>(i * n);
      candelas.insert(candelas.end(), row, row + static_cast<std::ptrdiff_t>(n));
    }
    table.horizontal = std::move(angles);
    table.candelas = std::move(candelas);
  }

  // Without symmetry the planes go all the way round, however few there are: the closing plane is stated, because a
  // list that ends at 90 or 180 degrees would mean a symmetry.
  static void closeFewPlanes(CandelaTable& table) {
    if (table.horizontal.size() < 2 || table.horizontal.back() > 180) return;
    if (table.horizontal.size() == 2 && table.horizontal.back() == 180) return;  // either reading is the same function
    table.horizontal.push_back(360);
    const std::vector<double> plane(table.candelas.begin(),
                                    table.candelas.begin() + static_cast<std::ptrdiff_t>(table.vertical.size()));
    table.candelas.insert(table.candelas.end(), plane.begin(), plane.end());
  }

  core::Encoding encoding_;
  core::TextScanner scanner_;
  PhotometricFile file_;
  SourcePosition position_, fluxAt_;
  double lampFlux_ = 0;
  bool warnedOfBlank_ = false, warnedOfComma_ = false;
};

}  // namespace

bool looksLikeEulumdat(std::string_view bytes) {
  core::TextScanner scanner(bytes);
  if (!scanner.line()) return false;
  for (int i = 2; i <= 7; ++i) {
    const auto line = scanner.line();
    if (!line) return false;
    const auto value = parseNumber(core::trimmed(line->text), DecimalComma::isPoint);
    if (!value || (i == 3 && (*value < 0 || *value > 4))) return false;
  }
  return true;
}

PhotometricFile readEulumdat(std::string_view bytes, const std::string& fileName) {
  return Reader(bytes, fileName).read();
}

}  // namespace goniolux::photometry
