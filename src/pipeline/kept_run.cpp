#include "pipeline/kept_run.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <vector>

#include "core/parallel.h"
#include "pipeline/engine.h"
#include "project/settings_reader.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using core::Value;

/// Tells builds apart: two of them need not agree to the last digit.
std::string programBuild() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const auto written = fs::last_write_time(program, ignored).time_since_epoch().count();
  return fmt::format("{} ({} bytes, {})", programVersion(), fs::file_size(program, ignored), written);
}

/// Everything that the results depend on, so that a run with other bytes in them is not taken for this one.
Value identityOf(const std::string& verb, const StageRequest& request, const project::Project& project) {
  Value options = Value::Object{}, inputs = Value::Object{};
  for (const auto& [key, value] : request.options)
    if (key != "resume") options.set(key, value);
  for (const project::InputFile& input : project.inputs) inputs.set(input.path, input.sha256);
  Value identity;
  identity.set("program", programBuild());
  identity.set("verb", verb);
  identity.set("options", std::move(options));
  identity.set("scene", request.common.scene.value_or(""));
  identity.set("inputs", std::move(inputs));
  Value settings = project::settingsDocument(project.settings);
  settings.set("ambient", project.settings.ambient.integral(300, 1000));
  identity.set("settings", std::move(settings));
  return identity;
}

void flatten(const Value& value, const std::string& name, std::map<std::string, std::string>& into) {
  if (value.isObject()) {
    for (const auto& [key, member] : value.object()) flatten(member, name.empty() ? key : name + "." + key, into);
    return;
  }
  std::string text = value.isString() ? value.string() : core::toJson(value);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  into[name] = text;
}

/// What differs between two members of identities, as sentences.
std::vector<std::string> differences(const Value& then, const Value& now) {
  std::vector<std::string> sentences;
  const auto texts = [](const Value& identity, const char* part) {
    std::map<std::string, std::string> flat;
    if (const Value* found = identity.find(part)) flatten(*found, "", flat);
    return flat;
  };
  const auto inputsThen = texts(then, "inputs"), inputsNow = texts(now, "inputs");
  for (const auto& [path, hash] : inputsNow) {
    const auto found = inputsThen.find(path);
    if (found == inputsThen.end())
      sentences.push_back(fmt::format("{} was not read then", path));
    else if (found->second != hash)
      sentences.push_back(fmt::format("{} has changed", path));
  }
  for (const auto& [path, hash] : inputsThen)
    if (!inputsNow.contains(path)) sentences.push_back(fmt::format("{} is read no longer", path));
  const auto compare = [&](const char* part, const std::string& before) {
    auto all = texts(then, part);
    const auto current = texts(now, part);
    for (const auto& entry : current) all.try_emplace(entry.first, "");
    for (const auto& [key, was] : all) {
      const auto found = current.find(key);
      const std::string is = found == current.end() ? "" : found->second;
      const auto quoted = [](const std::string& text) { return text.empty() ? "not given" : text; };
      if (was != is) sentences.push_back(fmt::format("{}{} was {} and is {}", before, key, quoted(was), quoted(is)));
    }
  };
  compare("settings", "");
  compare("options", "--");
  compare("scene", "--scene");
  compare("verb", "the verb");
  compare("program", "the program");
  return sentences;
}

}  // namespace

KeptRun::KeptRun(const std::string& verb, const StageRequest& request, const project::Project& project,
                 const std::string& folder, core::ProgressSink& progress)
    : verb_(verb),
      log_(progress, folder, request.options.contains("resume")),
      work_((fs::path(folder) / "checkpoint").string(), core::toJson(identityOf(verb, request, project)),
            request.keepEvery_s.value_or(core::KeptWork::usualInterval)) {
  const bool resumes = request.options.contains("resume");
  Value begin;
  begin.set("program", "goniolux " + programVersion());
  begin.set("verb", verb);
  begin.set("project", project.name);
  begin.set("project_hash", project.hash);
  begin.set("seed", std::to_string(project.settings.seed));
  begin.set("threads", core::threadCount());
  begin.set("resumed", resumes);
  log_.event("begin", begin);
  if (!resumes) return;

  const auto earlier = work_.findEarlier();
  if (!earlier) {
    log_.note(fmt::format("there is no checkpoint in {}: the run begins at its beginning", folder));
    return;
  }
  core::Diagnostics ignored;
  const Value then = core::parseJson(*earlier, work_.file(), ignored);
  const auto changed = differences(then, identityOf(verb, request, project));
  if (!changed.empty())
    throw core::InputError(
        {work_.file(), 0, 0}, "other-checkpoint",
        fmt::format("this checkpoint is of another run: {}; take back what was changed, or run without --resume, which "
                    "begins anew",
                    fmt::join(changed, "; ")));
  if (work_.tornBytes() > 0)
    log_.note(fmt::format("{}: the last {} bytes are not whole; what stands before them is used", work_.file(),
                          work_.tornBytes()));
}

void KeptRun::close(StageReport& report, bool isFinished) {
  Value::Array files;
  for (const std::string& file : report.files) files.emplace_back(file);
  for (const core::Diagnostic& diagnostic : report.warnings.all()) {
    Value warning;
    warning.set("rule", diagnostic.rule);
    warning.set("message", core::toString(diagnostic));
    log_.event("warning", warning);
  }
  if (isFinished) {
    work_.remove();
  } else {
    work_.commit();
    const std::string how = fmt::format("what is finished is kept: `goniolux {} ... --resume` goes on from it", verb_);
    if (report.unfinished)
      report.warnings.warning({}, "unfinished", "interrupted; " + how);
    else
      report.text += fmt::format("  the time limit ended it; {}\n", how);
  }
  Value end;
  end.set("outcome", report.unfinished ? "interrupted" : isFinished ? "finished" : "out of time");
  end.set("recovered_s", work_.recovered().wall_s);
  end.set("files", std::move(files));
  log_.end(end);
}

core::Parameter resumeOption() {
  core::Parameter resume;
  resume.key = "resume";
  resume.title = "an interrupted run";
  resume.kind = core::ParameterKind::boolean;
  resume.help =
      "goes on where one with the same inputs and settings was, to the same bytes; threads and time limit may differ";
  return resume;
}

Meter::Meter(const solver::Solver& solver, const core::Keeping& keeping)
    : solver_(solver), kept_(keeping.log), start_(now()) {
  if (kept_ != nullptr) kept_->countRaysBy([&solver] { return solver.rays(); });
}

Meter::~Meter() {
  if (kept_ != nullptr) kept_->countRaysBy({});
}

core::Spent Meter::now() const {
  const core::Spent before = kept_ == nullptr ? core::Spent{} : kept_->recovered();
  return {core::wallSeconds() + before.wall_s, core::processCpuSeconds() + before.cpu_s, solver_.rays() + before.rays};
}

core::Spent Meter::spent() const {
  const core::Spent end = now();
  return {end.wall_s - start_.wall_s, end.cpu_s - start_.cpu_s, end.rays - start_.rays};
}

}  // namespace goniolux::pipeline
