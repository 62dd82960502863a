// Fresnel's equations for smooth interfaces, unpolarised light in and out. Cosines are of the angle of incidence, from
// 0 to 1; indices are relative: of the medium beyond, divided by that of the medium where the light comes from.
// Source: M. Born and E. Wolf, Principles of Optics, 7th ed., sections 1.5.2 and 14.2.
#pragma once

namespace goniolux::reflection {

/// Reflectances for light polarised perpendicular (s) and parallel (p) to the plane of incidence.
struct PolarisedReflectance {
  double s = 1, p = 1;
  [[nodiscard]] double mean() const { return 0.5 * (s + p); }
};

/// Cosine of the refracted ray (Snell); 0 when all light is reflected.
double refractedCosine(double cosine, double relativeIndex);
/// Between dielectrics; 1 from the critical angle on.
PolarisedReflectance dielectricReflectance(double cosine, double relativeIndex);
/// Of a metal with the complex index n + ik.
PolarisedReflectance conductorReflectance(double cosine, double n, double k);

/// Reflectance and transmittance of a plane-parallel pane, all reflections inside it added up incoherently.
struct Slab {
  double reflectance = 0, transmittance = 0;
};
/// `attenuation` in 1/m (Bouguer), `thickness` in m. Polarisations are averaged after the series: averaged before, a
/// pane of index 1.52 is 1.3 points too clear at 60 degrees.
Slab slab(double cosine, double relativeIndex, double attenuation, double thickness);

/// Mean of the reflectance over Lambertian incidence, 2 integral of R(mu) mu dmu, by Gauss quadrature.
double diffuseDielectricReflectance(double relativeIndex);
double diffuseConductorReflectance(double n, double k);

}  // namespace goniolux::reflection
