// The entries of the reflection-model registry, one function per model's file, and how they describe their parameters.
#pragma once

#include <string>

#include "reflection/bsdf.h"

namespace goniolux::reflection {

ReflectionModel lambertModel();
ReflectionModel orenNayarModel();
ReflectionModel mirrorModel();
ReflectionModel dielectricModel();
ReflectionModel conductorModel();
ReflectionModel wardModel();
ReflectionModel diffuseTransmissionModel();

/// A spectral reflectance or transmittance, 0 to 1.
core::Parameter fraction(std::string key, std::string title, bool required, std::string help, std::string source = "");
/// "" or that two fractions of a material exceed 1 together.
std::string sumComplaint(const material::Material& material, const char* first, const char* second);
/// A plain number.
core::Parameter plainNumber(std::string key, std::string title, double minimum, double maximum, std::string help);

}  // namespace goniolux::reflection
