// How long a 4000 x 3000 image takes to become a picture: histogram adjustment, gamut mapping towards grey, PNG for
// sRGB. Prints wall clock and CPU time of the program as it is, its largest memory, and where the time goes.
//
//   build/release/bin/benchmark_display [THREADS]
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/parallel.h"
#include "core/random.h"
#include "display/display_image.h"
#include "display/picture_file.h"
#include "image/exr.h"
#include "image/image_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace {

using namespace goniolux;

// Three and a half decades of luminance, colours in and beyond the gamut, and the noise of a calculation, which is what
// makes files large.
image::XyzImage scene(int width, int height) {
  image::XyzImage image;
  image.width = width;
  image.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint64_t hash = core::combine(static_cast<std::uint64_t>(y), static_cast<std::uint64_t>(x));
      const double noise = 1 + 0.1 * (static_cast<double>(hash >> 11) * 0x1p-53 - 0.5);
      const double luminance = noise * std::pow(10, 2 + 1.75 * std::sin(x / 300.0) * std::cos(y / 410.0));
      image.x.push_back(static_cast<float>(luminance * (0.95 + 0.3 * std::sin(x / 90.0))));
      image.y.push_back(static_cast<float>(luminance));
      image.z.push_back(static_cast<float>(luminance * (0.9 + 0.6 * std::cos(y / 70.0))));
    }
  return image;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Step>
void timed(const char* name, const Step& step) {
  const double wall = seconds(), cpu = core::processCpuSeconds();
  step();
  std::printf("  %-34s %6.2f s wall %6.2f s CPU\n", name, seconds() - wall, core::processCpuSeconds() - cpu);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string threads = argc > 1 ? argv[1] : "0";
  const test::TemporaryFolder folder;
  const std::string in = (folder.path() / "in.exr").string(), out = (folder.path() / "out.png").string();
  image::writeExr(in, scene(4000, 3000));

  std::vector<std::string> command = {GONIOLUX_PROGRAM, "display", in,   "--mapping", "ward",
                                      "--gamut",        "neutral", "-o", out,         "--quiet"};
  if (threads != "0") command.insert(command.end(), {"--threads", threads});
  const double start = seconds();
  const test::Outcome outcome = test::Running(command).wait();
  const double wall = seconds() - start;
  if (outcome.exitCode != 0) {
    std::fprintf(stderr, "%s%s", outcome.out.c_str(), outcome.err.c_str());
    return 1;
  }
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto cpu = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  std::printf("4000 x 3000 pixels, histogram adjustment, gamut mapping, PNG: %.2f s wall, %.2f s CPU, %.0f MB\n", wall,
              cpu(usage.ru_utime) + cpu(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024);

  core::setThreadCount(std::atoi(threads.c_str()));
  image::XyzImage image;
  display::DisplayedImage shown;
  const display::Device device = display::readDevice("srgb");
  timed("reading OpenEXR", [&] { image = image::readImage(in); });
  timed("histogram adjustment and gamut", [&] {
    display::DisplaySettings settings;
    settings.mapping = display::mappingNamed("ward");
    settings.gamut = display::GamutMapping::neutral;
    shown = display::displayImage(image, device, settings);
  });
  timed("writing PNG", [&] { display::writePicture(out, shown.codes, device); });
  return 0;
}
