// The stage `verify`: every project of some folders against its baseline. Each is calculated by a process of its own,
// so that one that is broken fails alone; what is finished is kept at once.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "core/parallel.h"
#include "core/sha256.h"
#include "pipeline/engine.h"
#include "pipeline/process_pool.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"
#include "pipeline/verify_report.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using Verdict = BatchProject::Verdict;

struct VerifyOptions {
  std::string folder = "verify-results";
  bool update = false, resume = false;
  std::optional<double> accuracy;
  double tolerance = 0, falseAlarms = 0.01;
  Shard shard;
  std::size_t jobs = 1;
  double timeLimit_s = 1e30;
};

[[noreturn]] void badOption(const std::string& message) {
  throw core::InputError({}, "bad-option", message);
}

/// "2 %" as 0.02.
double percentage(const std::string& key, const std::string& text, double most) {
  double number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string tail(rest, text.data() + text.size());
  if (error != std::errc() || (tail != "%" && tail != " %") || !(number >= 0) || number > 100 * most)
    badOption(
        fmt::format("--{} \"{}\": write a percentage up to {:g} %, e.g. --{} \"1 %\"", key, text, 100 * most, key));
  return number / 100;
}

VerifyOptions optionsOf(const StageRequest& request) {
  VerifyOptions options;
  const auto option = [&](const char* key) {
    const auto found = request.options.find(key);
    return found == request.options.end() ? std::string() : found->second;
  };
  options.folder = request.common.output.value_or(options.folder);
  options.update = option("update") == "true";
  options.resume = option("resume") == "true";
  if (request.common.accuracy) options.accuracy = percentage("accuracy", *request.common.accuracy, 1);
  if (!option("tolerance").empty()) options.tolerance = percentage("tolerance", option("tolerance"), 1);
  if (!option("false-alarms").empty()) options.falseAlarms = percentage("false-alarms", option("false-alarms"), 0.5);
  if (!(options.falseAlarms > 0)) badOption("--false-alarms must be above 0 %: no measurement is certain");
  if (!option("shard").empty()) options.shard = shardFrom(option("shard"));
  const auto most = static_cast<std::size_t>(core::threadCount());
  options.jobs = most;
  if (!option("j").empty()) {
    const std::string text = option("j");
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), options.jobs);
    if (error != std::errc() || rest != text.data() + text.size() || options.jobs < 1 || options.jobs > 1024)
      badOption(fmt::format("-j needs a whole number from 1 to 1024, not '{}'", text));
  }
  options.timeLimit_s = request.common.timeLimit_s.value_or(options.timeLimit_s);
  return options;
}

class Batch {
 public:
  Batch(const StageRequest& request, core::ProgressSink& progress)
      : options_(optionsOf(request)), seed_(request.common.seed), progress_(progress) {
    began_ = core::wallSeconds();
    program_ = findHelper("goniolux", "GONIOLUX_PROGRAM");
    if (program_.empty())
      throw core::RunError("the program goniolux is not installed beside this one; set GONIOLUX_PROGRAM to its path");
    programHash_ = core::sha256(core::readFile(program_));
    batch_.falseAlarms = options_.falseAlarms;
    batch_.tolerance = options_.tolerance;
    batch_.programVersion = programVersion();
    const std::vector<std::string> paths = findProjects(request.inputs);
    std::set<std::string> folders;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      BatchProject project;
      project.path = paths[i];
      project.ofThisShard = i % options_.shard.count + 1 == options_.shard.index;
      std::string name = project::fileNameFor(paths[i]);
      name.erase(0, name.find_first_not_of(".-"));
      if (name.empty() || !folders.insert(name).second) name += fmt::format("-{}", i + 1);
      project.folder = (fs::path(options_.folder) / "projects" / name).string();
      batch_.projects.push_back(std::move(project));
    }
  }

  StageReport run() {
    for (BatchProject& project : batch_.projects) readBaselineOf(project);
    calculate();
    std::size_t compared = 0;
    for (BatchProject& project : batch_.projects) compared += project.differences.empty() ? 0 : 1;
    batch_.seconds = seconds();
    StageReport report;
    for (BatchProject& project : batch_.projects) {
      const bool hopeless = project.verdict == Verdict::broken;
      report.inputFailed |= hopeless && !project.unfinished;
      report.unfinished |=
          (hopeless && project.unfinished) || (project.verdict == Verdict::notRun && project.ofThisShard);
      report.verdictFailed |= project.verdict == Verdict::changed && !project.updated;
    }
    report.text = textOf(batch_);
    if (!options_.update && compared == 0 && countOf(batch_, Verdict::noBaseline) > 0)
      report.warnings.warning({}, "no-baselines",
                              "none of these projects has a baseline, so nothing was compared; make them with "
                              "`goniolux verify --update`");
    report.json = documentOf(batch_);
    try {
      report.files = writeReports(report.json);
    } catch (const core::RunError& error) {  // a full disk must not swallow what was found
      report.unfinished = true;
      report.warnings.warning({}, "not-written", error.what());
    }
    if (report.unfinished)
      report.warnings.warning({}, "unfinished",
                              "the batch is not finished; what is done is kept: run the same command with --resume");
    return report;
  }

 private:
  [[nodiscard]] double seconds() const { return core::wallSeconds() - began_; }

  /// The values of the whole batch share the false alarms, whatever shard or resumed run compares them.
  void readBaselineOf(BatchProject& project) {
    const std::string file = (fs::path(project.path) / project::baselineFileName).string();
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return;
    try {
      project.baseline = project::readBaseline(file);
      batch_.values += project.baseline->values.size();
    } catch (const core::InputError& error) {
      refuse(project, error);
    }
  }

  static void refuse(BatchProject& project, const core::InputError& error) {
    project.verdict = Verdict::broken;
    project.trouble = error.what();
  }

  /// Reads the project with what it is calculated with; false when it cannot be, or there is nothing in it.
  bool prepare(BatchProject& item) {
    if (item.verdict == Verdict::broken || !item.ofThisShard) return false;
    try {
      StageRequest request = requestOf(item);
      if (options_.accuracy) {
        item.accuracy = *options_.accuracy;
      } else if (item.baseline && (item.baseline->accuracy || !options_.update)) {
        item.accuracy = accuracyFor(*item.baseline);
      } else {
        item.accuracy = readProjectFor(request, AccuracyOf::grids).settings.accuracy.grid;
      }
      request = requestOf(item);
      item.project = readProjectFor(request, AccuracyOf::grids);
    } catch (const core::InputError& error) {
      refuse(item, error);
      return false;
    }
    if (item.baseline)
      item.changedInputs = changedInputs(*item.baseline, *item.project, core::readFile(item.project->file));
    if (item.project->grids.empty() && item.project->observers.empty()) {
      item.verdict = Verdict::noBaseline;
      item.remarks.emplace_back("it has neither grids nor observers: there is nothing to compare");
      return false;
    }
    if (!item.baseline && !options_.update) {
      item.verdict = Verdict::noBaseline;
      return false;
    }
    return true;
  }

  [[nodiscard]] StageRequest requestOf(const BatchProject& item) const {
    StageRequest request;
    request.inputs = {item.path};
    request.common.seed = seed_;
    if (item.accuracy > 0) request.common.accuracy = accuracyText(item);
    return request;
  }
  static std::string accuracyText(const BatchProject& item) { return fmt::format("{:.6g} %", 100 * item.accuracy); }
  [[nodiscard]] std::string keyOf(const BatchProject& item) const { return item.project->hash + " " + programHash_; }

  void calculate() {
    std::size_t done = 0, total = 0;
    for (const BatchProject& project : batch_.projects) total += project.ofThisShard ? 1 : 0;
    const auto tell = [&](const std::string& what) {
      progress_.progress("projects", total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 1,
                         fmt::format("{} of {} done{}", done, total, what.empty() ? "" : ", " + what));
    };
    ProcessPool pool;
    std::size_t next = 0;
    while (next < batch_.projects.size() || pool.running() > 0) {
      if (progress_.cancelled() || seconds() > options_.timeLimit_s) break;
      while (next < batch_.projects.size() && pool.running() < options_.jobs) {
        const std::size_t index = next++;
        BatchProject& item = batch_.projects[index];
        if (!item.ofThisShard) continue;
        if (prepare(item) && !takeKept(item)) {
          begin(pool, index);
        } else {
          ++done;
          note(item);
        }
        tell(item.path);
        if (progress_.cancelled()) break;
      }
      if (const auto ended = pool.wait(0.25)) {
        ++done;
        finish(batch_.projects[ended->tag], *ended);
        note(batch_.projects[ended->tag]);
      }
      tell("");
    }
    pool.killAll();
  }

  /// With --resume: what an earlier run finished with the same inputs, settings and program.
  bool takeKept(BatchProject& item) {
    if (!options_.resume) return false;
    const auto outcome = readOutcome(item.folder);
    if (!outcome || outcome->key != keyOf(item)) return false;
    try {
      const project::Results results = project::readResults(item.folder);
      item.kept = true;
      item.seconds = outcome->seconds;
      judge(item, results);
    } catch (const core::InputError&) {  // damaged since: calculated anew
      return false;
    }
    return true;
  }

  void begin(ProcessPool& pool, std::size_t index) {
    const BatchProject& item = batch_.projects[index];
    forgetOutcome(item.folder);
    const auto all = static_cast<std::size_t>(core::threadCount());
    std::vector<std::string> arguments{
        "illuminate",       item.path,   "-o",
        item.folder,        "--quiet",   "--accuracy",
        accuracyText(item), "--threads", std::to_string(std::max<std::size_t>(1, all / options_.jobs))};
    if (seed_) arguments.insert(arguments.end(), {"--seed", std::to_string(*seed_)});
    pool.start(index, program_, arguments);
  }

  void finish(BatchProject& item, const ProcessPool::Ended& ended) {
    item.seconds = ended.seconds;
    std::string said = ended.end.errors;
    while (!said.empty() && said.back() == '\n') said.pop_back();
    const bool exited = ended.end.how == ProcessEnd::How::exited;
    if (exited && (ended.end.code == 0 || ended.end.code == 1)) {  // 1: a requirement of the project is not met
      try {
        const project::Results results = project::readResults(item.folder);
        writeOutcome(item.folder, {keyOf(item), item.seconds});
        judge(item, results);
        return;
      } catch (const core::InputError& error) {
        said = error.what();
      } catch (const core::RunError& error) {
        said = error.what();
      }
    }
    item.verdict = Verdict::broken;
    item.unfinished = !exited || ended.end.code != 2;
    if (ended.end.how == ProcessEnd::How::killed)
      said += fmt::format("{}the calculation was ended by signal {}", said.empty() ? "" : "\n", ended.end.code);
    item.trouble = said.empty() ? "the calculation failed without a word" : said;
  }

  void judge(BatchProject& item, const project::Results& results) {
    if (!results.reached) item.remarks.push_back("the accuracy was not reached: " + results.reachedText);
    if (item.baseline) {
      CompareOptions compare;
      compare.falseAlarmsPerValue = options_.falseAlarms / static_cast<double>(std::max<std::size_t>(1, batch_.values));
      compare.tolerance = options_.tolerance;
      item.differences = compareWith(*item.baseline, results, compare);
      const bool changed =
          std::any_of(item.differences.begin(), item.differences.end(), [](const Difference& d) { return d.changed; });
      item.verdict = changed ? Verdict::changed : Verdict::passed;
      if (!item.baseline->programVersion.empty() && item.baseline->programVersion != programVersion())
        item.remarks.push_back(fmt::format("the baseline was made by version {}", item.baseline->programVersion));
    } else {
      item.verdict = Verdict::noBaseline;
    }
    if (options_.update) renew(item, results);
  }

  /// Writes the baseline where there is none of our own, a value or an input has changed, or another accuracy is asked
  /// for. One that still holds stays as it is: renewing it again and again would let values creep.
  void renew(BatchProject& item, const project::Results& results) {
    const bool hasOwn = item.baseline && !item.baseline->programVersion.empty();
    const bool sharper = hasOwn && options_.accuracy && item.baseline->accuracy != options_.accuracy;
    if (hasOwn && item.verdict == Verdict::passed && item.changedInputs.empty() && !sharper) return;
    project::Baseline renewed = item.baseline.value_or(project::Baseline{});
    renewed.values.clear();
    std::size_t dropped = 0;
    if (item.baseline) {
      for (std::size_t i = 0; i < item.baseline->values.size(); ++i) {
        const project::ExpectedValue& old = item.baseline->values[i];
        if (old.own) continue;
        if (item.differences[i].changed)
          ++dropped;
        else
          renewed.values.push_back(old);
      }
    }
    if (dropped > 0)
      item.remarks.push_back(fmt::format("{} values of another source hold no longer and are taken out", dropped));
    if (renewed.values.empty()) renewed.source = "an earlier run of Goniolux, by `goniolux verify --update`";
    for (project::ExpectedValue& value : project::ownValues(results)) renewed.values.push_back(std::move(value));
    renewed.confidence = results.confidence;
    renewed.programVersion = programVersion();
    renewed.accuracy = item.accuracy;
    renewed.seed = results.seed;
    renewed.inputs = item.project->inputs;
    renewed.entries = project::entryHashes(core::readFile(item.project->file));
    const std::string file = (fs::path(item.path) / project::baselineFileName).string();
    try {
      core::writeFile(file, core::toJson(project::toJson(renewed)));
      item.updated = true;
      item.remarks.push_back("baseline renewed: " + file);
    } catch (const core::RunError& error) {
      item.verdict = Verdict::broken;
      item.unfinished = true;
      item.trouble = error.what();
    }
  }

  void note(const BatchProject& item) {
    if (item.verdict == Verdict::changed)
      progress_.note(fmt::format("{}: changed", item.path));
    else if (item.verdict == Verdict::broken)
      progress_.note(fmt::format("{}: broken", item.path));
  }

  std::vector<std::string> writeReports(const core::Value& document) {
    std::vector<std::string> files;
    const auto write = [&](const char* name, const std::string& content) {
      files.push_back((fs::path(options_.folder) / name).string());
      core::writeFile(files.back(), content);
    };
    std::error_code error;
    fs::create_directories(options_.folder, error);
    if (error)
      throw core::RunError(
          fmt::format("{}: the folder cannot be made: {}; name another one with -o", options_.folder, error.message()));
    write("verify.json", core::toJson(document));
    write("junit.xml", junitOf(batch_));
    write("index.html", pageOf(batch_));
    return files;
  }

  VerifyOptions options_;
  std::optional<std::uint64_t> seed_;
  core::ProgressSink& progress_;
  double began_ = 0;
  std::string program_, programHash_;
  BatchSummary batch_;
};

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  return Batch(request, progress).run();
}

core::Parameter flag(const char* key, const char* title, const char* help) {
  core::Parameter parameter = textOption(key, title, "", help, false);
  parameter.kind = core::ParameterKind::boolean;
  return parameter;
}

}  // namespace

Stage verifyStage() {
  Stage stage;
  stage.name = "verify";
  stage.title = "Compare projects with their baselines";
  stage.help =
      "Finds the projects below the folders, calculates the grids and observers of each, and compares them with the "
      "values and intervals of its expected.json. A value has changed when the two intervals part by more than chance "
      "explains; says which input has changed since. Writes verify.json, junit.xml and index.html into the folder "
      "given "
      "with -o (default: verify-results). Exit code 1: a value has changed; 2: a project cannot be read; 3: not "
      "finished.";
  stage.inputName = "DIR";
  stage.manyInputs = true;
  stage.options = {
      flag("update", "renew baselines",
           "shows what has changed, then writes expected.json anew where it has, or is missing"),
      flag("resume", "go on", "takes over what an earlier run with the same -o finished"),
      textOption("accuracy", "accuracy of the grids", "", "default: as the baseline was made, or as its intervals need",
                 false),
      textOption("tolerance", "tolerance", "0 %",
                 "change of a value that is not told, besides chance; expected.json may say otherwise", false),
      textOption("false-alarms", "rate of false alarms", "1 %",
                 "share of batches without any change in which chance alone may raise an alarm", false),
      textOption("shard", "part I of N", "", "I/N: only every N-th project, beginning with the I-th", false),
      textOption("j", "projects at once", "", "each in a process of its own (default: as many as there are processors)",
                 false),
      textOption("time-limit", "time for the whole batch, s", "", "what is not finished then is left to --resume",
                 false),
  };
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
