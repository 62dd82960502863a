// IES TM-33 (ANSI/IES TM-33-18 = UNI 11733, TM-33-23, ATLA S001): luminaire optical data as XML: intensities, emission
// areas and the spectrum of the emitter. Also the two look-alikes that are met in the wild (LuminaireOpticalData,
// IESXML), with a warning.
#pragma once

#include <string>
#include <string_view>

#include "photometry/photometric_file.h"

namespace goniolux::photometry {

/// True when the root element is one of TM-33 or of its look-alikes.
bool looksLikeTm33(std::string_view bytes);

/// Reads a whole file. Lengths are metres by the standard; a luminaire of more than 20 m is taken as millimetres, with
/// a warning. Photon or radiant intensities are read where there are no candelas, unconverted (PhotometricFile::
/// radiometric).
PhotometricFile readTm33(std::string_view bytes, const std::string& fileName);

}  // namespace goniolux::photometry
