#include "core/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace goniolux::core {
namespace {

TEST(Text, LineEndsOfAllSystemsPartLines) {
  TextScanner scanner("one\r\ntwo\nthree\rfour");
  for (const auto& [content, number] :
       {std::pair{"one", 1}, std::pair{"two", 2}, std::pair{"three", 3}, std::pair{"four", 4}}) {
    const auto line = scanner.line();
    ASSERT_TRUE(line);
    EXPECT_EQ(line->text, content);
    EXPECT_EQ(line->line, number);
  }
  EXPECT_FALSE(scanner.line());
}

TEST(Text, EmptyLinesCount) {
  TextScanner scanner("\n\r\n\rx");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(scanner.line()->text, "");
  EXPECT_EQ(scanner.line()->line, 4);
}

TEST(Text, WordsKnowTheirLineAndColumn) {
  TextScanner scanner("  1, 2\t3\r\n\r\n4,,5");
  const std::vector<std::tuple<std::string, int, int>> expected{
      {"1", 1, 3}, {"2", 1, 6}, {"3", 1, 8}, {"4", 3, 1}, {"5", 3, 4}};
  for (const auto& [text, line, column] : expected) {
    const auto word = scanner.word(",");
    ASSERT_TRUE(word);
    EXPECT_EQ(word->text, text);
    EXPECT_EQ(word->line, line);
    EXPECT_EQ(word->column, column);
  }
  EXPECT_FALSE(scanner.word(","));
  EXPECT_TRUE(scanner.atEnd());
}

TEST(Text, ALineAfterWordsIsTheRestOfItsLine) {
  TextScanner scanner("a b c\nd");
  EXPECT_EQ(scanner.word("")->text, "a");
  const auto rest = scanner.line();
  EXPECT_EQ(rest->text, " b c");
  EXPECT_EQ(rest->column, 2);
  EXPECT_EQ(scanner.line()->text, "d");
}

TEST(Text, CtrlZEndsTheTextAndAByteOrderMarkIsPassed) {
  TextScanner scanner(
      "\xEF\xBB\xBF"
      "1 2\x1A 3 4");
  EXPECT_EQ(scanner.word("")->text, "1");
  EXPECT_EQ(scanner.word("")->text, "2");
  EXPECT_FALSE(scanner.word(""));
}

TEST(Text, NumbersAreReadInEveryUsualSpelling) {
  for (const auto& [text, value] : {std::pair{"12", 12.0},
                                    {"-0.5", -0.5},
                                    {"+3", 3.0},
                                    {".25", 0.25},
                                    {"7.", 7.0},
                                    {"1.4568E+0010", 1.4568e10},
                                    {"1e-3", 1e-3},
                                    {"1.0D+03", 1000.0},
                                    {"2d2", 200.0}}) {
    ASSERT_TRUE(parseNumber(text)) << text;
    EXPECT_DOUBLE_EQ(*parseNumber(text), value) << text;
  }
}

TEST(Text, WhatIsNoNumberIsNone) {
  for (const char* text : {"", "+", "-", "one", "1x", "1 2", "1,5", "0x10", "++1", "+-1", "1e", "d", "1e400", "--1"}) {
    EXPECT_FALSE(parseNumber(text)) << text;
  }
  EXPECT_TRUE(std::isnan(*parseNumber("nan")));
  EXPECT_EQ(*parseNumber("-inf"), -std::numeric_limits<double>::infinity());
}

TEST(Text, EncodingsAreToldApart) {
  EXPECT_EQ(detectEncoding("plain"), Encoding::ascii);
  EXPECT_EQ(detectEncoding("L\xC3\xA4nge"), Encoding::utf8);
  EXPECT_EQ(detectEncoding("L\xE4nge"), Encoding::latin1);
  EXPECT_EQ(detectEncoding("\x92\xE8\x8A\x69(\xD3\xB0\xC4\xDE)"), Encoding::shiftJis);
  EXPECT_EQ(detectEncoding(std::string_view("\xFF\xFE"
                                            "1\0",
                                            4)),
            Encoding::utf16);
  EXPECT_EQ(detectEncoding(std::string_view("\0I\0E\0S\0N\0A", 10)), Encoding::utf16);
  EXPECT_EQ(detectEncoding(std::string_view("\0\0\0\0\0\0\0\0", 8)), Encoding::ascii);
}

TEST(Text, EncodingsBecomeUtf8) {
  EXPECT_EQ(toUtf8("L\xE4nge", Encoding::latin1), "L\xC3\xA4nge");
  EXPECT_EQ(toUtf8("\x80 5", Encoding::latin1), "\xE2\x82\xAC 5");  // the euro of Windows-1252
  EXPECT_EQ(toUtf8("\x92\xE8\x8A\x69", Encoding::shiftJis), "\xE5\xAE\x9A\xE6\xA0\xBC");
  EXPECT_EQ(toUtf8("\xEF\xBB\xBFx", Encoding::utf8), "x");
  EXPECT_EQ(toUtf8(std::string_view("\xFF\xFE\xE4\0", 4), Encoding::utf16), "\xC3\xA4");
}

TEST(Text, OverlongAndSurrogateFormsAreNoUtf8) {
  for (const char* bytes : {"\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xC3", "\x80"}) {
    EXPECT_NE(detectEncoding(bytes), Encoding::utf8);
  }
}

}  // namespace
}  // namespace goniolux::core
