// The report's HTML: numbers in the reader's units and language, text that cannot break the page, nothing untranslated.
#include "report/report.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "core/document.h"
#include "report/words.h"

namespace goniolux::report {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Report sample() {
  Report report;
  report.results.project = "Room <1> & \"two\"";
  project::GridResult grid;
  grid.name = "desk";
  grid.counts = {2, 1};
  grid.points = {{0, 0, 1}, {1, 0, 1}};
  grid.values = {1000, 1234.5};
  grid.halfWidths = {10, 10};
  grid.mean = {1117.25, 7, {}};
  grid.min = {1000, 10, {}};
  grid.max = {1234.5, 10, {}};
  grid.u0 = {0.895, 0.01, {}};
  report.results.grids.push_back(grid);
  report.results.leftOut = {"fluorescence"};
  project::RequirementResult requirement;
  requirement.text = "desk mean_lx >= 500";
  requirement.verdict = project::RequirementResult::Verdict::pass;
  requirement.of = "desk";
  requirement.quantity = "mean_lx";
  requirement.minimum = 500;
  requirement.found = grid.mean;
  requirement.clause = "EN 12464-1:2021, 34.2";
  report.results.requirements.push_back(requirement);
  return report;
}

TEST(Report, StatesValuesWithIntervalsRequirementsAndWhatIsLeftOut) {
  const std::string html = htmlOf(sample());
  for (const char* part :
       {"1117 ± 7 lx", "at least 500 lx", "EN 12464-1:2021, 34.2", "0.895 ± 0.010", "fluorescence", "met"})
    EXPECT_TRUE(contains(html, part)) << part;
}

TEST(Report, ShowsWhatEachGroupGivesAndWhoGlares) {
  Report report = sample();
  EXPECT_FALSE(contains(htmlOf(report), "Contribution of each group"));
  // 837.94 of 1117.25 lx are three quarters.
  report.contributions = {{"ceiling", 0.5, {{837.9375, 5, {}}}}, {"<spots>", 1, {{279.3125, 3, {}}}}};
  project::ObserverResult observer{"seat", "ugr", {18.2, 0.2, {}}, {}, {}, {}, {}};
  observer.sources = {{"P[0,1]", 4000, 0.01, 2, 0.6}, {"P[1,1]", 4000, 0.01, 2, 0.4}};
  report.results.observers.push_back(observer);
  const std::string html = htmlOf(report);
  for (const char* part : {"838 ± 5 lx", "75 %", "50 %", "&lt;spots&gt;", "25 %", "P[0,1] 60 %, P[1,1] 40 %"})
    EXPECT_TRUE(contains(html, part)) << part;
}

TEST(Report, ShowsTheSpeedChartWhereTheProjectWasStudied) {
  Report report = sample();
  EXPECT_FALSE(contains(htmlOf(report), "Speed against accuracy"));
  report.speedChart = Picture{"work-precision", "image/svg+xml", "<svg/>"};
  EXPECT_TRUE(contains(htmlOf(report), "Speed against accuracy"));
  EXPECT_TRUE(contains(htmlOf(report), "data:image/svg+xml;base64,PHN2Zy8+"));
}

TEST(Report, EscapesNamesInTextAndInStyle) {
  const std::string html = htmlOf(sample());
  EXPECT_TRUE(contains(html, "Room &lt;1&gt; &amp; &quot;two&quot;"));
  EXPECT_FALSE(contains(html, "Room <1>"));
  EXPECT_FALSE(contains(html, "& \"two\""));
}

TEST(Report, ConvertsToFootcandlesAndGermanNumbers) {
  Report report = sample();
  report.units = Units::imperial;
  // 1 fc = 1 lm/ft2 = 10.763910417 lx: 1117.25 lx = 103.796 fc, 7 lx = 0.650 fc; 500 lx = 46.45 fc.
  EXPECT_TRUE(contains(htmlOf(report), "103.8 ± 0.7 fc"));
  EXPECT_TRUE(contains(htmlOf(report), "at least 46.5 fc"));
  report.language = Language::german;
  EXPECT_TRUE(contains(htmlOf(report), "103,8 ± 0,7 fc"));
  EXPECT_TRUE(contains(htmlOf(report), "mindestens 46,5 fc"));
  report.results.requirements[0].clause = "EN 12464-1:2021, 34.3 (figures unconfirmed)";
  EXPECT_TRUE(contains(htmlOf(report), "EN 12464-1:2021, 34.3 (Zahlen unbestätigt)"));
}

TEST(Report, ValuesStandBesideTheirCoordinates) {
  Report report = sample();
  project::GridResult& grid = report.results.grids[0];
  grid.counts = {2, 2};
  grid.points = {{0.5, 0.25, 1}, {1.5, 0.25, 1}, {0.5, 1.75, 1}, {1.5, 1.75, 1}};
  grid.values = {1, 2, 3, 4};
  std::string html = htmlOf(report);
  EXPECT_TRUE(contains(html, "<tr><th>1.75</th><td>3.00</td><td>4.00</td></tr>")) << "the v axis upward";
  EXPECT_TRUE(contains(html, "<tr><th>y, x / m</th><th>0.50</th><th>1.50</th></tr>"));
  grid.points[1] = {1.1, 1.05, 1};  // an edge along 3, 4: the distance of 1 m
  html = htmlOf(report);
  EXPECT_TRUE(contains(html, "<tr><th>y, u / m</th><th>0.00</th><th>1.00</th></tr>"));
}

TEST(Report, LuminaireSheetsSpeakTheReadersLanguageAndUnits) {
  Report report = sample();
  LuminaireType type;
  type.letter = "A", type.name = "batten", type.flux_lm = 4000, type.count = 1;
  type.opening = {"rectangle", 1.524, 0.3048, 0};
  type.beamC0_deg = 258, type.beamC90_deg = 111.2, type.fieldC0_deg = type.fieldC90_deg = 360;
  type.cct_K = 4000, type.ra = 83;
  report.luminaires = {type};
  report.surfaces = {{"room", "floor, xmin, ymax", "paint", 0.7}};
  std::string html = htmlOf(report);
  for (const char* part : {"rectangle, 1.52\u00a0m\u00a0(C0) × 0.30\u00a0m\u00a0(C90)", "258° (C0), 111° (C90)",
                           "<td>360°</td>", "4000 K, R<sub>a</sub> 83", "floor, wall x min, wall y max"})
    EXPECT_TRUE(contains(html, part)) << part;
  report.language = Language::german;
  report.units = Units::imperial;
  html = htmlOf(report);
  for (const char* part :
       {"Rechteck, 5,00\u00a0ft\u00a0(C0) × 1,00\u00a0ft\u00a0(C90)", "Boden, Wand x min, Wand y max"})
    EXPECT_TRUE(contains(html, part)) << part;
}

TEST(Words, SentencesOfTheCalculationAreTranslatedWithTheirNumbers) {
  const Words german(Language::german, Units::metric), english(Language::english, Units::metric);
  const std::string sentence = "wavelengths between 7 spectral samples: at most 0.19 % of E";
  EXPECT_EQ(german.sentence(sentence), "Wellenlängen zwischen 7 Stützstellen: höchstens 0,19 % von E");
  EXPECT_EQ(english.sentence(sentence), sentence);
  EXPECT_EQ(german.sentence("the project has changed since these results were calculated: a.ies, b.spd"),
            "das Projekt hat sich geändert, seit diese Ergebnisse berechnet wurden: a.ies, b.spd");
  EXPECT_EQ(german.sentence("wavelengths between 7 spectral samples: who knows"),
            "wavelengths between 7 spectral samples: who knows");
}

TEST(Words, GroupsThousandsAndChoosesTheDecimalSign) {
  const Words english(Language::english, Units::metric), german(Language::german, Units::metric);
  EXPECT_EQ(english.number(24000, 0), "24\u202f000");
  EXPECT_EQ(english.number(4000, 0), "4000");
  EXPECT_EQ(german.number(-1234567.25, 2), "−1\u202f234\u202f567,25");
  EXPECT_NEAR(Words(Language::english, Units::imperial).factor("m2"), 10.7639104, 1e-6);
}

TEST(Words, EveryTextOfTheReportHasAGermanOne) {
  const Words words(Language::german, Units::metric);
  const std::filesystem::path folder = std::filesystem::path(GONIOLUX_SOURCE_DIR) / "src/report";
  // words("…") with a text that may be broken over several literals.
  const std::regex call("words\\(((?:\\s*\"(?:[^\"\\\\]|\\\\.)*\")+)\\s*\\)"), literal("\"((?:[^\"\\\\]|\\\\.)*)\"");
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string source = core::readFile(entry.path().string());
    for (std::sregex_iterator it(source.begin(), source.end(), call), end; it != end; ++it) {
      const std::string pieces = (*it)[1];
      std::string text;
      for (std::sregex_iterator piece(pieces.begin(), pieces.end(), literal); piece != end; ++piece)
        text += (*piece)[1];
      EXPECT_TRUE(words.hasTranslation(text)) << entry.path().filename() << ": " << text;
      ++count;
    }
  }
  EXPECT_GT(count, 60);
  for (const char* key : {"mean_lx", "min_lx", "max_lx", "u0", "ud", "ugr"})
    EXPECT_TRUE(words.hasTranslation(limitName(key))) << key;
}

}  // namespace
}  // namespace goniolux::report
