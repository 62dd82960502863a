#include "photometry/writers.h"

#include <fmt/format.h>

#include <array>

#include "core/text.h"

namespace goniolux::photometry {

std::string writePhotometry(const PhotometricFile& file, const std::string& fileName, core::Diagnostics& warnings) {
  struct Writer {
    const char* extension;
    std::string (*write)(const PhotometricFile&, core::Diagnostics&);
  };
  static constexpr std::array<Writer, 5> writers{{{".ies", writeLm63},
                                                  {".ldt", writeEulumdat},
                                                  {".xml", writeTm33},
                                                  {".tm33", writeTm33},
                                                  {".iesxml", writeTm33}}};
  const std::string lower = core::lowerCase(fileName);
  for (const Writer& writer : writers)
    if (lower.ends_with(writer.extension)) return writer.write(file, warnings);
  throw core::InputError({fileName, 0, 0}, "unknown-format",
                         "photometric files are written as .ies (LM-63-2019), .ldt (EULUMDAT) or .xml (TM-33-18); name "
                         "the file so");
}

}  // namespace goniolux::photometry
