#include "pipeline/verify_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/markup.h"

namespace goniolux::pipeline {
namespace {

using core::escapedMarkup;
using core::Value;
using Verdict = BatchProject::Verdict;

std::string details(const BatchProject& project, const std::string& indent) {
  std::string text;
  if (!project.trouble.empty()) {
    std::string trouble = project.trouble;
    for (std::size_t at = 0; (at = trouble.find('\n', at)) != std::string::npos; at += 1 + indent.size())
      trouble.replace(at, 1, "\n" + indent);
    text += indent + trouble + "\n";
  }
  for (const std::string& input : project.changedInputs) text += indent + "changed input: " + input + "\n";
  for (const Difference& difference : project.differences)
    if (difference.changed) text += indent + sentenceOf(difference) + "\n";
  for (const std::string& remark : project.remarks) text += indent + remark + "\n";
  return text;
}

Value estimateDocument(const core::Estimate& e) {
  Value json;
  json.set("value", e.value);
  json.set("half_width", e.halfWidth());
  return json;
}

Value documentOf(const Difference& d) {
  Value json;
  json.set("of", d.of);
  json.set("quantity", d.quantity);
  if (d.index) json.set("index", static_cast<double>(*d.index));
  json.set("unit", d.unit);
  json.set("expected", estimateDocument(d.expected));
  json.set("found", estimateDocument(d.found));
  json.set("difference", d.difference());
  json.set("allowed", d.allowed);
  if (d.points > 0) json.set("points_changed", static_cast<double>(d.pointsChanged));
  json.set("text", sentenceOf(d));
  return json;
}

}  // namespace

std::size_t countOf(const BatchSummary& batch, Verdict verdict) {
  return static_cast<std::size_t>(std::count_if(batch.projects.begin(), batch.projects.end(),
                                                [&](const BatchProject& p) { return p.verdict == verdict; }));
}

std::string textOf(const BatchSummary& batch) {
  std::string text;
  std::size_t width = 0, updated = 0, inputs = 0;
  for (const BatchProject& project : batch.projects) width = std::max(width, project.path.size());
  for (const BatchProject& project : batch.projects) {
    updated += project.updated ? 1 : 0;
    inputs += project.changedInputs.empty() ? 0 : 1;
    if (!project.ofThisShard) continue;
    text += fmt::format("  {:<11}  {:<{}}", wordFor(project.verdict), project.path, width);
    if (project.verdict == Verdict::passed || project.verdict == Verdict::changed)
      text += fmt::format("  {:2} values, grids at {:.2g} %, {:.1f} s{}", project.differences.size(),
                          100 * project.accuracy, project.seconds, project.kept ? " (kept)" : "");
    text += "\n" + details(project, "      ");
  }
  text += fmt::format("{} projects: {} unchanged, {} changed, {} broken, {} without a baseline, {} not run\n",
                      batch.projects.size(), countOf(batch, Verdict::passed), countOf(batch, Verdict::changed),
                      countOf(batch, Verdict::broken), countOf(batch, Verdict::noBaseline),
                      countOf(batch, Verdict::notRun));
  if (inputs > 0) text += fmt::format("inputs have changed in {} of them\n", inputs);
  if (updated > 0) text += fmt::format("{} baselines renewed\n", updated);
  return text + fmt::format("false alarms: in at most {:g} % of such batches ({} values share it); {:.1f} s\n",
                            100 * batch.falseAlarms, batch.values, batch.seconds);
}

Value documentOf(const BatchSummary& batch) {
  Value json;
  json.set("format", "goniolux-verify");
  json.set("version", 1);
  json.set("program_version", batch.programVersion);
  json.set("false_alarms", batch.falseAlarms);
  json.set("values", static_cast<double>(batch.values));
  json.set("tolerance", batch.tolerance);
  json.set("time_s", batch.seconds);
  Value::Array projects;
  for (const BatchProject& project : batch.projects) {
    if (!project.ofThisShard) continue;
    Value entry;
    entry.set("path", project.path);
    entry.set("verdict", wordFor(project.verdict));
    entry.set("changed_inputs", Value::arrayOf(project.changedInputs));
    Value::Array differences;
    for (const Difference& difference : project.differences)
      if (difference.changed) differences.push_back(documentOf(difference));
    entry.set("differences", std::move(differences));
    entry.set("values", static_cast<double>(project.differences.size()));
    entry.set("accuracy", project.accuracy);
    entry.set("time_s", project.seconds);
    entry.set("results", project.folder);
    if (!project.trouble.empty()) entry.set("error", project.trouble);
    entry.set("updated", project.updated);
    entry.set("remarks", Value::arrayOf(project.remarks));
    projects.push_back(std::move(entry));
  }
  json.set("projects", std::move(projects));
  return json;
}

std::string junitOf(const BatchSummary& batch) {
  std::string cases;
  std::size_t count = 0, failures = 0, errors = 0, skipped = 0;
  for (const BatchProject& project : batch.projects) {
    if (!project.ofThisShard) continue;
    ++count;
    const std::string text = escapedMarkup(details(project, ""));
    std::string inside;
    switch (project.verdict) {
      case Verdict::passed:
        if (!text.empty()) inside = fmt::format("<system-out>{}</system-out>", text);
        break;
      case Verdict::changed: {
        ++failures;
        const auto changed = std::count_if(project.differences.begin(), project.differences.end(),
                                           [](const Difference& d) { return d.changed; });
        inside = fmt::format("<failure message=\"{} of {} values changed\">{}</failure>", changed,
                             project.differences.size(), text);
        break;
      }
      case Verdict::broken:
        ++errors;
        inside = fmt::format("<error message=\"could not be calculated\">{}</error>", text);
        break;
      case Verdict::noBaseline:
      case Verdict::notRun:
        ++skipped;
        inside = fmt::format("<skipped message=\"{}\"/>", wordFor(project.verdict));
    }
    cases += fmt::format("    <testcase classname=\"goniolux.verify\" name=\"{}\" time=\"{:.3f}\">{}</testcase>\n",
                         escapedMarkup(project.path), project.seconds, inside);
  }
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"",
                                         count, failures, errors, skipped, batch.seconds);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n  <testsuite name=\"goniolux verify\" {0}>\n{1}"
      "  </testsuite>\n</testsuites>\n",
      counts, cases);
}

}  // namespace goniolux::pipeline
