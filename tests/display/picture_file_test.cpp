#include "display/picture_file.h"

#include <gtest/gtest.h>
#include <lcms2.h>
#include <png.h>
#include <tiffio.h>

#include <string>

#include "core/diagnostics.h"
#include "display/icc_profile.h"
#include "support/temporary_folder.h"

namespace goniolux::display {
namespace {

CodeImage pattern(int bits) {
  CodeImage image;
  image.width = 37;
  image.height = 5;
  image.bits = bits;
  for (int i = 0; i < 3 * 37 * 5; ++i) {
    image.rgb.push_back(static_cast<std::uint16_t>(bits == 8 ? (i * 7) & 0xFF : (i * 1237) & 0xFFFF));
  }
  return image;
}

TEST(PictureFile, EightBitPngComesBackToTheCode) {
  const CodeImage image = pattern(8);
  const std::string bytes = encodePng(image, readDevice("srgb"));
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()));
  EXPECT_EQ(header.width, 37U);
  EXPECT_EQ(header.height, 5U);
  header.format = PNG_FORMAT_RGB;
  std::vector<png_byte> codes(PNG_IMAGE_SIZE(header));
  ASSERT_TRUE(png_image_finish_read(&header, nullptr, codes.data(), 0, nullptr));
  for (std::size_t i = 0; i < codes.size(); ++i) ASSERT_EQ(codes[i], image.rgb[i]);
}

TEST(PictureFile, SixteenBitPngIsBigEndianAndSaysSo) {
  const CodeImage image = pattern(16);
  const std::string bytes = encodePng(image, readDevice("srgb"));
  EXPECT_EQ(bytes[24], 16) << "bit depth stands in byte 24 of a PNG";
  struct Reading {
    const std::string& bytes;
    std::size_t position;
  } reading{bytes, 0};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &reading, [](png_structp p, png_bytep into, std::size_t count) {
    auto& source = *static_cast<Reading*>(png_get_io_ptr(p));
    source.bytes.copy(reinterpret_cast<char*>(into), count, source.position);
    source.position += count;
  });
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_bytepp rows = png_get_rows(png, info);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const png_byte* value = rows[i / 111] + 2 * (i % 111);
    ASSERT_EQ(value[0] << 8 | value[1], image.rgb[i]);
  }
  png_destroy_read_struct(&png, &info, nullptr);
}

TEST(PictureFile, PngNamesItsColourSpace) {
  const std::string srgb = encodePng(pattern(8), readDevice("srgb"));
  EXPECT_NE(srgb.find("sRGB"), std::string::npos);
  EXPECT_EQ(srgb.find("iCCP"), std::string::npos);
  const std::string p3 = encodePng(pattern(8), readDevice("display-p3"));
  EXPECT_NE(p3.find("iCCP"), std::string::npos);
  EXPECT_EQ(p3.find("sRGB"), std::string::npos);
}

TEST(PictureFile, TiffComesBackToTheCodeWithItsProfile) {
  const test::TemporaryFolder folder;
  const Device device = readDevice("adobe-rgb");
  const CodeImage image = pattern(16);
  const std::string path = (folder.path() / "picture.tif").string();
  writePicture(path, image, device);
  TIFF* tiff = TIFFOpen(path.c_str(), "r");
  ASSERT_NE(tiff, nullptr);
  std::uint32_t profileSize = 0;
  const void* profile = nullptr;
  ASSERT_EQ(TIFFGetField(tiff, TIFFTAG_ICCPROFILE, &profileSize, &profile), 1);
  EXPECT_EQ(std::string(static_cast<const char*>(profile), profileSize), iccProfile(device));
  std::vector<std::uint16_t> row(3 * 37);
  for (std::uint32_t y = 0; y < 5; ++y) {
    ASSERT_EQ(TIFFReadScanline(tiff, row.data(), y, 0), 1);
    for (std::size_t i = 0; i < row.size(); ++i) ASSERT_EQ(row[i], image.rgb[y * row.size() + i]);
  }
  TIFFClose(tiff);
}

TEST(PictureFile, ProfileGivesTheSameColoursAsTheMatrix) {
  // Little CMS turns device codes into XYZ relative to D50; the matrix, adapted by Bradford, must agree. White is
  // enough of a check of the adaptation, the primaries of the matrix, mid grey of the curve.
  for (const auto& name : presetNames()) {
    const Device device = readDevice(name);
    if (device.kind != Device::Kind::monitor) continue;
    const std::string bytes = iccProfile(device);
    const cmsHPROFILE profile = cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size()));
    ASSERT_NE(profile, nullptr) << name;
    const cmsHPROFILE xyz = cmsCreateXYZProfile();
    const cmsHTRANSFORM transform =
        cmsCreateTransform(profile, TYPE_RGB_DBL, xyz, TYPE_XYZ_DBL, INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE);
    const double codes[2][3] = {{1, 1, 1}, {0.5, 0.5, 0.5}};
    double values[2][3];
    cmsDoTransform(transform, codes, values, 2);
    EXPECT_NEAR(values[0][0], 0.9642, 5e-4) << name;
    EXPECT_NEAR(values[0][1], 1.0000, 5e-4) << name;
    EXPECT_NEAR(values[0][2], 0.8249, 5e-4) << name;
    const TransferCurve& curve = device.transfer[1];  // of the largest code: PQ goes beyond white
    EXPECT_NEAR(values[1][1], curve.decode(0.5) / curve.decode(1), 5e-4) << name;
    cmsDeleteTransform(transform);
    cmsCloseProfile(xyz);
    cmsCloseProfile(profile);
  }
}

TEST(PictureFile, EveryLosslessFormatComesBackToTheCode) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.png", "a.tif", "a.dpx"})
    for (const int bits : bitsOf(pictureFormat(name))) {
      CodeImage image = pattern(bits);
      if (bits == 10)
        for (auto& code : image.rgb) code = static_cast<std::uint16_t>(code & 0x3FF);
      const std::string path = (folder.path() / name).string();
      writePicture(path, image, readDevice("srgb"));
      const CodeImage back = readPicture(path);
      EXPECT_EQ(back.width, image.width) << name;
      EXPECT_EQ(back.bits, bits) << name;
      EXPECT_EQ(back.rgb, image.rgb) << name << " " << bits;
    }
}

TEST(PictureFile, DamagedPicturesAreRefused) {
  const CodeImage image = pattern(8);
  CodeImage ten = image;
  ten.bits = 10;
  const Device device = readDevice("srgb");
  const std::string png = encodePng(image, device), tiff = encodeTiff(pattern(16), device),
                    dpx = encodeDpx(ten, device);
  for (std::size_t size = 0; size < png.size(); size += 17)
    EXPECT_THROW(decodePng(png.substr(0, size), "cut"), core::InputError) << size;
  for (std::size_t size = 0; size < dpx.size(); size += 97)
    EXPECT_THROW(decodeDpx(dpx.substr(0, size), "cut"), core::InputError) << size;
  for (std::size_t size = 0; size < 200; size += 13)  // further on stand the profile and texts
    EXPECT_THROW(decodeTiff(tiff.substr(0, size), "cut"), core::InputError) << size;
}

TEST(PictureFile, PqPngSaysSoInItsOwnChunk) {
  const std::string bytes = encodePng(pattern(16), readDevice("rec2020-pq"));
  const std::size_t chunk = bytes.find("cICP");
  ASSERT_NE(chunk, std::string::npos);
  EXPECT_EQ(bytes.substr(chunk + 4, 4), std::string("\x09\x10\x00\x01", 4));  // BT.2020, ST 2084, RGB, full range
  EXPECT_LT(chunk, bytes.find("IDAT"));
}

TEST(PictureFile, ProfileDependsOnTheDeviceAlone) {
  EXPECT_EQ(iccProfile(readDevice("srgb")), iccProfile(readDevice("srgb")));
}

TEST(PictureFile, OtherEndingsAreRefused) {
  for (const char* path : {"a.gif", "a.exe", "a", ""}) EXPECT_THROW(pictureFormat(path), core::InputError) << path;
  EXPECT_EQ(pictureFormat("A.PNG"), PictureFormat::png);
  EXPECT_EQ(pictureFormat("b.tiff"), PictureFormat::tiff);
  EXPECT_EQ(pictureFormat("c.JPEG"), PictureFormat::jpeg);
  EXPECT_EQ(pictureFormat("d.dpx"), PictureFormat::dpx);
  EXPECT_EQ(pictureFormat("e.exr"), PictureFormat::exr);
}

TEST(PictureFile, FailureLeavesTheEarlierFile) {
  const test::TemporaryFolder folder;
  const auto earlier = folder.write("view.gif", "earlier");
  EXPECT_THROW(writePicture(earlier.string(), pattern(8), readDevice("srgb")), core::InputError);
  EXPECT_EQ(test::contentOf(earlier), "earlier");
}

}  // namespace
}  // namespace goniolux::display
