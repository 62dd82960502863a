#include "stability/run_case.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <regex>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace goniolux::stability {
namespace {

namespace fs = std::filesystem;
using core::Value;

/// What a run of the program came to.
struct Run {
  Outcome trouble = Outcome::right;  ///< declined, tooSlow or crashed; right: it ended well
  std::string message;               ///< both outputs
  Value document;
  std::optional<project::Results> results;
};

double childrensCpu() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Messages name files; the page does not name this machine's folders.
std::string withoutFolder(std::string text) {
  const std::string folder = casesFolder().string() + '/';
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
    text.erase(at, folder.size());
  return text;
}

class Runner {
 public:
  Runner(const Case& one, const std::string& solver) : case_(one), solver_(solver) {}

  Judgement check(const Check& check) {
    if (check.kind == "refused") return refused(check);
    if (check.kind == "warned") return warned(check);
    if (check.kind == "seen") return seen(check);
    if (check.kind == "repeated") return repeated(check);
    const Run& run = illuminate(check.project);
    if (run.trouble != Outcome::right) return {run.trouble, firstLine(run.message)};
    if (check.kind == "same") {
      const Run& other = illuminate(check.text("other"));
      if (other.trouble != Outcome::right) return {other.trouble, firstLine(other.message)};
      return softened(judgeSame(check, *run.results, *other.results), *run.results);
    }
    return softened(check.kind == "finite" ? judgeFinite(check, *run.results) : judgeGrid(check, *run.results),
                    *run.results);
  }

 private:
  Run start(std::vector<std::string> arguments, const std::string& project, const std::string& threads = "1") {
    const double limit = std::ceil(case_.seconds);
    // The CPU time is limited, as the machine may be shared; the wall clock stops what sleeps.
    std::vector<std::string> command = {"timeout",
                                        "-s",
                                        "KILL",
                                        fmt::format("{}", 8 * limit),
                                        "prlimit",
                                        fmt::format("--cpu={}", limit),
                                        GONIOLUX_PROGRAM,
                                        arguments[0],
                                        (casesFolder() / case_.folder / project).string()};
    command.insert(command.end(), arguments.begin() + 1, arguments.end());
    for (const char* more : {"--json", "--quiet", "--threads"}) command.emplace_back(more);
    command.push_back(threads);
    const test::Outcome outcome = test::Running(command).wait();
    Run run;
    run.message = withoutFolder(outcome.err + outcome.out);
    constexpr int signalled = 128, killed = 9, outOfCpu = 24;
    if (outcome.exitCode == signalled + killed || outcome.exitCode == signalled + outOfCpu || outcome.exitCode < 0) {
      run.trouble = Outcome::tooSlow;
      run.message = fmt::format("not done after {} s of CPU time", limit);
    } else if (outcome.exitCode > signalled) {
      run.trouble = Outcome::crashed;
      run.message = fmt::format("ended by signal {}", outcome.exitCode - signalled);
    } else if (outcome.exitCode > 1) {
      run.trouble = Outcome::declined;
    } else {
      core::Diagnostics ignored;
      run.document = core::parseJson(outcome.out, "standard output", ignored);
    }
    return run;
  }

  const Run& illuminate(const std::string& project, const std::string& threads = "1") {
    const auto [known, isNew] = grids_.try_emplace(project + '|' + threads);
    if (!isNew) return known->second;
    const std::string out = folderFor(project, threads);
    known->second = start({"illuminate", "--solver", solver_, "-o", out}, project, threads);
    if (known->second.trouble == Outcome::right)
      known->second.results = project::resultsFromJson(known->second.document);
    return known->second;
  }

  const Run& render(const std::string& project, const std::string& view, const std::string& threads = "1") {
    const auto [known, isNew] = views_.try_emplace(project + '|' + view + '|' + threads);
    if (isNew)
      known->second =
          start({"render", "--solver", solver_, "--view", view, "-o", folderFor(project, threads)}, project, threads);
    return known->second;
  }

  [[nodiscard]] std::string folderFor(const std::string& project, const std::string& threads) const {
    return (folder_.path() / (project + '-' + threads)).string();
  }

  Judgement refused(const Check& check) {
    const Run& run = illuminate(check.project);
    if (run.trouble == Outcome::right) return {Outcome::wrong, "calculated, although there is no answer"};
    if (run.trouble != Outcome::declined) return {run.trouble, run.message};
    if (!std::regex_search(run.message, std::regex(check.text("message"))))
      return {Outcome::wrong, "refused for another reason: " + firstLine(run.message)};
    return {Outcome::refused, firstLine(run.message)};
  }

  Judgement warned(const Check& check) {
    const Run run = start({"check"}, check.project);
    if (run.trouble != Outcome::right) return {run.trouble, firstLine(run.message)};
    const std::regex wanted(check.text("message"));
    for (const Value& warning : run.document.find("warnings")->array()) {
      const std::string& message = warning.find("message")->string();
      if (!std::regex_search(message, wanted)) continue;
      return {check.flag("absent") ? Outcome::wrong : Outcome::right, withoutFolder(message)};
    }
    return {check.flag("absent") ? Outcome::right : Outcome::wrong, "no such warning"};
  }

  Judgement seen(const Check& check) {
    const Run& run = render(check.project, check.text("view"));
    if (run.trouble != Outcome::right) return {run.trouble, firstLine(run.message)};
    const auto& pixel = check.row.find("pixel")->array();
    const test::Outcome probed =
        test::goniolux({"probe", run.document.find("file")->string(),
                        fmt::format("{:g},{:g},{:g}", pixel[0].number(), pixel[1].number(), check.number("radius")),
                        "--json", "--quiet"});
    core::Diagnostics ignored;
    const Value reading = core::parseJson(probed.out, "probe", ignored);
    const Value* luminance = reading.find("luminance_cd_m2");
    if (luminance == nullptr || !luminance->find("value")->isNumber()) return {Outcome::wrong, "no number there"};
    const double tolerance = check.number("tolerance"), reference = check.number("value");
    Figure figure{reference, {}, tolerance * std::abs(reference), tolerance == 0};
    figure.found.value = luminance->find("value")->number();
    const Value* half = luminance->find("half_width");
    figure.found.statistical = half->isNumber() ? half->number() : 0;
    Judgement result = judge({figure}, 0.95);
    if (result.outcome == Outcome::right && !run.document.find("reached")->boolean()) result.outcome = Outcome::wide;
    return softened(result, sentences(run.document));
  }

  /// Grids' values and the picture's bytes, of one thread, two threads, and of a second run.
  Judgement repeated(const Check& check) {
    const Run &one = illuminate(check.project), &two = illuminate(check.project, "2");
    for (const Run* run : {&one, &two})
      if (run->trouble != Outcome::right) return {run->trouble, firstLine(run->message)};
    Check exact = check;
    exact.row.set("exact", true);
    if (const Judgement same = judgeSame(exact, *one.results, *two.results); same.outcome != Outcome::right)
      return same;
    std::vector<std::string> pictures;
    for (const char* threads : {"1", "2"}) {
      const Run& run = render(check.project, check.text("view"), threads);
      if (run.trouble != Outcome::right) return {run.trouble, firstLine(run.message)};
      pictures.push_back(test::contentOf(run.document.find("file")->string()));
    }
    views_.clear();
    pictures.push_back(test::contentOf(render(check.project, check.text("view")).document.find("file")->string()));
    if (pictures[0].empty() || pictures[0] != pictures[1] || pictures[0] != pictures[2])
      return {Outcome::wrong, "the pictures differ"};
    return {Outcome::right, "bit for bit"};
  }

  /// Off, but the results say what they left out.
  Judgement softened(Judgement judgement, const project::Results& results) const {
    return softened(std::move(judgement), results.leftOut);
  }
  [[nodiscard]] Judgement softened(Judgement judgement, const std::vector<std::string>& leftOut) const {
    if (judgement.outcome != Outcome::wrong || case_.says.empty()) return judgement;
    const std::regex wanted(case_.says);
    for (const std::string& sentence : leftOut)
      if (std::regex_search(sentence, wanted)) return {Outcome::says, judgement.detail + "; left out: " + sentence};
    return judgement;
  }
  static std::vector<std::string> sentences(const Value& document) {
    std::vector<std::string> list;
    for (const Value& sentence : document.find("left_out")->array()) list.push_back(sentence.string());
    return list;
  }
  static std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

  const Case& case_;
  std::string solver_;
  test::TemporaryFolder folder_;
  std::map<std::string, Run> grids_, views_;
};

}  // namespace

std::string CaseOutcome::detail(const Case& one) const {
  for (std::size_t i = 0; i < checks.size(); ++i)
    if (checks[i].outcome == outcome) return one.checks[i].what + ": " + checks[i].detail;
  return "";
}

CaseOutcome runCase(const Case& one, const std::string& solver) {
  const double before = childrensCpu();
  CaseOutcome result;
  Runner runner(one, solver);
  const bool hasAnswer =
      std::any_of(one.checks.begin(), one.checks.end(), [](const Check& c) { return c.kind != "refused"; });
  for (const Check& check : one.checks) {
    Judgement judgement = runner.check(check);
    // Where the other checks have answers, a refusal that is asked for is simply right.
    if (hasAnswer && judgement.outcome == Outcome::refused) judgement.outcome = Outcome::right;
    result.checks.push_back(std::move(judgement));
  }
  for (const Judgement& judgement : result.checks)
    if (judgement.outcome > result.outcome) result.outcome = judgement.outcome;
  result.cpuSeconds = childrensCpu() - before;
  return result;
}

}  // namespace goniolux::stability
