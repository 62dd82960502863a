#include "display/png_rows.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

#include "core/diagnostics.h"
#include "core/parallel.h"

namespace goniolux::display {
namespace {

// Fast compression: pictures of a calculation are noisy, so that thorough search gains a few per cent for several times
// the time.
constexpr int compressionLevel = 2;
constexpr int bandRows = 64;

struct Band {
  std::string bytes;
  uLong checksum = 0;
  std::size_t length = 0;  // of what was compressed
};

// A row's filter type, and each sample less the one to its left, byte by byte (PNG 9.2, type 1).
void appendRow(const CodeImage& image, int y, std::vector<unsigned char>& filtered) {
  const std::size_t values = 3 * static_cast<std::size_t>(image.width);
  const std::uint16_t* codes = image.rgb.data() + static_cast<std::size_t>(y) * values;
  filtered.push_back(1);
  const std::size_t start = filtered.size();
  if (image.bits == 8) {
    filtered.resize(start + values);
    unsigned char* out = filtered.data() + start;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, values); ++i) out[i] = static_cast<unsigned char>(codes[i]);
    for (std::size_t i = 3; i < values; ++i) out[i] = static_cast<unsigned char>(codes[i] - codes[i - 3]);
    return;
  }
  filtered.resize(start + 2 * values);
  unsigned char* out = filtered.data() + start;
  for (std::size_t i = 0; i < values; ++i) {  // PNG is big-endian
    const int left = i < 3 ? 0 : codes[i - 3];
    out[2 * i] = static_cast<unsigned char>((codes[i] >> 8) - (left >> 8));
    out[2 * i + 1] = static_cast<unsigned char>((codes[i] & 0xFF) - (left & 0xFF));
  }
}

Band compressed(const CodeImage& image, int from, int to) {
  std::vector<unsigned char> filtered;
  filtered.reserve(static_cast<std::size_t>(to - from) * (1 + 6 * static_cast<std::size_t>(image.width)));
  for (int y = from; y < to; ++y) appendRow(image, y, filtered);
  Band band;
  band.length = filtered.size();
  band.checksum = adler32(adler32(0, nullptr, 0), filtered.data(), static_cast<uInt>(filtered.size()));
  z_stream stream{};
  if (deflateInit2(&stream, compressionLevel, Z_DEFLATED, -15, 9, Z_FILTERED) != Z_OK)
    throw core::RunError("the picture cannot be compressed: no memory");
  // A sync marker takes five bytes; the bound is that of the whole stream.
  band.bytes.resize(deflateBound(&stream, static_cast<uLong>(filtered.size())) + 16);
  stream.next_in = filtered.data();
  stream.avail_in = static_cast<uInt>(filtered.size());
  stream.next_out = reinterpret_cast<unsigned char*>(band.bytes.data());
  stream.avail_out = static_cast<uInt>(band.bytes.size());
  deflate(&stream, to == image.height ? Z_FINISH : Z_SYNC_FLUSH);
  band.bytes.resize(band.bytes.size() - stream.avail_out);
  band.bytes.shrink_to_fit();
  const bool complete = stream.avail_in == 0;
  deflateEnd(&stream);
  if (!complete) throw core::RunError("the picture cannot be compressed");
  return band;
}

}  // namespace

std::string compressedRows(const CodeImage& image) {
  std::vector<Band> bands(static_cast<std::size_t>((image.height + bandRows - 1) / bandRows));
  core::parallelFor(bands.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
      bands[b] =
          compressed(image, static_cast<int>(b) * bandRows, std::min(image.height, static_cast<int>(b + 1) * bandRows));
  });
  std::string bytes = "\x78\x01";  // window of 32 kB, fast
  uLong checksum = adler32(0, nullptr, 0);
  for (const Band& band : bands) {
    bytes += band.bytes;
    checksum = adler32_combine(checksum, band.checksum, static_cast<z_off_t>(band.length));
  }
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<char>(checksum >> shift & 0xFF));
  return bytes;
}

}  // namespace goniolux::display
