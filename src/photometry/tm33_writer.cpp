#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/markup.h"
#include "photometry/writers.h"

namespace goniolux::photometry {
namespace {

std::string element(const char* indent, const char* name, const std::string& content) {
  return fmt::format("{}<{}>{}</{}>\n", indent, name, core::escapedMarkup(content), name);
}

std::string headerText(const PhotometricFile& file) {
  static constexpr std::array<std::pair<const char*, std::array<const char*, 2>>, 6> keys{
      {{"Manufacturer", {"MANUFAC", ""}},
       {"CatalogNumber", {"LUMCAT", ""}},
       {"Description", {"LUMINAIRE", ""}},
       {"Laboratory", {"TESTLAB", ""}},
       {"ReportNumber", {"TEST", ""}},
       {"ReportDate", {"ISSUEDATE", "DATE"}}}};
  std::string text = "  <Header>\n";
  for (const auto& [name, keywords] : keys) {
    for (const char* keyword : keywords) {
      const auto found = file.keywords.find(keyword);
      if (found == file.keywords.end()) continue;
      text += element("    ", name, found->second);
      break;
    }
  }
  return text + "    <DocumentCreator>Goniolux</DocumentCreator>\n  </Header>\n";
}

const char* symmetryText(HorizontalSymmetry symmetry) {
  switch (symmetry) {
    case HorizontalSymmetry::rotational:
      return "Symm_Full";
    case HorizontalSymmetry::quadrant:
      return "Symm_Quad";
    case HorizontalSymmetry::aboutC0:
      return "Symm_Bi0";
    case HorizontalSymmetry::aboutC90:
      return "Symm_Bi90";
    default:
      return "Symm_None";
  }
}

std::string intensityText(const PhotometricFile& file) {
  const TabulatedDistribution& d = *file.distribution;
  const std::size_t planes = d.horizontalAngles().size(), angles = d.verticalAngles().size();
  const bool photons = file.fluxUnit == "umol/s";
  const char* quantity = !file.radiometric ? "Luminous" : photons ? "Photon" : "Radiant";
  std::string text = fmt::format("    <{0}Data>\n      <{0}Intensity>\n", quantity);
  text += element("        ", "AbsolutePhotometry", file.declaredLumens ? "false" : "true");
  text += element("        ", "Symm", symmetryText(d.symmetry()));
  text += element("        ", "NumberMeasured", fmt::format("{}", planes * angles));
  text += element("        ", "NumberHorz", fmt::format("{}", planes));
  text += element("        ", "NumberVert", fmt::format("{}", angles));
  for (std::size_t h = 0; h < planes; ++h)
    for (std::size_t v = 0; v < angles; ++v)
      text += fmt::format("        <IntData h=\"{}\" v=\"{}\">{}</IntData>\n", d.horizontalAngles()[h],
                          d.verticalAngles()[v], d.candela(h, v));
  text += fmt::format("      </{}Intensity>\n", quantity);
  if (file.declaredLuminaireLumens && !file.radiometric)
    text += element("      ", "LuminousFlux", fmt::format("{}", *file.declaredLuminaireLumens));
  return text + fmt::format("    </{}Data>\n", quantity);
}

std::string openingText(const PhotometricFile& file, core::Diagnostics& warnings) {
  const StatedOpening& o = file.opening;
  using Shape = StatedOpening::Shape;
  if (o.shape == Shape::point || o.shape == Shape::other) return "";
  const bool plain = o.axis == StatedOpening::Axis::aim && o.height == 0 &&
                     (o.shape == Shape::rectangle || (o.shape == Shape::disc && o.length == o.width));
  if (!plain) {
    warnings.warning({file.file, 0, 0}, "opening-lost",
                     "TM-33's emission areas are flat; the opening's area of the bottom face is written");
  }
  const double length = o.lengthAlongC90 ? o.width : o.length, width = o.lengthAlongC90 ? o.length : o.width;
  if (!(length > 0) || !(width > 0)) return "";
  const std::string size = o.shape == Shape::disc && o.length == o.width
                               ? fmt::format("<Diameter>{}</Diameter>", length)
                               : fmt::format("<Length>{}</Length><Width>{}</Width>", length, width);
  return "    <EmissionAreas>\n      <BottomFace>\n        <NumberBottom>1</NumberBottom>\n        <BottomArea>" +
         size + "</BottomArea>\n      </BottomFace>\n    </EmissionAreas>\n";
}

std::string spectrumText(const PhotometricFile& file) {
  if (!file.spectrum || file.spectrum->samples().empty()) return "";
  const auto samples = file.spectrum->samples();
  std::string text = "    <SpectralData>\n      <EmitterSpectral>\n";
  text += element("        ", "NumberWavelength", fmt::format("{}", samples.size()));
  for (const auto& sample : samples)
    text += fmt::format("        <PwrData w=\"{}\">{}</PwrData>\n", sample.wavelength, sample.value);
  return text + "      </EmitterSpectral>\n    </SpectralData>\n";
}

}  // namespace

std::string writeTm33(const PhotometricFile& file, core::Diagnostics& warnings) {
  const TabulatedDistribution& d = *file.distribution;
  const char* type = d.type() == PhotometryType::c ? "IES_C" : d.type() == PhotometryType::b ? "IES_B" : "IES_A";
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<IESTM33>\n  <Version>1.0</Version>\n";
  text += headerText(file);
  text += fmt::format(
      "  <Luminaire>\n    <Dimensions><Length>{}</Length><Width>{}</Width><Height>{}</Height></Dimensions>\n"
      "    <NumEmitter>1</NumEmitter>\n  </Luminaire>\n",
      file.opening.lengthAlongC90 ? file.opening.width : file.opening.length,
      file.opening.lengthAlongC90 ? file.opening.length : file.opening.width, file.opening.height);
  text += fmt::format(
      "  <Equipment>\n    <Gonioradiometer>\n      <Type>{}</Type>\n    </Gonioradiometer>\n  </Equipment>\n", type);
  text += "  <Emitter>\n    <Quantity>1</Quantity>\n";
  if (file.declaredLumens) text += element("    ", "RatedLumens", fmt::format("{}", *file.declaredLumens));
  if (file.inputWatts > 0) text += element("    ", "InputWattage", fmt::format("{}", file.inputWatts));
  text += intensityText(file) + spectrumText(file) + openingText(file, warnings);
  return text + "  </Emitter>\n</IESTM33>\n";
}

}  // namespace goniolux::photometry
