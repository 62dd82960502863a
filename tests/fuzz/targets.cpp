#include "fuzz/targets.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "display/device_model.h"
#include "display/icc_device.h"
#include "display/picture_file.h"
#include "geometry/mesh_import.h"
#include "geometry/queries.h"
#include "geometry/radiance_scene.h"
#include "image/image_file.h"
#include "image/patch.h"
#include "photometry/eulumdat.h"
#include "photometry/flux_check.h"
#include "photometry/lm63.h"
#include "photometry/metrics.h"
#include "photometry/photometric_file.h"
#include "photometry/tm33.h"
#include "photometry/writers.h"
#include "spectrum/spectrum_files.h"

namespace goniolux::fuzz {
namespace {

using photometry::PhotometricFile;
using photometry::TabulatedDistribution;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz target: %s\n", what);
  std::abort();
}

// Whatever was read can be used: finite everywhere, and no larger than the bytes that it came from.
void requireUsable(const PhotometricFile& file, std::size_t bytes) {
  const TabulatedDistribution& d = *file.distribution;
  require(std::isfinite(d.flux()) && d.flux() >= 0, "the flux is no number or below 0");
  require(d.forwardFlux() <= d.flux() * (1 + 1e-9), "more light goes down than leaves");
  require(d.horizontalAngles().size() * d.verticalAngles().size() <= bytes, "the table is larger than its file");
  for (const core::Vec3& direction : {core::Vec3(0, 0, 1), core::Vec3(0, 0, -1), core::Vec3(1, 0, 0),
                                      core::Vec3(-0.48, 0.6, 0.64), core::Vec3(0, -0.8, -0.6)}) {
    const double intensity = d.intensity(direction);
    require(std::isfinite(intensity) && intensity >= 0 && intensity <= d.maximumIntensity() * (1 + 1e-12),
            "an intensity outside the table's range");
  }
  require(photometry::intensityPeak(d).intensity_cd == d.maximumIntensity(), "the peak is not the largest value");
  (void)photometry::fullWidth(d, photometry::PrincipalPlane::c0_180, 0.5);
  require(std::isfinite(photometry::zonalConstantFlux(d)), "the zonal flux is no number");
}

template <typename Read>
Outcome readOrRefuse(const Read& read) {
  try {
    read();
    return Outcome::read;
  } catch (const core::InputError& error) {
    require(!error.diagnostics().all().empty(), "refused without a reason");
    require(!error.diagnostics().all().back().message.empty(), "refused with an empty reason");
    return Outcome::refused;
  }
}

template <photometry::PhotometryReader Reader>
Outcome photometric(std::string_view bytes) {
  return readOrRefuse([&] { requireUsable(Reader(bytes, "fuzz"), bytes.size()); });
}

Outcome anyFormat(std::string_view bytes) {
  return readOrRefuse([&] { requireUsable(photometry::readPhotometry(bytes, "fuzz"), bytes.size()); });
}

// What is read is written and read back; LM-63 keeps every candela.
Outcome writers(std::string_view bytes) {
  return readOrRefuse([&] {
    const PhotometricFile file = photometry::readPhotometry(bytes, "fuzz");
    for (const char* name : {"fuzz.ies", "fuzz.xml", "fuzz.ldt"}) {
      core::Diagnostics warnings;
      if (std::string_view(name).ends_with(".ldt") && file.distribution->type() != photometry::PhotometryType::c)
        continue;
      const PhotometricFile back = photometry::readPhotometry(photometry::writePhotometry(file, name, warnings), name);
      require(back.distribution->maximumIntensity() == file.distribution->maximumIntensity() ||
                  std::string_view(name).ends_with(".ldt"),
              "a candela changed on its way through a file");
    }
  });
}

Outcome twoColumns(std::string_view bytes) {
  return readOrRefuse([&] {
    const auto s = spectrum::readSpectrum(std::string(bytes), "fuzz.spd", spectrum::Role::source);
    require(std::isfinite(s.integral()), "the integral is no number");
  });
}

Outcome tm27(std::string_view bytes) {
  return readOrRefuse([&] {
    const auto s = spectrum::readSpectrum(std::string(bytes), "fuzz.spdx", spectrum::Role::source);
    require(std::isfinite(s.integral()), "the integral is no number");
  });
}

// An image that was read has all its pixels; probing it ends.
Outcome imageFile(std::string_view bytes) {
  return readOrRefuse([&] {
    const image::XyzImage image = image::decodeImage(bytes, "fuzz");
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    require(count > 0 && image.x.size() == count && image.y.size() == count && image.z.size() == count,
            "the image has not all its pixels");
    (void)image::readPatch(image, 0, 0, 3);
  });
}

Outcome iccProfile(std::string_view bytes) {
  return readOrRefuse([&] {
    const display::Device device = display::iccDevice(std::string(bytes), "fuzz");
    const auto model = display::makeModel(device);
    std::vector<glm::vec3> light{{0.2F, 0.3F, 0.1F}, {0.9F, 1, 0.8F}};
    model->toDevice(light);
  });
}

template <auto Reader>
Outcome picture(std::string_view bytes) {
  return readOrRefuse([&] {
    const display::CodeImage image = [&] {
      if constexpr (std::is_invocable_v<decltype(Reader), std::string_view, std::string, double>)
        return Reader(bytes, "fuzz", 1e6);
      else
        return Reader(bytes, "fuzz");
    }();
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    require(count > 0 && image.rgb.size() == 3 * count, "the picture has not all its pixels");
    for (const std::uint16_t code : image.rgb) require(code < 1 << image.bits, "a code with too many bits");
  });
}

Outcome radianceScene(std::string_view bytes) {
  return readOrRefuse([&] {
    const geometry::RadianceScene scene = geometry::readRadianceScene(bytes, "fuzz");
    for (const core::Vec3& v : scene.mesh.vertices)
      require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), "a vertex that is no place");
    for (const auto& triangle : scene.mesh.triangles)
      for (const std::uint32_t corner : triangle)
        require(corner < scene.mesh.vertices.size(), "a triangle without a vertex");
  });
}

// A file of this process that holds the bytes while this lives: the mesh importer reads files.
class BytesAsFile {
 public:
  BytesAsFile(std::string_view bytes, const char* extension)
      : path_(std::filesystem::temp_directory_path() / ("goniolux-fuzz-" + std::to_string(getpid()) + extension)) {
    std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  ~BytesAsFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  BytesAsFile(const BytesAsFile&) = delete;
  BytesAsFile& operator=(const BytesAsFile&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

// The importer takes milliseconds a file, and has its files on a disk.
constexpr int meshInputs = 2000;

// A mesh that was read has corners that exist, numbers that are finite, an area, and pictures that can be asked for.
Outcome mesh(std::string_view bytes, const char* extension) {
  const BytesAsFile file(bytes, extension);
  try {
    const geometry::Shape shape = geometry::importMesh(file.path(), 1, false);
    for (const auto& triangle : shape.mesh.triangles)
      for (const std::uint32_t corner : triangle)
        require(corner < shape.mesh.vertices.size(), "a triangle without a vertex");
    require(shape.mesh.parts.size() == shape.mesh.triangles.size(), "a triangle without a part");
    require(shape.mesh.coordinates.empty() || shape.mesh.coordinates.size() == shape.mesh.triangles.size(),
            "a triangle without coordinates");
    const double area = geometry::area(shape);
    require(std::isfinite(area) && area > 0, "the area is no number above 0");
    for (const geometry::MeshPicture& picture : geometry::meshPictures(file.path()))
      require(!picture.file.empty() && !picture.parts.empty(), "a picture of nothing");
    return Outcome::read;
  } catch (const std::invalid_argument& refusal) {
    require(std::string_view(refusal.what()).size() > 10, "refused without a reason");
    return Outcome::refused;
  }
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> list{
      {"lm63", {".ies"}, photometric<photometry::readLm63>},
      {"eulumdat", {".ldt"}, photometric<photometry::readEulumdat>},
      {"tm33", {".xml"}, photometric<photometry::readTm33>},
      {"photometry", {".ies", ".ldt", ".xml"}, anyFormat},
      {"writers", {".ies", ".ldt", ".xml"}, writers},
      {"spectrum", {".spd", ".csv"}, twoColumns},
      {"tm27", {".spdx"}, tm27},
      {"exr", {".exr"}, imageFile},
      {"hdr", {".hdr"}, imageFile},
      {"icc", {".icc"}, iccProfile},
      {"png", {".png"}, picture<display::decodePng>},
      {"tiff", {".tif"}, picture<display::decodeTiff>},
      {"jpeg", {".jpg"}, picture<display::decodeJpeg>},
      {"dpx", {".dpx"}, picture<display::decodeDpx>},
      {"radiance", {".rad"}, radianceScene},
      {"obj", {".obj"}, [](std::string_view bytes) { return mesh(bytes, ".obj"); }, meshInputs},
      {"ply", {".ply"}, [](std::string_view bytes) { return mesh(bytes, ".ply"); }, meshInputs},
      {"stl", {".stl"}, [](std::string_view bytes) { return mesh(bytes, ".stl"); }, meshInputs},
      {"gltf", {".gltf"}, [](std::string_view bytes) { return mesh(bytes, ".gltf"); }, meshInputs},
      {"glb", {".glb"}, [](std::string_view bytes) { return mesh(bytes, ".glb"); }, meshInputs},
  };
  return list;
}

const Target& targetNamed(std::string_view name) {
  const auto found =
      std::find_if(targets().begin(), targets().end(), [&](const Target& target) { return target.name == name; });
  require(found != targets().end(), "there is no such target");
  return *found;
}

}  // namespace goniolux::fuzz
