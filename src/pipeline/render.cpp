#include "pipeline/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "analysis/grid_estimate.h"
#include "core/parallel.h"
#include "core/random.h"
#include "image/exr.h"
#include "image/mix.h"
#include "image/patch.h"
#include "pipeline/image_form.h"
#include "pipeline/kept_run.h"
#include "pipeline/render_layers.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"
#include "project/results.h"
#include "scene/view_text.h"
#include "spectrum/colorimetry.h"
#include "viewing/pixel_loop.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

const scene::View& findView(const project::Project& project, const std::string& name) {
  std::vector<std::string> names;
  for (const scene::View& view : project.views) {
    if (view.name == name) return view;
    names.push_back(view.name);
  }
  throw core::InputError(
      {project.file, 0, 0}, "unknown-view",
      names.empty() ? fmt::format("the project has no views; add one to \"views\"")
                    : fmt::format("there is no view \"{}\"; the project has: {}", name, fmt::join(names, ", ")));
}

/// X, Y, Z flux of all sources together; its chromaticity is what an observer in the scene is adapted to.
spectrum::Xyz sourceFlux(const Engine& engine) {
  double X = 0, Y = 0, Z = 0;
  for (const scene::LightSource& source : engine.world.emitters) {
    const double flux = source.emitter->flux();
    for (const spectrum::Response& weight : engine.plan.quadrature.weights[source.spectrum]) {
      X += flux * weight[0];
      Y += flux * weight[1];
      Z += flux * weight[2];
    }
  }
  return {X, Y, Z};
}

/// How the image was made, as its attributes.
void describe(viewing::ImageEstimate& estimate, const project::Project& project, const Engine& engine,
              const scene::View& view) {
  const auto& settings = project.settings;
  auto& attributes = estimate.image.attributes;
  attributes["program"] = "Goniolux " + programVersion();
  attributes["project"] = project.name;
  attributes["projectHash"] = project.hash;
  attributes["view"] = view.name;
  attributes["seed"] = std::to_string(settings.seed);
  attributes["solver"] = engine.plan.solver;
  attributes["spectralSampling"] = engine.plan.quadrature.scheme;
  const spectrum::Xyz flux = sourceFlux(engine);
  const auto [x, y] = spectrum::chromaticity(flux);
  attributes[image::sourceFluxAttribute] = fmt::format("{:.8g} {:.8g} {:.8g}", flux.X, flux.Y, flux.Z);
  attributes[image::adoptedWhiteAttribute] = fmt::format("{:.5f} {:.5f}", x, y);
  attributes[image::viewGeometryAttribute] = scene::viewText(view);
  if (scene::isKnownToRadiance(view)) attributes[image::viewAttribute] = scene::viewText(view);
  attributes[image::confidenceAttribute] = fmt::format("{:g}", settings.accuracy.confidence);
  attributes[image::systematicAttribute] = fmt::format("{:.6g}", estimate.missed);
  attributes["accuracyAsked"] = fmt::format("{:g} % of the luminance of 95 % of the pixels at {:g} % confidence",
                                            100 * settings.accuracy.image, 100 * settings.accuracy.confidence);
  attributes["pixelFilter"] = settings.pixelFilter;
  attributes["accuracyReached"] = fmt::format("{:.1f} % of the pixels", 100 * estimate.shareWithin);
}

/// Mean, extremes and percentiles of the picture's luminance.
void addStatistics(const image::XyzImage& picture, RenderedView& view) {
  const image::PatchReading all =
      image::readPatch(picture, picture.width / 2, picture.height / 2, std::hypot(picture.width, picture.height));
  view.luminance = {all.luminance.value, all.luminance.halfWidth, {}};
  view.least = all.least;
  view.most = all.most;
  std::vector<double> values, low, high;
  for (std::size_t i = 0; i < picture.y.size(); ++i) {
    const auto luminance = static_cast<double>(picture.y[i]), halfWidth = static_cast<double>(picture.halfWidth[i]);
    if (!std::isfinite(luminance) || !std::isfinite(halfWidth)) continue;
    values.push_back(luminance);
    low.push_back(luminance - halfWidth);
    high.push_back(luminance + halfWidth);
  }
  if (values.empty()) return;
  for (const int percent : analysis::statedPercentiles) {
    const double value = analysis::quantileOf(values, 0.01 * percent);
    view.percentiles[percent] = {
        value,
        std::max(analysis::quantileOf(high, 0.01 * percent) - value, value - analysis::quantileOf(low, 0.01 * percent)),
        {}};
  }
}

StageReport render(const StageRequest& request, core::ProgressSink& progress) {
  const project::Project project = readProjectFor(request, AccuracyOf::images);
  const auto asked = request.options.find("view");
  std::vector<const scene::View*> views;
  if (asked != request.options.end()) {
    views.push_back(&findView(project, asked->second));
  } else {
    for (const scene::View& view : project.views) views.push_back(&view);
  }
  if (views.empty())
    throw core::InputError({project.file, 0, 0}, "no-view", "the project has no views to render; add one to \"views\"");

  RenderOptions options;
  options.form = imageFormFrom(request, "view.exr").exr;
  options.parts = request.options.contains("parts");
  if (const auto channels = request.options.find("channels"); channels != request.options.end())
    options.channels = spectralRangeFrom(channels->second);
  const std::string folder = resultsFolder(request, project);
  KeptRun kept("render", request, project, folder, progress);
  options.keeping = kept.keeping();
  const auto outOfTime = [&](bool reached) { return !reached && project.settings.timeLimit_s.has_value(); };
  if (request.options.contains("layers")) {
    StageReport report = renderLayers(project, views, folder, options, kept.progress());
    kept.close(report, !report.unfinished);
    return report;
  }

  const Engine engine(project, true);
  StageReport report;
  report.warnings = project.warnings;
  core::Value list;
  const double limit = project.settings.timeLimit_s.value_or(std::numeric_limits<double>::infinity());
  bool isFinished = true;
  for (const scene::View* view : views) {
    const RenderedView done = renderToFile(project, engine, *view, folder, limit / static_cast<double>(views.size()),
                                           kept.progress(), {}, options);
    isFinished = isFinished && !outOfTime(done.reached);
    report.files.push_back(done.file);
    report.text += renderText(done, project);
    if (views.size() == 1) report.json = toJson(done, engine);
    list.push(toJson(done, engine));
    if (progress.cancelled()) break;
  }
  if (views.size() > 1) report.json.set("views", std::move(list));
  report.unfinished = progress.cancelled();
  kept.close(report, isFinished && !report.unfinished);
  return report;
}

}  // namespace

viewing::PixelAccuracy pixelAccuracyOf(const project::Settings& settings) {
  viewing::PixelAccuracy asked;
  asked.relative = settings.accuracy.image;
  asked.confidence = settings.accuracy.confidence;
  asked.mostSamples = settings.pixelMaxSamples;
  asked.fewestSamples = settings.pixelMinSamples;
  asked.contrast = settings.pixelContrast;
  asked.filter = viewing::findPixelFilter(settings.pixelFilter);
  return asked;
}

RenderedView renderToFile(const project::Project& project, const Engine& engine, const scene::View& view,
                          const std::string& folder, double secondsLeft, core::ProgressSink& progress,
                          const viewing::ImageObserver& partial, const RenderOptions& options) {
  const core::Keeping keeping = options.keeping.part("view " + view.name);
  const Meter meter(*engine.solver, keeping);
  const auto& settings = project.settings;

  std::uint64_t key = core::mix(settings.seed + 0x1a6e);
  for (const char c : view.name) key = core::combine(key, static_cast<unsigned char>(c));
  viewing::ImageObserver observer;
  if (partial)
    observer = [&](const viewing::ImageEstimate& soFar) {
      viewing::ImageEstimate known = soFar;
      describe(known, project, engine, view);
      partial(known);
    };
  viewing::PixelAccuracy asked = pixelAccuracyOf(settings);
  asked.parts = options.parts;
  if (options.parts && !engine.solver->partsLight())
    throw core::InputError({"--parts", 0, 0}, "parts",
                           fmt::format("the solver '{}' does not part direct and indirect light; use --solver path or "
                                       "gather",
                                       engine.plan.solver));
  viewing::ImageEstimate estimate = viewing::renderView(*engine.solver, view, engine.world.origin, key, asked,
                                                        secondsLeft, progress, observer, keeping);

  describe(estimate, project, engine, view);

  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw core::RunError(fmt::format("cannot make the folder {}: {}", folder, failure.message()));
  RenderedView done;
  done.name = view.name;
  done.file = (fs::path(folder) / imageFileName(view)).string();
  for (const auto& [name, value] : options.attributes) estimate.image.attributes[name] = value;
  if (options.channels)
    estimate.image.spectrum = renderSpectrum(project, engine, view, key, *options.channels, progress, keeping);
  image::writeExr(done.file, estimate.image, options.form);
  done.reached = estimate.reached;
  done.shareWithin = estimate.shareWithin;
  done.missed = estimate.missed;
  done.samples = estimate.samples;
  addStatistics(estimate.image, done);
  done.width = view.width;
  done.height = view.height;
  const core::Spent spent = meter.spent();
  done.wallTime_s = spent.wall_s;
  done.cpuTime_s = spent.cpu_s;
  done.rays = spent.rays;
  return done;
}

std::string imageFileName(const scene::View& view) {
  return project::fileNameFor(view.name) + ".exr";
}

core::Value toJson(const RenderedView& view, const Engine& engine) {
  core::Value json;
  json.set("view", view.name);
  json.set("file", view.file);
  json.set("reached", view.reached);
  json.set("pixels_within", view.shareWithin);
  core::Value time;
  time.set("wall", view.wallTime_s);
  time.set("cpu", view.cpuTime_s);
  json.set("time_s", std::move(time));
  json.set("rays", view.rays);
  const auto withHalfWidth = [](const core::Estimate& e) {
    core::Value value;
    value.set("value", e.value);
    value.set("half_width", e.halfWidth());
    return value;
  };
  core::Value luminance, percentiles;
  luminance.set("mean", withHalfWidth(view.luminance));
  luminance.set("min", view.least);
  luminance.set("max", view.most);
  for (const auto& [percent, estimate] : view.percentiles)
    percentiles.set(std::to_string(percent), withHalfWidth(estimate));
  if (!percentiles.isNull()) luminance.set("percentiles", std::move(percentiles));
  json.set("luminance_cd_m2", std::move(luminance));
  json.set("samples_per_pixel", static_cast<double>(view.samples) / (view.width * view.height));
  json.set("spectral_samples", static_cast<double>(engine.plan.quadrature.wavelengths.size()));
  json.set("interreflection", view.missed);
  core::Value::Array leftOut;
  for (const std::string& sentence : leftOutSentences(engine)) leftOut.emplace_back(sentence);
  json.set("left_out", std::move(leftOut));
  if (const auto statistics = engine.solver->statistics(); !statistics.empty()) {
    core::Value figures, tree;
    for (const solver::Statistic& figure : statistics) {
      figures.set(figure.name, figure.value);
      if (figure.name == "average_tree_depth") tree.set("average_depth", figure.value);
      if (figure.name == "maximum_tree_depth") tree.set("max_depth", figure.value);
      if (figure.name == "nodes") tree.set("nodes", figure.value);
    }
    json.set("statistics", std::move(figures));
    if (!tree.isNull()) json.set("tree", std::move(tree));
  }
  return json;
}

std::string renderText(const RenderedView& view, const project::Project& project) {
  return fmt::format(
      "  view {}: {} x {} pixels, {:.0f} samples each, {:.1f} % of them within {:g} %{}; {:.1f} s ({:.1f} s CPU)\n    "
      "{}\n",
      view.name, view.width, view.height, static_cast<double>(view.samples) / (view.width * view.height),
      100 * view.shareWithin, 100 * project.settings.accuracy.image,
      view.reached ? "" : " (asked: 95 %; the limit of samples or time came first)", view.wallTime_s, view.cpuTime_s,
      view.file);
}

Stage renderStage() {
  Stage stage;
  stage.name = "render";
  stage.title = "Render the views of a project";
  stage.help =
      "A photometrically calibrated image: OpenEXR with CIE X, Y, Z per pixel, Y in cd/m2, and its half-width.";
  stage.inputName = "PROJECT";
  core::Parameter view;
  view.key = "view";
  view.title = "NAME";
  view.kind = core::ParameterKind::text;
  view.help = "the view to render; without it all views";
  core::Parameter layers = textOption("layers", "an image per luminaire group", "",
                                      "layers/GROUP/NAME.exr, each at full level, also for groups dimmed to 0, and "
                                      "NAME.exr as their sum at the project's "
                                      "dimming or --scene; layers that are there already are not traced again",
                                      false);
  layers.kind = core::ParameterKind::boolean;
  core::Parameter parts = textOption("parts", "direct and indirect light apart", "",
                                     "layers of the image itself, channels direct.X ... indirect.Z, which add up to "
                                     "it; also in the layers of groups",
                                     false);
  parts.kind = core::ParameterKind::boolean;
  stage.options = {
      view,
      layers,
      parts,
      textOption("channels", "spectral channels", "",
                 "FROM:TO:STEP in nm, such as 400:700:10: spectral radiance in W/(m2 sr nm) beside X, Y, Z", false),
      imageFormOption(),
      resumeOption()};
  stage.run = render;
  return stage;
}

}  // namespace goniolux::pipeline
