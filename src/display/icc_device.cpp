#include "display/icc_device.h"

#include <lcms2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/diagnostics.h"

namespace goniolux::display {
namespace {

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
struct DeleteTransform {
  void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using Profile = std::unique_ptr<void, CloseProfile>;
using Transform = std::unique_ptr<void, DeleteTransform>;

Profile opened(const std::string& bytes) {
  return Profile(cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
}

// Little CMS takes X, Y, Z in single precision as they are: D50 has Y = 1.
constexpr cmsUInt32Number light = TYPE_XYZ_FLT, codes = TYPE_RGB_FLT;
// No cache: one transform serves all threads. No optimisation: it would put a grid of few bits in the way.
constexpr cmsUInt32Number flags = cmsFLAGS_NOCACHE | cmsFLAGS_NOOPTIMIZE;

struct Transforms {
  Transform toCodes, toLight;
};

Transforms transformsOf(const std::string& bytes) {
  const Profile device = opened(bytes), xyz(cmsCreateXYZProfile());
  Transforms result;
  if (!device || !xyz) return result;
  result.toCodes.reset(cmsCreateTransform(xyz.get(), light, device.get(), codes, INTENT_RELATIVE_COLORIMETRIC, flags));
  result.toLight.reset(cmsCreateTransform(device.get(), codes, xyz.get(), light, INTENT_RELATIVE_COLORIMETRIC, flags));
  return result;
}

class IccModel final : public DeviceModel {
 public:
  explicit IccModel(const std::string& bytes) : transforms_(transformsOf(bytes)) {}

  void toDevice(std::span<glm::vec3> pixels) const override {
    const auto count = static_cast<cmsUInt32Number>(pixels.size());
    const std::vector<glm::vec3> wanted(pixels.begin(), pixels.end());
    std::vector<glm::vec3> shown(pixels.size());
    cmsDoTransform(transforms_.toCodes.get(), wanted.data(), pixels.data(), count);
    cmsDoTransform(transforms_.toLight.get(), pixels.data(), shown.data(), count);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const glm::vec3 apart = glm::abs(shown[i] - wanted[i]);
      const float largest = std::max({wanted[i].x, wanted[i].y, wanted[i].z, 0.0F});
      const bool inside = pixels[i].x >= 0 && pixels[i].x <= 1 && pixels[i].y >= 0 && pixels[i].y <= 1 &&
                          pixels[i].z >= 0 && pixels[i].z <= 1;
      // Tables of 8 and 16 bits err by some thousandths; a colour that was clipped inside errs by more.
      if (inside && std::max({apart.x, apart.y, apart.z}) > 0.004F + 0.02F * largest)
        pixels[i] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    }
  }
  void toLight(std::span<glm::vec3> pixels) const override {
    std::vector<glm::vec3> values(pixels.begin(), pixels.end());
    cmsDoTransform(transforms_.toLight.get(), values.data(), pixels.data(),
                   static_cast<cmsUInt32Number>(pixels.size()));
  }
  [[nodiscard]] double encode(int, double value) const override { return value; }
  [[nodiscard]] double decode(int, double code) const override { return code; }
  [[nodiscard]] bool isLinear() const override { return false; }

 private:
  Transforms transforms_;
};

[[noreturn]] void refuse(const std::string& path, std::string message) {
  throw core::InputError({path, 0, 0}, "icc-profile", std::move(message));
}

}  // namespace

bool isIccProfile(std::string_view bytes) {
  return bytes.size() >= 128 && bytes.substr(36, 4) == "acsp";
}

Device iccDevice(std::string bytes, const std::string& path) {
  const Profile profile = opened(bytes);
  if (!profile) refuse(path, "the ICC profile cannot be read, it is damaged; export it anew");
  if (cmsGetColorSpace(profile.get()) != cmsSigRgbData)
    refuse(path, "the ICC profile is not of an RGB device; give the profile of a monitor, projector or film recorder");
  const Transforms transforms = transformsOf(bytes);
  if (!transforms.toCodes || !transforms.toLight)
    refuse(path, "the ICC profile is damaged, or lacks the tables that turn colours into device values");
  const glm::vec3 full(1);
  glm::vec3 white(0);
  cmsDoTransform(transforms.toLight.get(), &full, &white, 1);
  if (!std::isfinite(white.x + white.y + white.z) || !(white.y > 0.2F && white.y < 5.0F))
    refuse(path, "the ICC profile gives its white no sensible luminance; it is damaged");

  Device device;
  device.kind = Device::Kind::icc;
  char text[256] = "";
  cmsGetProfileInfoASCII(profile.get(), cmsInfoDescription, "en", "US", text, sizeof(text));
  device.name = text[0] != 0 ? text : "ICC profile";
  device.source = path;
  const cmsCIExyY d50 = *cmsD50_xyY();
  device.white = {d50.x, d50.y};
  if (const auto* luminance = static_cast<const cmsCIEXYZ*>(cmsReadTag(profile.get(), cmsSigLuminanceTag));
      luminance != nullptr && luminance->Y > 0 && luminance->Y < 1e5)
    device.white_cd_m2 = luminance->Y;
  device.profile = std::move(bytes);
  return device;
}

std::unique_ptr<DeviceModel> makeIccModel(const Device& device) {
  return std::make_unique<IccModel>(device.profile);
}

}  // namespace goniolux::display
