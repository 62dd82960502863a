// Malformed and odd photometric files: each is refused with its line and rule, or read with a named warning; none
// crashes. The list follows what other readers crash on or swallow.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "core/diagnostics.h"
#include "photometry/photometric_file.h"

namespace goniolux::photometry {
namespace {

const std::string start = "IESNA:LM-63-2002\n[TEST] t\nTILT=NONE\n";
const std::string header = "1 1000 1 3 2 1 2 0.6 0.6 0\n1 1 10\n";
const std::string angles = "0 45 90\n0 90\n";
const std::string candelas = "100 70 0\n100 60 0\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

struct Refused {
  const char* name;
  std::string text;
  int line;
  const char* rule;
};

std::vector<Refused> refusedFiles() {
  return {
      {"Empty", "", 1, "empty-file"},
      {"OnlyBlanks", "\r\n \n", 1, "empty-file"},
      {"OnlyNulBytes", std::string(5, '\0'), 1, "empty-file"},
      {"Binary",
       "\x7F"
       "ELF\x01\x02\xFF\xFE garbage",
       1, "tilt-line-missing"},
      {"HeaderOnly", "IESNA:LM-63-2002\n[TEST] t\n", 3, "tilt-line-missing"},
      {"NoTiltLine", "IESNA:LM-63-2002\n[TEST] t\n" + header + angles + candelas, 9, "tilt-line-missing"},
      {"EmptyTilt", replaced(start, "NONE", "") + header + angles + candelas, 3, "tilt-empty"},
      {"NothingAfterTilt", start, 4, "file-ends-early"},
      {"HeaderCutShort", start + "1 1000 1 3", 4, "file-ends-early"},
      {"MissingAngles", start + header, 6, "file-ends-early"},
      {"MissingCandelas", start + header + angles, 8, "file-ends-early"},
      {"OneCandelaTooFew", start + header + angles + "100 70 0\n100 60\n", 10, "file-ends-early"},
      {"CountTooLarge", start + replaced(header, "1 3 2", "1 4 2") + angles + candelas, 7, "angles-not-ascending"},
      {"ABillionVerticalAngles", start + replaced(header, "1 3 2", "1 1000000000 2") + angles + candelas, 4,
       "file-ends-early"},
      {"CountsWhoseProductOverflows", start + replaced(header, "1 3 2", "1 1000000000 1000000000") + angles + candelas,
       4, "file-ends-early"},
      {"CountBeyondIntegers", start + replaced(header, "1 3 2", "1 99999999999999999999 2") + angles + candelas, 4,
       "bad-count"},
      {"NegativeCount", start + replaced(header, "1 3 2", "1 -3 2") + angles + candelas, 4, "bad-count"},
      {"ZeroCount", start + replaced(header, "1 3 2", "1 3 0") + angles + candelas, 4, "bad-count"},
      {"FractionalCount", start + replaced(header, "1 3 2", "1 3.5 2") + angles + candelas, 4, "bad-count"},
      {"OneVerticalAngle", start + replaced(header, "1 3 2", "1 1 2") + angles + candelas, 4, "bad-count"},
      {"TextInsteadOfANumber", start + replaced(header, "1 3 2", "1 three 2") + angles + candelas, 4, "not-a-number"},
      {"TextAmongCandelas", start + header + angles + "100 abc 0\n100 60 0\n", 8, "not-a-number"},
      {"NanCandela", start + header + angles + "100 nan 0\n100 60 0\n", 8, "not-finite"},
      {"InfiniteCandela", start + header + angles + "100 inf 0\n100 60 0\n", 8, "not-finite"},
      {"NanSize", start + replaced(header, "0.6 0.6", "nan 0.6") + angles + candelas, 4, "not-finite"},
      {"NanMultiplier", start + replaced(header, "1000 1 3", "1000 nan 3") + angles + candelas, 4, "not-finite"},
      {"CandelaBeyondDoubles", start + header + angles + "100 1e999 0\n100 60 0\n", 8, "not-a-number"},
      {"CandelaOf1e300", start + header + angles + "100 1e300 0\n100 60 0\n", 8, "candela-too-large"},
      {"NegativeCandela", start + header + angles + "100 -70 0\n100 60 0\n", 8, "negative-candela"},
      {"ZeroMultiplier", start + replaced(header, "1000 1 3", "1000 0 3") + angles + candelas, 4, "bad-multiplier"},
      {"NegativeMultiplier", start + replaced(header, "1000 1 3", "1000 -1 3") + angles + candelas, 4,
       "bad-multiplier"},
      {"ZeroBallastFactor", start + replaced(header, "1 1 10", "0 1 10") + angles + candelas, 5, "bad-multiplier"},
      {"UnknownPhotometryType", start + replaced(header, "2 1 2", "2 7 2") + angles + candelas, 4, "bad-count"},
      {"UnknownUnits", start + replaced(header, "2 1 2", "2 1 7") + angles + candelas, 4, "bad-count"},
      {"UnsortedVerticals", start + header + "0 90 45\n0 90\n" + candelas, 6, "angles-not-ascending"},
      {"RepeatedVerticals", start + header + "0 45 45\n0 90\n" + candelas, 6, "angles-not-ascending"},
      {"UnsortedHorizontals", start + header + "0 45 90\n90 0\n" + candelas, 7, "angles-not-ascending"},
      {"VerticalAngleOf400", start + header + "0 45 400\n0 90\n" + candelas, 6, "angle-out-of-range"},
      {"HorizontalAngleOf400", start + header + "0 45 90\n0 400\n" + candelas, 7, "angle-out-of-range"},
      {"NegativeGamma", start + header + "-45 0 90\n0 90\n" + candelas, 6, "angle-out-of-range"},
      {"HorizontalsThatEndAt45", start + header + "0 45 90\n0 45\n" + candelas, 7, "horizontal-range"},
      {"HorizontalsThatBeginAt10", start + header + "0 45 90\n10 360\n" + candelas, 7, "horizontal-range"},
      {"ABillionTiltAngles",
       replaced(start, "NONE", "INCLUDE") + "1\n1000000000\n0 90\n1 1\n" + header + angles + candelas, 5,
       "file-ends-early"},
      {"NoTiltAngles", replaced(start, "NONE", "INCLUDE") + "1\n0\n" + header + angles + candelas, 5, "bad-count"},
      {"BallastLineMissing", start + "1 1000 1 3 2 1 2 0.6 0.6 0\n" + angles + candelas, 5, "bad-multiplier"},
      {"Utf16", std::string("\xFF\xFEI\0E\0S\0N\0A\0", 12), 1, "utf-16"},
  };
}

template <typename Case>
std::string nameOf(const testing::TestParamInfo<Case>& parameter) {
  return parameter.param.name;
}

class RefusedFile : public testing::TestWithParam<Refused> {};

TEST_P(RefusedFile, IsRefusedAtItsLineAtOnce) {
  const Refused& c = GetParam();
  const auto begin = std::chrono::steady_clock::now();
  try {
    (void)readPhotometry(c.text, "bad.ies");
    FAIL() << "was read";
  } catch (const core::InputError& error) {
    const core::Diagnostic& d = error.diagnostics().all().back();
    EXPECT_EQ(d.position.line, c.line) << error.what();
    EXPECT_EQ(d.rule, c.rule) << error.what();
    EXPECT_EQ(d.position.file, "bad.ies");
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

INSTANTIATE_TEST_SUITE_P(Lm63, RefusedFile, testing::ValuesIn(refusedFiles()), nameOf<Refused>);

struct Accepted {
  const char* name;
  std::string text;
  const char* rule;  ///< of the warning that says what was assumed
};

std::vector<Accepted> oddFiles() {
  return {
      {"CountOneTooSmall", start + header + angles + candelas + "100\n", "trailing-numbers"},
      {"NoLight", start + header + angles + "0 0 0\n0 0 0\n", "no-light"},
      {"NoLampFlux", start + replaced(header, "1 1000", "1 0") + angles + candelas, "no-lamp-flux"},
      {"MinusTwoLumens", start + replaced(header, "1 1000", "1 -2") + angles + candelas, "negative-lumens"},
      {"NegativeWatts", start + replaced(header, "1 1 10", "1 1 -10") + angles + candelas, "negative-watts"},
      {"OddDimensions", start + replaced(header, "0.6 0.6 0", "0.6 0.6 -1") + angles + candelas, "opening-other"},
      {"MissingTiltFile", replaced(start, "NONE", "no-such-lamp.tlt") + header + angles + candelas,
       "tilt-file-missing"},
      {"MoreLightThanTheLampsGive", start + replaced(header, "1 1000", "1 10") + angles + candelas, "flux-above-lamps"},
  };
}

class OddFile : public testing::TestWithParam<Accepted> {};

TEST_P(OddFile, IsReadWithANamedWarning) {
  const PhotometricFile file = readPhotometry(GetParam().text, "odd.ies");
  const auto& all = file.warnings.all();
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const core::Diagnostic& d) { return d.rule == GetParam().rule; }));
}

INSTANTIATE_TEST_SUITE_P(Lm63, OddFile, testing::ValuesIn(oddFiles()), nameOf<Accepted>);

TEST(MalformedFile, AMegabyteOfLabelIsRead) {
  const PhotometricFile file = readPhotometry(
      "IESNA:LM-63-2002\n[TEST] " + std::string(1 << 20, 'x') + "\nTILT=NONE\n" + header + angles + candelas,
      "long.ies");
  EXPECT_EQ(file.keywords.at("TEST").size(), std::size_t{1} << 20);
}

TEST(MalformedFile, EulumdatsAreRefusedAtTheirLine) {
  const std::string head =
      "Company\n1\n1\n1\n0\n3\n45\nr\nl\nn\nf\nd\n100\n0\n50\n100\n0\n0\n0\n0\n0\n100\n100\n1\n0\n";
  const std::string lamp = "1\n1\nLED\n1000\n840\n80\n10\n", ratios = "0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n",
                    rest = "0\n0\n45\n90\n100\n70\n0\n";
  EXPECT_NO_THROW((void)readPhotometry(head + lamp + ratios + rest, "good.ldt"));
  const std::vector<Refused> cases{
      {"CutInHeader", head.substr(0, 40), 16, "file-ends-early"},
      {"CutInTable", head + lamp + ratios + "0\n0\n45\n", 46, "file-ends-early"},
      {"UnknownSymmetry", replaced(head, "Company\n1\n1\n", "Company\n1\n7\n") + lamp + ratios + rest, 3, "bad-count"},
      {"ABillionPlanes", replaced(head, "Company\n1\n1\n1\n", "Company\n1\n0\n1000000000\n") + lamp + ratios + rest, 43,
       "file-ends-early"},
      {"PlanesThatDoNotFit", replaced(head, "Company\n1\n1\n1\n", "Company\n1\n4\n3\n") + lamp + ratios + rest, 4,
       "bad-count"},
      {"NoLampSets", head + "0\n" + ratios + rest, 26, "bad-count"},
      {"NoLampFlux", head + replaced(lamp, "1000", "0") + ratios + rest, 29, "no-lamp-flux"},
      {"TextForANumber", replaced(head, "\n50\n", "\nfifty\n") + lamp + ratios + rest, 15, "not-a-number"},
      {"NegativeIntensity", head + lamp + ratios + replaced(rest, "70", "-7"), 48, "negative-candela"},
      {"AnglesNotAscending", head + lamp + ratios + replaced(rest, "45", "95"), 46, "angles-not-ascending"}};
  for (const Refused& c : cases) {
    SCOPED_TRACE(c.name);
    try {
      (void)readPhotometry(c.text, "bad.ldt");
      ADD_FAILURE() << "was read";
    } catch (const core::InputError& error) {
      EXPECT_EQ(error.diagnostics().all().back().rule, c.rule) << error.what();
      EXPECT_EQ(error.diagnostics().all().back().position.line, c.line) << error.what();
    }
  }
}

TEST(MalformedFile, OtherFormatsAreNamedOrRefused) {
  const auto message = [](const std::string& text, const char* name) -> std::string {
    try {
      (void)readPhotometry(text, name);
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("PK\x03\x04 zip", "a.gldf").find("not supported yet: GLDF"), std::string::npos);
  EXPECT_NE(message("<?xml?>\n<IESTM33-22>", "a.xml").find("error: this is not well-formed XML"), std::string::npos);
  EXPECT_NE(message("hello", "a.txt").find("no photometric file"), std::string::npos);
  EXPECT_NE(message("hello", "a.xml").find("not well-formed"), std::string::npos);
}

}  // namespace
}  // namespace goniolux::photometry
