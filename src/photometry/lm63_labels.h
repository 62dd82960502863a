// The text part of an LM-63 file: format line, [KEYWORD] labels, and the TILT= line that ends it.
#pragma once

#include <map>
#include <string>

#include "core/diagnostics.h"
#include "core/text.h"
#include "photometry/lm63.h"

namespace goniolux::photometry {

struct Lm63Labels {
  Lm63Edition edition = Lm63Edition::e1986;
  std::map<std::string, std::string> keywords;  ///< upper-case keys, UTF-8 values; [MORE] and repeats are further lines
  bool radiometric = false;                     ///< a label says that the values are mW/sr
  std::string tilt;                             ///< what stands after "TILT="
  core::SourcePosition tiltAt;
};

/// "LM-63-2002".
const char* lm63EditionName(Lm63Edition edition);

/// Reads from the start of the file through the TILT= line; InputError when there is none.
Lm63Labels readLm63Labels(core::TextScanner& scanner, core::Encoding encoding, const std::string& fileName,
                          core::Diagnostics& warnings);

}  // namespace goniolux::photometry
