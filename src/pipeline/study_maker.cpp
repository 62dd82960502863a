// One project's study: its time, what is kept for the next time, and the two independent solvers held together.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>

#include "core/parallel.h"
#include "core/random.h"
#include "core/sha256.h"
#include "pipeline/engine.h"
#include "pipeline/study.h"
#include "project/settings_reader.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr double referenceShare = 0.4;           // of the time
constexpr double coarsestReference = 0.02;       // a coarser one says nothing
constexpr double mostGrowth = 16;                // of a run's time, from one rung to the next
constexpr double falseAlarms = 0.01;             // of two solvers that agree
constexpr const char* runsFile = "study.jsonl";  // one line per run that is done
constexpr const char* crossFile = "cross.json";

/// Everything that a kept result depends on.
std::string keyOf(const project::Project& project, const std::string& lightingScene) {
  return core::sha256(project.hash + programVersion() + lightingScene +
                      core::toJson(project::settingsDocument(project.settings)));
}

bool same(const StudySetting& a, const StudySetting& b) {
  return a.line == b.line && a.solver == b.solver && a.accuracy == b.accuracy && a.spectral == b.spectral &&
         a.ofPicture == b.ofPicture && a.change == b.change;
}

/// Runs that are kept from a study of the same project by the same program.
std::vector<StudyRun> keptRuns(const std::string& file, const std::string& key) {
  std::vector<StudyRun> runs;
  if (!fs::exists(file)) return runs;
  const std::string text = core::readFile(file);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    core::Diagnostics ignored;
    const core::Value line = core::parseJson(text.substr(begin, end - begin), file, ignored);
    begin = end + 1;
    const core::Value* of = line.isObject() ? line.find("of_project") : nullptr;
    if (ignored.hasErrors() || of == nullptr || !of->isString() || of->string() != key) continue;
    if (const auto run = studyRunFromJson(line)) runs.push_back(*run);
  }
  return runs;
}

/// A part of a longer task: the whole's progress, told by its own.
class Part final : public core::ProgressSink {
 public:
  Part(core::ProgressSink& whole, std::function<double(double)> place) : whole_(whole), place_(std::move(place)) {}
  void progress(const std::string& task, double fraction, const std::string& reached) override {
    whole_.progress(task, place_(fraction), reached);
    if (whole_.cancelled()) cancel();
  }
  void note(const std::string& message) override { whole_.note(message); }

 private:
  core::ProgressSink& whole_;
  std::function<double(double)> place_;
};

/// One project's study while it is made.
class StudyMaker {
 public:
  StudyMaker(const project::Project& project, const std::string& lightingScene, std::string folder,
             const StudyTime& time, core::ProgressSink& progress, core::Diagnostics& warnings)
      : project_(project),
        folder_(std::move(folder)),
        key_(keyOf(project, lightingScene)),
        time_(time),
        progress_(progress),
        warnings_(warnings) {}

  ProjectStudy make() {
    study_.path = project_.folder;
    study_.name = project_.name;
    const bool grids = !project_.grids.empty(), picture = !project_.views.empty();
    if (!grids && !picture)
      throw core::InputError({project_.file, 0, 0}, "nothing-to-study",
                             "the project has no grid and no view: a study compares the points of grids, and the "
                             "pixels of the first view; add one");
    fs::create_directories(folder_);
    kept_ = (fs::path(folder_) / runsFile).string();
    known_ = keptRuns(kept_, key_);
    lines_ = fs::exists(kept_) ? core::readFile(kept_) : "";
    start_ = core::wallSeconds();
    makeReferences(grids, picture);
    if (progress_.cancelled()) return study_;
    if (time_.reference_s) start_ = core::wallSeconds();
    std::vector<StudySetting> settings;
    const auto plan = [&](bool ofPicture) {
      const planner::Plan chosen = Engine(project_, ofPicture).plan;
      (ofPicture ? study_.chosenForPicture : study_.chosen) = chosen.solver;
      return studySettings(project_, chosen, ofPicture);
    };
    if (grids) settings = plan(false);
    if (picture) settings = interleaved(settings, plan(true));
    std::map<bool, bool> first{{false, true}, {true, true}};
    for (std::size_t i = 0; i < settings.size() && !progress_.cancelled(); ++i) {
      const bool chosen = std::exchange(first[settings[i].ofPicture], false);
      runOne(settings[i], chosen, i, settings.size());
    }
    readCross();
    study_.spent_s = core::wallSeconds() - start_;
    return study_;
  }

 private:
  [[nodiscard]] double left() const { return time_.time_s - (core::wallSeconds() - start_); }
  [[nodiscard]] double placeOf(double fraction) const { return time_.from + (time_.to - time_.from) * fraction; }

  /// Grids and pictures by turns, so that both get their part of the time.
  static std::vector<StudySetting> interleaved(const std::vector<StudySetting>& a, const std::vector<StudySetting>& b) {
    std::vector<StudySetting> both;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
      if (i < a.size()) both.push_back(a[i]);
      if (i < b.size()) both.push_back(b[i]);
    }
    return both;
  }

  void makeReferences(bool grids, bool picture) {
    const double seconds = time_.reference_s.value_or(referenceShare * time_.time_s) / (grids && picture ? 2 : 1);
    const double share = grids && picture ? referenceShare / 2 : referenceShare;
    double done = 0;
    const auto part = [&] {
      const double from = done;
      done += share;
      return Part(progress_, [this, from, share](double f) { return placeOf(from + share * f); });
    };
    const auto warn = [&](double noise, const char* of) {
      if (!(noise < coarsestReference))
        warnings_.warning(
            {project_.file, 0, 0}, "coarse-reference",
            fmt::format("in the time given the reference of the {} is known to {:.2g} % only; give more by "
                        "--time-limit or --reference",
                        of, 100 * noise));
    };
    if (grids) {
      Part sink = part();
      sink.progress(project_.name, 0, "reference of the grids: a long unbiased run");
      study_.reference = makeReference(project_, key_, (fs::path(folder_) / "reference.json").string(), seconds, sink);
      warn(study_.reference->noise, "grids");
    }
    if (picture && !progress_.cancelled()) {
      Part sink = part();
      sink.progress(project_.name, 0, "reference of the picture: a long unbiased run");
      study_.pictureReference =
          makePictureReference(project_, key_, (fs::path(folder_) / "reference.exr").string(), seconds, sink);
      warn(study_.pictureReference->noise, "picture");
    }
  }

  /// How long a run will take, by the last one of its line, or of its solver: that is the work of one like it.
  [[nodiscard]] double foreseen(const StudySetting& setting) const {
    for (const std::string& line : {setting.line, setting.solver})
      if (const auto last = last_.find({setting.ofPicture, line}); last != last_.end()) {
        const bool ladder = line == setting.line || setting.work > 1;
        const double growth = ladder ? setting.work / last->second.setting.work : 1;
        return last->second.wall_s * std::clamp(growth, line == setting.line ? 1.0 : 0.0, mostGrowth);
      }
    return 0;
  }

  void runOne(const StudySetting& setting, bool chosen, std::size_t i, std::size_t count) {
    std::vector<StudyRun>& runs = setting.ofPicture ? study_.picture : study_.grids;
    const auto before =
        std::find_if(known_.begin(), known_.end(), [&](const StudyRun& run) { return same(run.setting, setting); });
    if (before != known_.end()) {
      runs.push_back(*before);
      last_[{setting.ofPicture, setting.line}] = *before;
      return;
    }
    if (!chosen && (left() <= 0 || foreseen(setting) > left())) {
      ++study_.leftOut;
      return;
    }
    // Done is the part of the runs or of the time, whichever ends first.
    const double byRuns = static_cast<double>(i) / static_cast<double>(count);
    Part sink(progress_, [this, byRuns](double) {
      const double byTime = 1 - std::clamp(left() / time_.time_s, 0.0, 1.0);
      return placeOf(referenceShare + (1 - referenceShare) * std::max(byRuns, byTime));
    });
    sink.progress(
        project_.name, 0,
        fmt::format("{}: {} at {:g} %", setting.ofPicture ? "picture" : "grids", setting.line, 100 * setting.accuracy));
    const double seconds = std::max(left(), 2.0);
    const std::uint64_t seed = core::combine(project_.settings.seed, (setting.ofPicture ? 1000 : 0) + i + 1);
    project::Results found;
    StudyRun run = setting.ofPicture ? runPicture(project_, setting, *study_.pictureReference, seed, seconds, sink)
                                     : runSetting(project_, setting, *study_.reference, seed, seconds, sink, &found);
    if (progress_.cancelled()) return;
    // What the time has ended is no measurement; but what `auto` does is always shown.
    if (!run.reached && run.wall_s >= 0.9 * seconds && !chosen) {
      ++study_.leftOut;
      return;
    }
    run.isAuto = chosen;
    runs.push_back(run);
    last_[{setting.ofPicture, setting.line}] = run;
    core::Value line = toJson(run);
    line.set("of_project", key_);
    line.set("project_hash", project_.hash);
    std::string text = core::toJson(line);
    text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
    lines_ += text + "\n";
    core::writeFile(kept_, lines_);
    if (!setting.ofPicture && setting.line == "gather") crossWithReference(found);
  }

  /// The reference follows whole paths; `gather` ends them in a light solution: two independent methods.
  void crossWithReference(const project::Results& gathered) {
    CrossCheck check = compareSolvers(study_.reference->results, gathered, falseAlarms);
    check.one = "path";
    check.other = "gather";
    core::Value json = toJson(check);
    json.set("of_project", key_);
    core::writeFile((fs::path(folder_) / crossFile).string(), core::toJson(json));
    for (const project::GridResult& grid : check.differences)  // of an earlier, coarser run
      for (const char* ending : {".png", ".figure.json"})
        fs::remove((fs::path(folder_) / ("cross-" + project::fileNameFor(grid.name))).string() + ending);
    if (!check.agrees()) drawDifferences(check, project_, folder_, warnings_);
  }

  void readCross() {
    const std::string file = (fs::path(folder_) / crossFile).string();
    if (!fs::exists(file)) return;
    core::Diagnostics ignored;
    core::Value json = core::parseJson(core::readFile(file), file, ignored);
    const core::Value* of = json.isObject() ? json.find("of_project") : nullptr;
    if (!ignored.hasErrors() && of != nullptr && of->isString() && of->string() == key_) study_.cross = std::move(json);
  }

  const project::Project& project_;
  std::string folder_, key_, kept_, lines_;
  StudyTime time_;
  core::ProgressSink& progress_;
  core::Diagnostics& warnings_;
  ProjectStudy study_;
  std::vector<StudyRun> known_;
  std::map<std::pair<bool, std::string>, StudyRun> last_;
  double start_ = 0;
};

}  // namespace

ProjectStudy makeStudy(const project::Project& project, const std::string& lightingScene, const std::string& folder,
                       const StudyTime& time, core::ProgressSink& progress, core::Diagnostics& warnings) {
  return StudyMaker(project, lightingScene, folder, time, progress, warnings).make();
}

}  // namespace goniolux::pipeline
