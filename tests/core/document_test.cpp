#include "core/document.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace goniolux::core {
namespace {

Value parse(const std::string& text) {
  Diagnostics diagnostics;
  Value value = parseJson(text, "a.json", diagnostics);
  EXPECT_FALSE(diagnostics.hasErrors()) << toString(diagnostics.all().front());
  return value;
}

/// The first error as "line:column: message"; "" when the text was accepted.
std::string errorOf(const std::string& text) {
  Diagnostics diagnostics;
  const Value value = parseJson(text, "a.json", diagnostics);
  if (!diagnostics.hasErrors()) return {};
  EXPECT_TRUE(value.isNull());
  const Diagnostic& first = diagnostics.all().front();
  return std::to_string(first.position.line) + ":" + std::to_string(first.position.column) + ": " + first.message;
}

void expectErrorAt(const std::string& text, const std::string& place, const std::string& words) {
  const std::string error = errorOf(text);
  EXPECT_TRUE(error.starts_with(place + ": ")) << "got '" << error << "' for " << text;
  EXPECT_NE(error.find(words), std::string::npos) << "got '" << error << "' for " << text;
}

TEST(Document, ReadsEveryKindOfValue) {
  const Value value = parse(R"({"n": null, "t": true, "x": -1.5e2, "s": "a\"é\n", "a": [1, 2], "o": {}})");
  ASSERT_TRUE(value.isObject());
  EXPECT_TRUE(value.find("n")->isNull());
  EXPECT_TRUE(value.find("t")->boolean());
  EXPECT_EQ(value.find("x")->number(), -150.0);
  EXPECT_EQ(value.find("s")->string(), "a\"é\n");
  EXPECT_EQ(value.find("a")->array().size(), 2U);
  EXPECT_TRUE(value.find("o")->isObject());
  EXPECT_EQ(value.find("missing"), nullptr);
}

TEST(Document, ValuesAndKeysKnowTheirLineAndColumn) {
  const Value value = parse("{\n  \"name\": \"x\",\n  \"list\": [ 1,\n    { \"deep\" :\n true } ]\n}");
  EXPECT_EQ(value.position().line, 1);
  EXPECT_EQ(value.find("name")->keyPosition().line, 2);
  EXPECT_EQ(value.find("name")->keyPosition().column, 3);
  EXPECT_EQ(value.find("name")->position().column, 11);
  EXPECT_EQ(value.find("name")->position().file, "a.json");
  const Value& deep = *value.find("list")->array()[1].find("deep");
  EXPECT_EQ(deep.keyPosition().line, 4);
  EXPECT_EQ(deep.keyPosition().column, 7);
  EXPECT_EQ(deep.position().line, 5);
  EXPECT_EQ(deep.position().column, 2);
}

TEST(Document, KeyIsFoundAcrossCommentsThatLookLikeJson) {
  const Value value = parse("{\"a\" /* \"no\": */ : // \"nor\": this\n 1, \"b:\": \"c: \\\" d\", \"e\": 2}");
  EXPECT_EQ(value.find("a")->keyPosition().column, 2);
  EXPECT_EQ(value.find("a")->position().line, 2);
  EXPECT_EQ(value.find("b:")->keyPosition().column, 5);
  EXPECT_EQ(value.find("e")->keyPosition().column, 22);
}

TEST(Document, ColumnsCountCharactersNotBytes) {
  const Value value = parse("{\"büro\": 1, \"x\": 2}");
  EXPECT_EQ(value.find("x")->keyPosition().column, 13);
}

TEST(Document, LinesMayEndAsOnAnySystem) {
  EXPECT_EQ(parse("{\r\n\"a\": 1,\r\n\"b\": 2}").find("b")->keyPosition().line, 3);
  EXPECT_EQ(parse("{\r\"a\": 1,\r\"b\": 2}").find("b")->keyPosition().line, 3);
  expectErrorAt("{\r\n\"a\": 1\r\n\"b\": 2}", "3:1", "comma");
}

TEST(Document, MembersKeepTheOrderOfTheFile) {
  const Value value = parse(R"({"zebra": 1, "apple": {"y": 1, "x": 2}, "mango": 3})");
  ASSERT_EQ(value.object().size(), 3U);
  EXPECT_EQ(value.object()[0].first, "zebra");
  EXPECT_EQ(value.object()[1].first, "apple");
  EXPECT_EQ(value.object()[1].second.object()[0].first, "y");
  EXPECT_EQ(value.object()[2].first, "mango");
}

TEST(Document, ByteOrderMarkIsAcceptedAndNotCounted) {
  EXPECT_EQ(parse("\xEF\xBB\xBF{\"a\": 1}").find("a")->keyPosition().column, 2);
}

TEST(Document, CommentsOfBothKindsAreRead) {
  EXPECT_EQ(parse("// head\n{ /* in */ \"a\": 1 } // tail").find("a")->number(), 1);
  EXPECT_EQ(parse("{\"a\": \"http://x/*y*/\"}").find("a")->string(), "http://x/*y*/");
  expectErrorAt("{ \"a\": 1 }\n/* open", "2:1", "never closed");
  expectErrorAt("{ \"a\": 1 / 2 }", "1:10", "single '/'");
}

TEST(Document, RepeatedKeyIsRefusedWhereItStandsAgain) {
  expectErrorAt("{\"a\": 1,\n \"b\": 2,\n \"a\": 3}", "3:2", "'a' stands twice");
}

TEST(Document, TrailingCommaIsRefused) {
  expectErrorAt("{\"a\": [1, 2,]}", "1:13", "comma");
  expectErrorAt("{\"a\": 1,\n}", "2:1", "comma");
}

TEST(Document, TruncatedTextNamesTheOpenBracket) {
  expectErrorAt("{\n \"a\": [1, 2", "2:12", "'[' of line 2, column 7");
  expectErrorAt("{\"a\":", "1:6", "'{' of line 1");
  expectErrorAt("", "1:1", "empty");
  expectErrorAt("\n  \n", "1:1", "empty");
}

TEST(Document, OpenStringIsReportedWhereItBegins) {
  expectErrorAt("{\n \"a: 1,\n \"b\": 2}", "2:2", "does not end on its line");
  expectErrorAt("{\"a\": \"x\\", "1:7", "does not end");
}

TEST(Document, SyntaxErrorsSayWhatIsExpected) {
  expectErrorAt("{\"a\" 1}", "1:6", "colon");
  expectErrorAt("{\"a\": 1 \"b\": 2}", "1:9", "comma or a closing }");
  expectErrorAt("[1 2]", "1:4", "comma or a closing ]");
  expectErrorAt("{\"a\": hello}", "1:7", "value is expected");
  expectErrorAt("{\"a\": 1} x", "1:10", "after the end");
  expectErrorAt("{'a': 1}", "1:2", "\"key\"");
}

TEST(Document, NotANumberAndInfinityAreRefused) {
  for (const char* word : {"NaN", "Infinity", "-Infinity", "nan", "inf"}) {
    EXPECT_NE(errorOf("{\"a\": " + std::string(word) + "}"), "") << word;
  }
  expectErrorAt("{\"a\": NaN}", "1:7", "finite");
  expectErrorAt("{\"a\": -Infinity}", "1:7", "finite");
  expectErrorAt("{\"a\": 1e999}", "1:7", "");
}

TEST(Document, NumbersFollowTheJsonGrammar) {
  for (const char* text : {"0", "-0", "10", "1.25", "1e5", "1E+5", "2.5e-3", "123456789012345678901234567890"}) {
    EXPECT_TRUE(parse(text).isNumber()) << text;
  }
  for (const char* text : {"01", "1.", "-", "1e", "1e+", ".5", "+1", "1.2.3", "1-2", "0x10"}) {
    EXPECT_NE(errorOf(std::string("[") + text + "]"), "") << text;
  }
  EXPECT_EQ(parse("1e-999").number(), 0.0);
}

TEST(Document, BytesThatAreNotUtf8AreRefusedWithTheirPlace) {
  expectErrorAt("{\"a\":\n \"b\xFCro\"}", "2:4", "0xFC");
  expectErrorAt(std::string("{\"a\": 1}\0", 9), "1:9", "0x00");
  expectErrorAt("{\"\xED\xA0\x80\": 1}", "1:3", "UTF-8");  // a lone surrogate
}

TEST(Document, DeepNestingIsRefusedNotOverflowed) {
  EXPECT_NE(errorOf(std::string(100000, '[')).find("nested"), std::string::npos);
  EXPECT_NE(errorOf(std::string(100000, '[') + std::string(100000, ']')).find("nested"), std::string::npos);
  std::string objects;
  for (int i = 0; i < 5000; ++i) objects += "{\"a\":";
  EXPECT_NE(errorOf(objects).find("nested"), std::string::npos);
  EXPECT_EQ(errorOf(std::string(200, '[') + std::string(200, ']')), "");
}

TEST(Document, NumbersAreWrittenWithTheFewestDigitsThatReadBack) {
  EXPECT_EQ(toJson(0.1), "0.1\n");
  EXPECT_EQ(toJson(3), "3\n");
  EXPECT_EQ(toJson(-2.5e-7), "-2.5e-07\n");
  EXPECT_EQ(toJson(1.0 / 3), "0.3333333333333333\n");
  EXPECT_EQ(toJson(std::numeric_limits<double>::quiet_NaN()), "null\n");
  EXPECT_EQ(toJson(std::numeric_limits<double>::infinity()), "null\n");
}

TEST(Document, EveryFiniteNumberSurvivesARoundTrip) {
  std::mt19937_64 random(7);
  Value::Array numbers;
  while (numbers.size() < 20000) {
    const auto number = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (std::isfinite(number)) numbers.emplace_back(number);
  }
  numbers.emplace_back(std::numeric_limits<double>::denorm_min());
  numbers.emplace_back(std::numeric_limits<double>::max());
  const Value back = parse(toJson(numbers));
  ASSERT_EQ(back.array().size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    ASSERT_EQ(back.array()[i].number(), numbers[i].number()) << "number " << i;
  }
}

TEST(Document, WrittenTextReadsBackTheSame) {
  Value value;
  value.set("text", "tab\t quote\" back\\slash \x01 é");
  value.set("points",
            Value::Array{Value::arrayOf(std::vector<double>{1, 2, 3}), Value::arrayOf(std::vector<double>{4})});
  value.set("empty", Value::Array{});
  value.set("none", Value());
  value.set("inner", Value::Object{{"a", true}, {"b", Value::Object{}}});
  const std::string text = toJson(value);
  EXPECT_EQ(toJson(parse(text)), text);
  EXPECT_EQ(parse(text).find("text")->string(), value.find("text")->string());
}

TEST(Document, LongListsOfNumbersAreBrokenAt120Columns) {
  const std::string text = toJson(Value::Object{{"values", Value::arrayOf(std::vector<double>(500, 123.456))}});
  std::size_t longest = 0;
  for (std::size_t start = 0, end; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
    longest = std::max(longest, end - start);
  }
  EXPECT_LE(longest, 120U);
  EXPECT_GT(longest, 100U);
}

TEST(Document, SetReplacesAMemberInItsPlace) {
  Value value;
  value.set("a", 1);
  value.set("b", 2);
  value.set("a", 3);
  ASSERT_EQ(value.object().size(), 2U);
  EXPECT_EQ(value.object()[0].second.number(), 3);
}

}  // namespace
}  // namespace goniolux::core
