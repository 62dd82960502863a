// DeviceModel: a device as a function, both ways: from the light that it should show to device values and back.
//
// Light is X, Y, Z with the device's white at Y = 1, black level and flare included. Device values are linear in light
// for monitors, and code values for film and ICC profiles; in both cases what can be shown lies within 0..1.
#pragma once

#include <memory>
#include <span>

#include "core/vector.h"
#include "display/device.h"

namespace goniolux::display {

class DeviceModel {
 public:
  virtual ~DeviceModel() = default;

  /// Light to device values, in place; values outside 0..1, or NaN, cannot be shown. Safe from several threads.
  virtual void toDevice(std::span<glm::vec3> pixels) const = 0;
  /// Device values within 0..1 to light.
  virtual void toLight(std::span<glm::vec3> pixels) const = 0;
  /// Device value of a channel to code value, both 0..1, and back; the identity where device values are code values.
  [[nodiscard]] virtual double encode(int channel, double value) const = 0;
  [[nodiscard]] virtual double decode(int channel, double code) const = 0;
  /// Device values follow light linearly (gamut mapping then has a closed form).
  [[nodiscard]] virtual bool isLinear() const = 0;
};

/// The model keeps a reference to nothing: the device may go.
std::unique_ptr<DeviceModel> makeModel(const Device& device);

}  // namespace goniolux::display
