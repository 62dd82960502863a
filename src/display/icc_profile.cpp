#include "display/icc_profile.h"

#include <lcms2.h>

#include <cmath>
#include <memory>
#include <vector>

#include "core/diagnostics.h"

namespace goniolux::display {
namespace {

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
struct FreeCurve {
  void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
};
struct FreeText {
  void operator()(cmsMLU* text) const { cmsMLUfree(text); }
};

using ToneCurve = std::unique_ptr<cmsToneCurve, FreeCurve>;

// ICC parametric curves run from code value to light: Y = (a V + b)^g from V = d on, c V below (type 4 of Little CMS).
// Other forms become tables, light relative to that of the largest code value.
ToneCurve toneCurve(const TransferCurve& curve) {
  if (curve.form == TransferCurve::Form::power) {
    const double parameters[] = {curve.gamma, 1 / (1 + curve.offset), curve.offset / (1 + curve.offset),
                                 curve.slope > 0 ? 1 / curve.slope : 0, curve.slope * curve.threshold};
    return ToneCurve(cmsBuildParametricToneCurve(nullptr, 4, parameters));
  }
  constexpr int entries = 4096;
  std::vector<cmsUInt16Number> table;
  for (int i = 0; i < entries; ++i)
    table.push_back(static_cast<cmsUInt16Number>(
        std::lround(65535 * curve.decode(static_cast<double>(i) / (entries - 1)) / curve.decode(1))));
  return ToneCurve(cmsBuildTabulatedToneCurve16(nullptr, entries, table.data()));
}

void describe(void* profile, cmsTagSignature tag, const std::string& content) {
  const std::unique_ptr<cmsMLU, FreeText> text(cmsMLUalloc(nullptr, 1));
  cmsMLUsetASCII(text.get(), "en", "US", content.c_str());
  cmsWriteTag(profile, tag, text.get());
}

// Bytes 24 to 35 of the header hold the date of making (ICC.1:2010, 7.2): the same device shall give the same file.
void removeDate(std::string& bytes) {
  constexpr char fixed[12] = {0x07, static_cast<char>(0xD0), 0, 1, 0, 1, 0, 0, 0, 0, 0, 0};  // 2000-01-01
  bytes.replace(24, sizeof(fixed), fixed, sizeof(fixed));
}

}  // namespace

std::string iccProfile(const Device& device) {
  if (device.kind == Device::Kind::icc) return device.profile;
  if (device.kind == Device::Kind::film) return "";
  const cmsCIExyY white{device.white.x, device.white.y, 1};
  const cmsCIExyYTRIPLE primaries{
      {device.red.x, device.red.y, 1}, {device.green.x, device.green.y, 1}, {device.blue.x, device.blue.y, 1}};
  const ToneCurve red = toneCurve(device.transfer[0]), green = toneCurve(device.transfer[1]),
                  blue = toneCurve(device.transfer[2]);
  cmsToneCurve* const curves[] = {red.get(), green.get(), blue.get()};
  const std::unique_ptr<void, CloseProfile> profile(cmsCreateRGBProfile(&white, &primaries, curves));
  cmsUInt32Number size = 0;
  if (profile) {
    describe(profile.get(), cmsSigProfileDescriptionTag, device.name);
    describe(profile.get(), cmsSigCopyrightTag, "No copyright, use freely");
    if (device.white_cd_m2 > 0) {
      const cmsCIEXYZ luminance{0, device.white_cd_m2, 0};  // only Y counts (ICC.1, luminanceTag)
      cmsWriteTag(profile.get(), cmsSigLuminanceTag, &luminance);
    }
    cmsSaveProfileToMem(profile.get(), nullptr, &size);
  }
  std::string bytes(size, '\0');
  if (size < 128 || !cmsSaveProfileToMem(profile.get(), bytes.data(), &size)) {
    throw core::RunError("no ICC profile can be made for the device " + device.name);
  }
  removeDate(bytes);
  return bytes;
}

}  // namespace goniolux::display
