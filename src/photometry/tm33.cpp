// The only file of this room that uses the XML parser.
#include "photometry/tm33.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <utility>

#include "core/text.h"
#include "photometry/candela_table.h"
#include "photometry/stated_intensities.h"

namespace goniolux::photometry {
namespace {

using core::SourcePosition;
using pugi::xml_node;

constexpr double longestLuminaire = 20;  // m; a larger number is millimetres
constexpr int deepest = 64;              // levels of elements that are looked into

std::string_view localName(const xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string text(const xml_node& node) {
  return std::string(core::trimmed(node.child_value()));
}

xml_node childNamed(const xml_node& node, std::string_view name) {
  return node.find_child([&](const xml_node& child) { return localName(child) == name; });
}

/// Line and column of a byte, found by bisection: a file may have as many elements as it has lines.
class Places {
 public:
  Places(std::string_view bytes, std::string file) : file_(std::move(file)) {
    lineStarts_.push_back(0);
    for (std::size_t i = 0; i < bytes.size(); ++i)
      if (bytes[i] == '\n') lineStarts_.push_back(i + 1);
  }
  [[nodiscard]] SourcePosition at(std::ptrdiff_t offset) const {
    if (offset < 0) return {file_, 1, 1};
    const auto place = static_cast<std::size_t>(offset);
    const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), place);
    return {file_, static_cast<int>(next - lineStarts_.begin()), static_cast<int>(place - *(next - 1)) + 1};
  }
  [[nodiscard]] SourcePosition of(const xml_node& node) const { return at(node.offset_debug()); }

 private:
  std::string file_;
  std::vector<std::size_t> lineStarts_;
};

/// What an intensity block is given in.
enum class Quantity { luminous, radiant, photon };

struct IntensityBlock {
  xml_node node;
  Quantity quantity = Quantity::luminous;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& fileName) : bytes_(bytes), places_(bytes, fileName) {
    file_.file = fileName;
    file_.format = "TM-33";
  }

  PhotometricFile read() {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(bytes_.data(), bytes_.size());
    if (!parsed) {
      throw core::InputError(
          places_.at(parsed.offset), "bad-xml",
          fmt::format("this is not well-formed XML ({}); fetch the file again", parsed.description()));
    }
    const xml_node root = document.document_element();
    readRoot(root);
    readHeader(childNamed(root, "Header"));
    const std::vector<IntensityBlock> blocks = chooseBlocks(root);
    readSummary(root);
    readOpening(root);
    readTable(blocks, root);
    readSpectrum(root);
    return std::move(file_);
  }

 private:
  void warn(const SourcePosition& at, const char* rule, std::string message) {
    file_.warnings.warning(at, rule, std::move(message));
  }

  void readRoot(const xml_node& root) {
    const std::string_view name = localName(root);
    if (name.starts_with("IESTM33")) {
      const std::string version = text(childNamed(root, "Version"));
      file_.format = name == "IESTM33" && (version.empty() || version.starts_with("1.0")) ? "TM-33-18" : "TM-33-23";
      if (name == "IESTM33" && version == "1.1") file_.format = "TM-33-18";
    } else if (name == "ATLA_S001_A") {
      file_.format = "ATLA S001";
    } else {
      warn(places_.of(root), "tm33-dialect",
           fmt::format("the root element <{}> is none of TM-33's; what it states in another way is read where its "
                       "meaning is plain",
                       name));
    }
  }

  void readHeader(const xml_node& header) {
    static constexpr std::array<std::pair<const char*, const char*>, 8> keys{{{"Manufacturer", "MANUFAC"},
                                                                              {"CatalogNumber", "LUMCAT"},
                                                                              {"Description", "LUMINAIRE"},
                                                                              {"Laboratory", "TESTLAB"},
                                                                              {"TestLaboratory", "TESTLAB"},
                                                                              {"ReportNumber", "TEST"},
                                                                              {"ReportDate", "ISSUEDATE"},
                                                                              {"TestDate", "TESTDATE"}}};
    for (const auto& [element, keyword] : keys)
      if (const std::string value = text(childNamed(header, element)); !value.empty()) file_.keywords[keyword] = value;
  }

  /// The number that is the text of the first descendant with one of these names; nothing when there is none.
  std::optional<double> number(const xml_node& below, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      const xml_node node = find(below, name, deepest);
      if (!node) continue;
      const auto value = core::parseNumber(text(node));
      if (!value || !std::isfinite(*value)) {
        throw core::InputError(places_.of(node), "not-a-number",
                               fmt::format("the content of <{}> is not a number; correct it", name));
      }
      return value;
    }
    return std::nullopt;
  }

  static xml_node find(const xml_node& below, std::string_view name, int levels) {
    if (levels == 0) return {};
    for (const xml_node& child : below.children()) {
      if (localName(child) == name) return child;
      if (const xml_node found = find(child, name, levels - 1)) return found;
    }
    return {};
  }

  static bool isIntensity(const xml_node& node) {
    return localName(node) == "IntData" || localName(node) == "IntensityData" || localName(node) == "IntensityMatrix";
  }

  void collectBlocks(const xml_node& node, Quantity quantity, int levels, std::vector<IntensityBlock>& blocks) const {
    if (levels == 0) return;
    const std::string_view name = localName(node);
    const std::string metric = text(childNamed(node, "Metric"));
    if (name.starts_with("Photon") || metric == "Photon") quantity = Quantity::photon;
    if (name.starts_with("Radiant") || metric == "Radiant") quantity = Quantity::radiant;
    if (name.starts_with("Luminous") || metric == "Luminous") quantity = Quantity::luminous;
    if (node.find_child(isIntensity)) blocks.push_back({node, quantity});
    for (const xml_node& child : node.children()) collectBlocks(child, quantity, levels - 1, blocks);
  }

  // The blocks of the quantity that is wanted most: one per emitter.
  std::vector<IntensityBlock> chooseBlocks(const xml_node& root) {
    std::vector<IntensityBlock> all, chosen;
    collectBlocks(root, Quantity::luminous, deepest, all);
    for (const Quantity wanted : {Quantity::luminous, Quantity::radiant, Quantity::photon}) {
      std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
                   [&](const IntensityBlock& block) { return block.quantity == wanted; });
      if (!chosen.empty()) break;
    }
    if (chosen.empty()) {
      throw core::InputError(places_.of(root), "no-intensities",
                             "the file has no intensities (IntData); it describes a luminaire without its light");
    }
    const Quantity quantity = chosen.front().quantity;
    if (quantity != Quantity::luminous) {
      file_.radiometric = true;
      file_.intensityUnit = quantity == Quantity::photon ? "umol/(s sr)" : "W/sr";
      file_.fluxUnit = quantity == Quantity::photon ? "umol/s" : "W";
      warn(places_.of(chosen.front().node), "radiometric-units",
           fmt::format("the file has no candelas; its values in {0} are read as candelas, without conversion: every "
                       "\"lumen\" of this file is one {1}",
                       file_.intensityUnit, file_.fluxUnit));
    }
    return chosen;
  }

  void readSummary(const xml_node& root) {
    file_.inputWatts = std::max(0.0, number(root, {"InputWattage", "InputWatts", "InputPower"}).value_or(0));
    const std::string isAbsolute = core::lowerCase(text(find(root, "AbsolutePhotometry", deepest)));
    const auto rated = number(root, {"RatedLumens"});
    file_.absolute = isAbsolute == "true" || isAbsolute == "1" || !rated || !(*rated > 0);
    if (!file_.absolute) file_.declaredLumens = rated;
    for (const char* name : {"MeasuredLumens", "LuminousFlux"}) {
      if (const auto flux = number(root, {name}); flux && *flux > 0) file_.declaredLuminaireLumens = flux;
    }
  }

  // One rectangle that holds the emission areas of the bottom face; none: a point.
  void readOpening(const xml_node& root) {
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    xml_node first;
    const auto include = [&](const xml_node& area) {
      const double length = number(area, {"Length", "Diameter"}).value_or(0);
      const double size[2] = {length, number(area, {"Width"}).value_or(length)};
      const double middle[2] = {number(area, {"LengthOffset"}).value_or(0), number(area, {"WidthOffset"}).value_or(0)};
      if (!(size[0] > 0) || !(size[1] > 0)) return;
      for (int i = 0; i < 2; ++i) {
        low[i] = std::min(low[i], middle[i] - 0.5 * size[i]);
        high[i] = std::max(high[i], middle[i] + 0.5 * size[i]);
      }
      if (!first) first = area;
    };
    const xml_node areas = find(root, "EmissionAreas", deepest);
    for (const xml_node& face : areas.children())
      for (const xml_node& area : face.children())
        if (localName(area) == "BottomArea") include(area);
    if (!first)
      if (const xml_node stated = find(root, "LuminousOpening", deepest)) include(stated);
    if (!first) return;
    StatedOpening& opening = file_.opening;
    opening.shape = StatedOpening::Shape::rectangle;
    const std::string shape = core::lowerCase(text(childNamed(first, "Shape")));
    if (shape.starts_with("circ") || shape.starts_with("round") || find(first, "Diameter", deepest))
      opening.shape = StatedOpening::Shape::disc;
    double unit = 1;
    if (std::max(high[0] - low[0], high[1] - low[1]) > longestLuminaire) {
      unit = 0.001;
      warn(places_.of(first), "length-unit",
           fmt::format("an opening of {:g} by {:g} m is none; TM-33 states metres, read as millimetres",
                       high[0] - low[0], high[1] - low[1]));
    }
    opening.length = unit * (high[0] - low[0]);
    opening.width = unit * (high[1] - low[1]);
  }

  double attribute(const xml_node& node, const char* longName, const char* shortName) {
    const pugi::xml_attribute given = node.attribute(longName) ? node.attribute(longName) : node.attribute(shortName);
    const auto value = core::parseNumber(core::trimmed(given.value()));
    if (!value || !std::isfinite(*value)) {
      throw core::InputError(places_.of(node), "not-a-number",
                             fmt::format("the angle \"{}\" of this intensity is missing or no number", shortName));
    }
    return *value;
  }

  std::vector<StatedIntensity> readIntensities(const xml_node& block) {
    std::vector<StatedIntensity> list;
    for (const xml_node& node : block.children()) {
      if (localName(node) != "IntData" && localName(node) != "IntensityData") continue;
      const auto value = core::parseNumber(text(node));
      if (!value || !std::isfinite(*value)) {
        throw core::InputError(places_.of(node), "not-a-number", "the content of this intensity is not a number");
      }
      list.push_back({attribute(node, "horz", "h"), attribute(node, "vert", "v"), *value, places_.of(node)});
    }
    if (list.empty()) readMatrix(block, list);
    return list;
  }

  // IESXML: a list of C planes and a row of intensities for each gamma.
  void readMatrix(const xml_node& block, std::vector<StatedIntensity>& list) {
    const auto numbersOf = [&](const xml_node& node) {
      std::vector<double> values;
      const std::string content = node.child_value();
      core::TextScanner scanner(content);
      while (const auto word = scanner.word(",")) {
        const auto value = core::parseNumber(word->text);
        if (!value || !std::isfinite(*value)) {
          throw core::InputError(places_.of(node), "not-a-number",
                                 fmt::format("<{}> holds something that is not a number", localName(node)));
        }
        values.push_back(*value);
      }
      return values;
    };
    const std::vector<double> planes = numbersOf(childNamed(block, "CPlanes"));
    for (const xml_node& row : childNamed(block, "IntensityMatrix").children()) {
      if (localName(row) != "GammaRow") continue;
      const std::vector<double> values = numbersOf(row);
      if (values.size() != planes.size()) {
        throw core::InputError(places_.of(row), "file-ends-early",
                               fmt::format("this row has {} intensities for {} planes", values.size(), planes.size()));
      }
      for (std::size_t i = 0; i < values.size(); ++i)
        list.push_back({planes[i], attribute(row, "angle", "angle"), values[i], places_.of(row)});
    }
  }

  void readTable(const std::vector<IntensityBlock>& blocks, const xml_node& root) {
    const xml_node& first = blocks.front().node;
    CandelaTable table = tableOfIntensities(readIntensities(first), places_.of(first));
    for (std::size_t i = 1; i < blocks.size(); ++i) {
      const CandelaTable other = tableOfIntensities(readIntensities(blocks[i].node), places_.of(blocks[i].node));
      if (other.horizontal != table.horizontal || other.vertical != table.vertical) {
        throw core::InputError(places_.of(blocks[i].node), "not-supported",
                               "not supported: emitters with different lists of angles; give each a file of its own");
      }
      for (std::size_t k = 0; k < table.candelas.size(); ++k) table.candelas[k] += other.candelas[k];
    }
    if (blocks.size() > 1) {
      warn(places_.of(blocks[1].node), "several-emitters",
           fmt::format("the intensities of {} emitters are added up, as if they stood in one place", blocks.size()));
    }
    table.type = typeOf(root);
    if (const auto factor = number(first, {"Multiplier"})) table.factor = *factor;
    noteUnits(root);
    std::string stated;
    for (const char* name : {"SymmType", "Symm"})
      if (const xml_node node = childNamed(first, name)) stated = text(node);
    if (table.type == PhotometryType::c) closeBySymmetry(table, stated, file_.warnings);
    file_.distribution = makeDistribution(std::move(table), file_.warnings);
    file_.symmetry = symmetryName(file_.distribution->symmetry());
  }

  PhotometryType typeOf(const xml_node& root) const {
    for (const char* name : {"PhotometryType", "GoniometerType", "Type"}) {
      std::string type = text(find(root, name, deepest));
      type.erase(std::remove(type.begin(), type.end(), ' '), type.end());
      if (type.ends_with("_A") || type == "A" || type == "TypeA") return PhotometryType::a;
      if (type.ends_with("_B") || type == "B" || type == "TypeB") return PhotometryType::b;
    }
    return PhotometryType::c;
  }

  void noteUnits(const xml_node& root) {
    const auto quantity = number(childNamed(root, "Emitter"), {"Quantity"});
    if (quantity && *quantity > 1) {
      warn(places_.of(find(root, "Quantity", deepest)), "emitter-quantity",
           fmt::format("{} equal emitters are stated; the intensities are read as those of all of them: the flux is "
                       "{} times as high if they are those of one",
                       *quantity, *quantity));
    }
  }

  // Wavelengths and values, of whichever of the known layouts is met first. A spectrum that cannot be used is left out.
  void readSpectrum(const xml_node& root) {
    std::vector<spectrum::SpectralDistribution::Sample> samples;
    xml_node at;
    collectSpectrum(root, deepest, samples, at);
    if (samples.empty()) return;
    bool usable = samples.size() >= 2, lit = false;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      usable = usable && samples[i].value >= 0 && std::isfinite(samples[i].value) && samples[i].wavelength > 0 &&
               (i == 0 || samples[i].wavelength > samples[i - 1].wavelength);
      lit = lit || samples[i].value > 0;
    }
    if (!usable || !lit) {
      warn(places_.of(at), "bad-spectrum",
           "the spectrum is dark, or its wavelengths do not ascend; it is left out: give \"spectrum\" in the project");
      return;
    }
    file_.spectrum =
        spectrum::SpectralDistribution::sampled(std::move(samples), spectrum::SpectralDistribution::Outside::zero);
  }

  static void collectSpectrum(const xml_node& node, int levels,
                              std::vector<spectrum::SpectralDistribution::Sample>& samples, xml_node& at) {
    if (levels == 0 || !samples.empty()) return;
    for (const xml_node& child : node.children()) {
      const std::string_view name = localName(child);
      const pugi::xml_attribute wavelength =
          child.attribute("w") ? child.attribute("w") : child.attribute("wavelength");
      if ((name == "PwrData" || name == "SpectralQuantity" || name == "SpectralData") && wavelength) {
        const auto w = core::parseNumber(core::trimmed(wavelength.value())), value = core::parseNumber(text(child));
        samples.push_back({w.value_or(0), value.value_or(-1)});
        if (!at) at = child;
      } else {
        collectSpectrum(child, levels - 1, samples, at);
      }
    }
    if (!samples.empty()) return;
    const std::string wavelengths = text(childNamed(node, "Wavelengths")), values = text(childNamed(node, "Values"));
    if (wavelengths.empty() || values.empty()) return;
    at = node;
    core::TextScanner w(wavelengths), v(values);
    for (auto a = w.word(","), b = v.word(","); a && b; a = w.word(","), b = v.word(","))
      samples.push_back({core::parseNumber(a->text).value_or(0), core::parseNumber(b->text).value_or(-1)});
  }

  std::string_view bytes_;
  Places places_;
  PhotometricFile file_;
};

}  // namespace

bool looksLikeTm33(std::string_view bytes) {
  constexpr std::size_t farthest = 65536;  // comments may come before
  const std::string_view head = bytes.substr(0, farthest);
  for (const char* root : {"<IESTM33", "<ATLA_S001_A", "<LuminaireOpticalData", "<IESXML"})
    if (head.find(root) != std::string_view::npos) return true;
  return false;
}

PhotometricFile readTm33(std::string_view bytes, const std::string& fileName) {
  return Reader(bytes, fileName).read();
}

}  // namespace goniolux::photometry
