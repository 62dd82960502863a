#include "stability/stability_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace goniolux::stability {
namespace {

constexpr const char* opening =
    "# Where methods fail\n\n"
    "Forty scenes on which programs of this kind break, each with an answer that can be checked: closed forms, "
    "integrals, symmetries, or\n"
    "that there is no answer. Every solver must be right within its interval, or say that it cannot; never confidently "
    "wrong.\n\n"
    "This page is written by `script/stability`, which runs all of it with the program itself. The scenes are project "
    "files in\n"
    "[`tests/stability/cases`](../tests/stability/cases), made by `tests/stability/make`, where the references are "
    "calculated; what each solver claims\n"
    "is data ([`cases.json`](../tests/stability/cases.json)), and a claim is given up by a "
    "[decision](decisions/0030-claims-of-solvers.md) only. A test\n"
    "fails when an entry gets worse than it is here.\n\n"
    "| | |\n|---|---|\n"
    "| right | every figure within its interval, to the accuracy asked for. Intervals are of 95 %; what is called off "
    "here lies beyond what chance does in one check of 10 000 |\n"
    "| refused | there is no answer, and the message says why |\n"
    "| wide | within its interval, which is wider than asked for |\n"
    "| says | a figure is off, and the results name under `left_out` what is missing |\n"
    "| declined | nothing is calculated although there is an answer |\n"
    "| too slow, wrong, crashed | defects |\n\n";

std::string link(const Case& one) {
  return fmt::format("[{}](#case-{})", one.title, one.number);
}

std::string figuresOf(const Case& one) {
  std::vector<std::string> sources;
  std::string text;
  for (const Check& check : one.checks) {
    if (std::find(sources.begin(), sources.end(), check.what) != sources.end()) continue;
    sources.push_back(check.what);
    std::string reference;
    if (check.kind == "points" && check.row.find("values")->array().size() <= 5) {
      for (const core::Value& value : check.row.find("values")->array())
        if (value.isNumber()) reference += fmt::format("{}{:.6g}", reference.empty() ? "" : ", ", value.number());
      reference += " lx";
    } else if (check.kind == "weighted") {
      reference = fmt::format("{:.6g} lx", check.number("value"));
    } else if (check.kind == "seen") {
      reference = fmt::format("{:.5g} cd/m2", check.number("value"));
    }
    text += fmt::format("- {}{}: {}\n", check.what, reference.empty() ? "" : ": **" + reference + "**", check.source);
  }
  return text;
}

/// A case's row of the table, and its part of the page.
struct Entry {
  std::string row, part;
};

Entry entryOf(const Case& one, const std::vector<std::string>& solvers,
              const std::map<std::string, CaseOutcome>& outcomes) {
  Entry entry;
  entry.row = fmt::format("| {} | {} |", one.number, link(one));
  std::string remarks;
  for (const std::string& solver : solvers) {
    const CaseOutcome& outcome = outcomes.at(solver);
    entry.row += fmt::format(" {} |", wordFor(outcome.outcome));
    if (isWorse(outcome.outcome, Outcome::right))
      remarks += fmt::format("- `{}` {}: {}\n", solver, wordFor(outcome.outcome), outcome.detail(one));
  }
  entry.row += fmt::format(" {:.1f} |\n", outcomes.at(solvers.front()).cpuSeconds);
  entry.part = fmt::format("\n<a id=\"case-{}\"></a>\n## {}. {}\n\n{}\n\n{}", one.number, one.number, one.title,
                           one.breaks, figuresOf(one));
  if (!remarks.empty()) entry.part += "\nNot right:\n\n" + remarks;
  return entry;
}

Entry entryIn(const std::string& page, int number) {
  const std::size_t row = page.find(fmt::format("\n| {} | [", number)) + 1;
  const std::size_t part = page.find(fmt::format("\n<a id=\"case-{}\"></a>", number));
  if (row == std::string::npos + 1 || part == std::string::npos)
    throw std::runtime_error(fmt::format("case {} has neither an outcome nor an entry on the page", number));
  const std::size_t next = page.find("\n<a id=", part + 1);
  return {page.substr(row, page.find('\n', row) + 1 - row), page.substr(part, next - part)};
}

}  // namespace

std::filesystem::path pageFile() {
  return std::filesystem::path(GONIOLUX_SOURCE_DIR) / "docs" / "stability.md";
}

std::string stabilityPage(const std::vector<Case>& cases, const std::vector<std::string>& solvers,
                          const Outcomes& outcomes, const std::string& before) {
  std::string table = "| case | scene |", rule = "|---|---|", parts, open;
  for (const std::string& solver : solvers) {
    table += " " + solver + " |";
    rule += "---|";
  }
  table += " s |\n" + rule + "---|\n";
  for (const Case& one : cases) {
    const auto run = outcomes.find(one.number);
    const Entry entry = run != outcomes.end() ? entryOf(one, solvers, run->second) : entryIn(before, one.number);
    table += entry.row;
    parts += entry.part;
    for (const auto& [solver, defect] : one.openDefects)
      open += fmt::format("- {}, {} {}: {}\n", link(one), solver == "*" ? "all" : '`' + solver + '`',
                          wordFor(defect.first), defect.second);
  }
  std::string page = opening + table;
  page +=
      "\nThe last column is the CPU time of `auto` for all projects of the case, on the machine that wrote this "
      "page.\n\n";
  std::map<std::string, std::map<Outcome, int>> sums;
  for (const auto& [number, row] : recordFrom(page))
    for (const auto& [solver, outcome] : row) ++sums[solver][outcome];
  for (const std::string& solver : solvers) {
    page += fmt::format("- `{}`:", solver);
    for (const auto& [outcome, count] : sums[solver]) page += fmt::format(" {} {},", count, wordFor(outcome));
    page.back() = '\n';
  }
  if (!open.empty()) page += "\n## Open defects\n\nShort of what is claimed, and known to be:\n\n" + open;
  return page + parts;
}

Record recordFrom(const std::string& page) {
  Record record;
  std::istringstream lines(page);
  std::vector<std::string> solvers;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) {
      const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    if (cells.size() < 5) continue;
    if (cells[1] == "case") {
      solvers.assign(cells.begin() + 3, cells.end() - 1);
      continue;
    }
    if (solvers.empty() || cells[1].empty() || cells[1].find_first_not_of("0123456789") != std::string::npos) continue;
    if (cells.size() != solvers.size() + 4) throw std::runtime_error("a row of the table has another length: " + line);
    for (std::size_t i = 0; i < solvers.size(); ++i)
      record[std::stoi(cells[1])][solvers[i]] = outcomeFrom(cells[i + 3]);
  }
  if (record.empty()) throw std::runtime_error("the page has no table of cases");
  return record;
}

}  // namespace goniolux::stability
