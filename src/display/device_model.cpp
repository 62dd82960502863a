#include "display/device_model.h"

#include "display/film.h"
#include "display/icc_device.h"

namespace goniolux::display {
namespace {

class Monitor final : public DeviceModel {
 public:
  explicit Monitor(const Device& device) : transfer_(device.transfer) {
    const core::Mat3 matrix = xyzFromRgb(device);
    const core::Vec3 white = matrix * core::Vec3(1);
    const double black = device.white_cd_m2 > 0 ? device.black_cd_m2 / device.white_cd_m2 : 0;
    offset_ = glm::vec3(white * darkest(device));
    light_ = glm::mat3(matrix * (1 - black));
    values_ = glm::mat3(glm::inverse(matrix) / (1 - black));
  }
  void toDevice(std::span<glm::vec3> pixels) const override {
    for (glm::vec3& pixel : pixels) pixel = values_ * (pixel - offset_);
  }
  void toLight(std::span<glm::vec3> pixels) const override {
    for (glm::vec3& pixel : pixels) pixel = light_ * pixel + offset_;
  }
  [[nodiscard]] double encode(int channel, double value) const override {
    return transfer_[static_cast<std::size_t>(channel)].encode(value);
  }
  [[nodiscard]] double decode(int channel, double code) const override {
    return transfer_[static_cast<std::size_t>(channel)].decode(code);
  }
  [[nodiscard]] bool isLinear() const override { return true; }

 private:
  std::array<TransferCurve, 3> transfer_;
  glm::vec3 offset_{0};
  glm::mat3 light_{1}, values_{1};
};

}  // namespace

std::unique_ptr<DeviceModel> makeModel(const Device& device) {
  switch (device.kind) {
    case Device::Kind::film:
      return makeFilmModel(device);
    case Device::Kind::icc:
      return makeIccModel(device);
    default:
      return std::make_unique<Monitor>(device);
  }
}

}  // namespace goniolux::display
