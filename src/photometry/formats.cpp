// The registry of photometric formats, and the choice among them.
#include <algorithm>

#include "core/document.h"
#include "core/text.h"
#include "photometry/eulumdat.h"
#include "photometry/flux_check.h"
#include "photometry/lm63.h"
#include "photometry/photometric_file.h"
#include "photometry/rules.h"
#include "photometry/tm33.h"

namespace goniolux::photometry {
namespace {

bool isZip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

PhotometricFile refuseGldf(std::string_view, const std::string& fileName) {
  throw core::InputError(
      {fileName, 1, 1}, "not-supported",
      "not supported yet: GLDF container; unpack it (it is a zip archive) and give the LM-63, EULUMDAT or TM-33 file "
      "inside");
}

bool endsWith(const std::string& fileName, const std::vector<std::string>& extensions) {
  const std::string lower = core::lowerCase(fileName);
  return std::any_of(extensions.begin(), extensions.end(), [&](const std::string& e) { return lower.ends_with(e); });
}

}  // namespace

const std::vector<PhotometryFormat>& photometryFormats() {
  static const std::vector<PhotometryFormat> list{
      {"LM-63", "IES LM-63 photometric data, 1986 to 2019", {".ies"}, looksLikeLm63, readLm63},
      {"GLDF", "Global Lighting Data Format container", {".gldf"}, isZip, refuseGldf},
      {"TM-33", "IES TM-33 luminaire optical data, XML", {".xml", ".tm33", ".iesxml"}, looksLikeTm33, readTm33},
      {"EULUMDAT", "EULUMDAT luminaire data", {".ldt"}, looksLikeEulumdat, readEulumdat},
  };
  return list;
}

PhotometricFile readPhotometry(std::string_view bytes, const std::string& fileName, Strictness strictness) {
  const std::vector<PhotometryFormat>& formats = photometryFormats();
  auto format = std::find_if(formats.begin(), formats.end(), [&](const auto& f) { return f.recognises(bytes); });
  // A damaged file is best explained by the reader that its name asks for.
  if (format == formats.end()) {
    format =
        std::find_if(formats.begin(), formats.end(), [&](const auto& f) { return endsWith(fileName, f.extensions); });
  }
  if (format == formats.end()) {
    throw core::InputError(
        {fileName, 1, 1}, "unknown-format",
        "this is no photometric file that Goniolux knows; it reads LM-63 (.ies), EULUMDAT (.ldt) and TM-33 (.xml)");
  }
  PhotometricFile file = format->read(bytes, fileName);
  warnOfFluxes(file);
  if (strictness == Strictness::strict) refuseDepartures(file.warnings);
  return file;
}

PhotometricFile readPhotometricFile(const std::string& path, Strictness strictness) {
  return readPhotometry(core::readFile(path), path, strictness);
}

}  // namespace goniolux::photometry
