// LM-63: the IES photometric data file, editions 1986, 1991, 1995, 2002 and 2019; photometry types A, B and C.
// Lenient: what is unambiguous is read, and every assumption is a warning with line and rule.
#pragma once

#include <string>
#include <string_view>

#include "core/diagnostics.h"
#include "photometry/photometric_file.h"

namespace goniolux::photometry {

enum class Lm63Edition { e1986, e1991, e1995, e2002, e2019 };

/// True when the bytes have a TILT= line or begin with the format line of an edition.
bool looksLikeLm63(std::string_view bytes);

/// Reads a whole file. `fileName` stands in messages; a TILT file is looked for beside it.
PhotometricFile readLm63(std::string_view bytes, const std::string& fileName);

/// The luminous opening that the header's width, length and height (in the file's units) stand for, in metres. Negative
/// numbers mean round shapes; what each sign pattern means depends on the edition, and both spellings of a circle are
/// read in any edition.
StatedOpening lm63Opening(Lm63Edition edition, double width, double length, double height, double metresPerUnit);

}  // namespace goniolux::photometry
