#include "app/gui/jobs/rendering.h"

#include <limits>
#include <utility>

#include "display/adopted_white.h"
#include "display/device.h"
#include "display/display_image.h"
#include "display/mapping.h"
#include "image/image_file.h"
#include "pipeline/engine.h"
#include "pipeline/render.h"

namespace goniolux::gui {
namespace {

const scene::View& viewNamed(const project::Project& project, const std::string& name) {
  for (const scene::View& view : project.views)
    if (view.name == name) return view;
  throw core::InputError({project.file, 0, 0}, "unknown-view",
                         "the project has no view \"" + name + "\" any more; choose another");
}

}  // namespace

Job::Work renderWork(Source source, std::string viewName, std::string folder, bool withSpectra,
                     std::function<void(RenderOutcome)> deliver) {
  return [=](JobProgress& progress) {
    const project::Project project = project::readProjectText(source.text, source.file);
    const scene::View& view = viewNamed(project, viewName);
    const pipeline::Engine engine(project, true);
    const double accuracy = project.settings.accuracy.image;
    const auto partial = [&](const viewing::ImageEstimate& soFar) {
      auto image = std::make_shared<const image::XyzImage>(soFar.image);
      progress.publish([deliver, image, viewName, accuracy, share = soFar.shareWithin] {
        deliver({image, viewName, {}, share, accuracy, false});
      });
    };
    const double limit = project.settings.timeLimit_s.value_or(std::numeric_limits<double>::infinity());
    pipeline::RenderOptions options;
    if (withSpectra) options.channels = pipeline::spectralRangeFrom(spectralChannels);
    const pipeline::RenderedView done =
        pipeline::renderToFile(project, engine, view, folder, limit, progress, partial, options);
    auto image = std::make_shared<const image::XyzImage>(image::readImage(done.file));
    progress.publish([deliver, image, viewName, accuracy, done] {
      deliver({image, viewName, done.file, done.shareWithin, accuracy, true});
    });
  };
}

std::string mappingText(const DisplayChoice& choice) {
  if (choice.mapping != "linear") return choice.mapping;
  return QString("linear:ev=auto%1%2").arg(choice.stops < 0 ? "" : "+").arg(choice.stops, 0, 'g', 4).toStdString();
}

std::shared_ptr<const ShownImage> shownImage(const image::XyzImage& image, const DisplayChoice& choice) {
  auto shown = std::make_shared<ShownImage>();
  try {
    const display::Device device = display::readDevice(choice.device);
    display::DisplaySettings settings;
    settings.mapping = display::mappingNamed(mappingText(choice));
    if (choice.adapts) settings.adoptedWhite = display::adoptedWhiteOf(image);
    const display::DisplayedImage displayed = display::displayImage(image, device, settings);
    const display::CodeImage& codes = displayed.codes;
    shown->method = QString::fromStdString(displayed.method);
    shown->white_cd_m2 = displayed.white_cd_m2;
    shown->tooBright = displayed.tooBright;
    shown->outOfGamut = displayed.outOfGamut;
    shown->picture = QImage(codes.width, codes.height, QImage::Format_RGB888);
    for (int y = 0; y < codes.height; ++y) {
      uchar* line = shown->picture.scanLine(y);
      for (int i = 0; i < 3 * codes.width; ++i)
        line[i] = static_cast<uchar>(codes.rgb[3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(codes.width) +
                                               static_cast<std::size_t>(i)]);
    }
  } catch (const std::exception& error) {
    shown->failure = QString::fromUtf8(error.what());
  }
  return shown;
}

}  // namespace goniolux::gui
