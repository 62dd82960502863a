// IES TM-27-14, "IES Standard Format for the Electronic Transfer of Spectral Data". The only file of this room that
// uses the XML parser.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "spectrum/spectrum_table.h"

namespace goniolux::spectrum {
namespace {

std::string_view localName(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

std::optional<double> number(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(blanks) + 1 - first);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

class Places {
 public:
  Places(const std::string& text, const std::string& name) : text_(text), name_(name) {}
  [[nodiscard]] core::SourcePosition at(std::ptrdiff_t offset) const {
    if (offset < 0) return {name_, 0, 0};
    const auto end = text_.begin() + std::min<std::ptrdiff_t>(offset, static_cast<std::ptrdiff_t>(text_.size()));
    const auto line = std::count(text_.begin(), end, '\n') + 1;
    const auto lineStart = std::find(std::make_reverse_iterator(end), text_.rend(), '\n').base();
    return {name_, static_cast<int>(line), static_cast<int>(end - lineStart) + 1};
  }

 private:
  const std::string& text_;
  const std::string& name_;
};

}  // namespace

SpectrumTable parseTm27(const std::string& text, const std::string& name, core::Diagnostics& diagnostics) {
  SpectrumTable table;
  const Places places(text, name);
  pugi::xml_document document;
  const auto parsed = document.load_buffer(text.data(), text.size());
  if (!parsed) {
    diagnostics.error(places.at(parsed.offset), "xml",
                      fmt::format("this is not well-formed XML: {}", parsed.description()));
    return table;
  }
  const pugi::xml_node root = document.document_element();
  const pugi::xml_node data =
      root.find_child([](const pugi::xml_node& node) { return localName(node) == "SpectralDistribution"; });
  if (!data) {
    diagnostics.error(places.at(root.offset_debug()), "tm27",
                      fmt::format("no SpectralDistribution found inside <{}>; is this a TM-27 file?", root.name()));
    return table;
  }
  for (const pugi::xml_node& node : data.children()) {
    if (localName(node) == "SpectralQuantity") {
      table.quantity = node.child_value();
      table.quantityAt = places.at(node.offset_debug());
    }
    if (localName(node) != "SpectralData") continue;
    const core::SourcePosition at = places.at(node.offset_debug());
    const auto wavelength = number(node.attribute("wavelength").value());
    const auto value = number(node.child_value());
    if (!wavelength) {
      diagnostics.error(at, "not-a-number", "this SpectralData has no wavelength that is a number");
    } else if (!value) {
      diagnostics.error(at, "not-a-number", "the content of this SpectralData is not a number");
    } else {
      table.rows.push_back({*wavelength, *value, at, at});
    }
  }
  return table;
}

}  // namespace goniolux::spectrum
