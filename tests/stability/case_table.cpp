#include "stability/case_table.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "solver/solver.h"

namespace goniolux::stability {
namespace {

using core::Value;

constexpr std::array<std::pair<Outcome, const char*>, 8> words = {{{Outcome::right, "right"},
                                                                   {Outcome::refused, "refused"},
                                                                   {Outcome::wide, "wide"},
                                                                   {Outcome::says, "says"},
                                                                   {Outcome::declined, "declined"},
                                                                   {Outcome::tooSlow, "too slow"},
                                                                   {Outcome::wrong, "wrong"},
                                                                   {Outcome::crashed, "crashed"}}};

const Value& member(const Value& object, const char* key) {
  const Value* found = object.find(key);
  if (found == nullptr) throw std::runtime_error(std::string("cases.json: an entry has no \"") + key + '"');
  return *found;
}

Case caseFrom(const Value& row) {
  Case one;
  one.number = static_cast<int>(member(row, "case").number());
  one.folder = member(row, "folder").string();
  one.title = member(row, "title").string();
  one.breaks = member(row, "breaks").string();
  one.says = member(row, "says").string();
  one.fast = member(row, "fast").boolean();
  one.seconds = member(row, "seconds").number();
  for (const auto& [solver, word] : member(row, "claims").object()) one.claims[solver] = outcomeFrom(word.string());
  for (const auto& [solver, defect] : member(row, "open_defects").object())
    one.openDefects[solver] = {outcomeFrom(member(defect, "outcome").string()), member(defect, "why").string()};
  for (const Value& check : member(row, "checks").array())
    one.checks.push_back({member(check, "kind").string(), member(check, "what").string(),
                          member(check, "project").string(), member(check, "source").string(), check});
  return one;
}

}  // namespace

const char* wordFor(Outcome outcome) {
  for (const auto& [known, word] : words)
    if (known == outcome) return word;
  return "";
}

Outcome outcomeFrom(const std::string& word) {
  for (const auto& [outcome, known] : words)
    if (known == word) return outcome;
  throw std::runtime_error("no outcome is called \"" + word + '"');
}

bool isWorse(Outcome one, Outcome than) {
  const auto rank = [](Outcome o) { return o == Outcome::refused ? Outcome::right : o; };
  return rank(one) > rank(than);
}

double Check::number(const char* key) const {
  return member(row, key).number();
}
std::string Check::text(const char* key) const {
  return member(row, key).string();
}
bool Check::flag(const char* key) const {
  const Value* found = row.find(key);
  return found != nullptr && found->boolean();
}

Outcome Case::claimOf(const std::string& solver) const {
  const auto own = claims.find(solver);
  return own != claims.end() ? own->second : claims.at("*");
}

const std::pair<Outcome, std::string>* Case::openDefectOf(const std::string& solver) const {
  auto found = openDefects.find(solver);
  if (found == openDefects.end()) found = openDefects.find("*");
  return found == openDefects.end() ? nullptr : &found->second;
}

std::filesystem::path casesFolder() {
  return std::filesystem::path(GONIOLUX_SOURCE_DIR) / "tests" / "stability" / "cases";
}

std::vector<Case> readCases() {
  const std::string file = (casesFolder().parent_path() / "cases.json").string();
  core::Diagnostics diagnostics;
  const Value table = core::parseJson(core::readFile(file), file, diagnostics);
  if (diagnostics.hasErrors()) throw core::InputError(diagnostics);
  std::vector<Case> cases;
  for (const Value& row : member(table, "cases").array()) cases.push_back(caseFrom(row));
  return cases;
}

std::vector<std::string> solverNames() {
  std::vector<std::string> names = {"auto"};
  for (const solver::SolverType& type : solver::solverTypes()) names.push_back(type.name);
  return names;
}

}  // namespace goniolux::stability
