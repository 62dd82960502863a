#include "core/document.h"

#include <fmt/format.h>
#include <json/json.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/json_text.h"

namespace goniolux::core {
namespace {

/// "0", "-1.5", "2e-3": JsonCpp also takes 01 and 1., which other readers of the same file would refuse.
bool isJsonNumber(std::string_view text) {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t start = i;
    while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
    return i - start;
  };
  if (i < text.size() && text[i] == '-') ++i;
  const bool leadingZero = i < text.size() && text[i] == '0';
  const std::size_t whole = digits();
  if (whole == 0 || (leadingZero && whole > 1)) return false;
  if (i < text.size() && text[i] == '.') {
    ++i;
    if (digits() == 0) return false;
  }
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (digits() == 0) return false;
  }
  return i == text.size();
}

/// Turns JsonCpp's tree into Values. JsonCpp sorts members by name; their offsets bring back the order of the file.
class Converter {
 public:
  Converter(const JsonText& scan, const std::string& file, Diagnostics& diagnostics)
      : text_(scan.withoutComments()), scan_(scan), file_(file), diagnostics_(diagnostics) {}

  Value convert(const Json::Value& json) {
    Value value = content(json);
    value.setPosition(scan_.position(offset(json), file_));
    return value;
  }

 private:
  static std::size_t offset(const Json::Value& json) { return static_cast<std::size_t>(json.getOffsetStart()); }

  Value content(const Json::Value& json) {
    switch (json.type()) {
      case Json::nullValue:
        return {};
      case Json::booleanValue:
        return json.asBool();
      case Json::stringValue:
        return json.asString();
      case Json::arrayValue: {
        Value::Array values;
        values.reserve(json.size());
        for (const Json::Value& element : json) values.push_back(convert(element));
        return values;
      }
      case Json::objectValue:
        return object(json);
      default:
        return number(json);
    }
  }

  Value object(const Json::Value& json) {
    std::vector<std::pair<std::string, const Json::Value*>> members;
    for (auto member = json.begin(); member != json.end(); ++member) members.emplace_back(member.name(), &*member);
    std::sort(members.begin(), members.end(),
              [](const auto& a, const auto& b) { return offset(*a.second) < offset(*b.second); });
    Value::Object object;
    object.reserve(members.size());
    for (auto& [key, child] : members) {
      Value value = convert(*child);
      value.setKeyPosition(scan_.position(scan_.keyBefore(offset(*child)), file_));
      object.emplace_back(std::move(key), std::move(value));
    }
    return object;
  }

  // Read again from the text: one rule for all numbers (correctly rounded, no integer types, independent of the
  // locale).
  Value number(const Json::Value& json) {
    const std::string_view token =
        text_.substr(offset(json), static_cast<std::size_t>(json.getOffsetLimit()) - offset(json));
    double value = 0;
    if (!isJsonNumber(token)) {
      diagnostics_.error(scan_.position(offset(json), file_), "json-syntax",
                         fmt::format("'{}' is not a JSON number; write it like 0.5, 12 or 1e-3", token));
      return 0.0;
    }
    const auto result = std::from_chars(token.data(), token.data() + token.size(), value);
    if (result.ec == std::errc::result_out_of_range) {
      // Too small becomes 0 as in every other reader; too large has no meaning.
      value = std::strtod(std::string(token).c_str(), nullptr);
      if (!std::isfinite(value)) {
        diagnostics_.error(scan_.position(offset(json), file_), "json-syntax",
                           fmt::format("{} is too large for a number; give a value below 1.8e308", token));
        return 0.0;
      }
    }
    return value;
  }

  std::string_view text_;
  const JsonText& scan_;
  const std::string& file_;
  Diagnostics& diagnostics_;
};

Json::CharReaderBuilder readerSettings() {
  Json::CharReaderBuilder builder;
  builder["collectComments"] = false;
  builder["allowComments"] = false;  // JsonText has blanked them: JsonCpp takes them in some places only
  builder["allowTrailingCommas"] = false;
  builder["allowSpecialFloats"] = false;
  builder["allowDroppedNullPlaceholders"] = false;
  builder["rejectDupKeys"] = true;
  builder["failIfExtra"] = true;
  builder["stackLimit"] = JsonText::deepestNesting + 10;
  return builder;
}

/// JsonCpp's first error, "* Line 3, Column 5\n  Missing ...", as a diagnostic. Later ones are mostly echoes of the
/// first.
void reportSyntaxError(const std::string& errors, const JsonText& scan, const std::string& file,
                       Diagnostics& diagnostics) {
  std::size_t line = 1, column = 1;
  std::string message = errors;
  if (std::sscanf(errors.c_str(), "* Line %zu, Column %zu", &line, &column) == 2) {
    const std::size_t start = errors.find('\n');
    message = start == std::string::npos ? errors : errors.substr(start + 1);
    message = message.substr(0, message.find('\n'));
    message.erase(0, message.find_first_not_of(' '));
  }
  const std::size_t at = scan.offset(line, column);
  diagnostics.error(scan.position(at, file), "json-syntax", scan.explain(message, at));
}

}  // namespace

bool Value::boolean() const {
  assert(isBoolean());
  return boolean_;
}

double Value::number() const {
  assert(isNumber());
  return number_;
}

const std::string& Value::string() const {
  assert(isString());
  return string_;
}

const Value::Array& Value::array() const {
  assert(isArray());
  return array_;
}

const Value::Object& Value::object() const {
  assert(isObject());
  return object_;
}

const Value* Value::find(std::string_view key) const {
  for (const auto& [name, value] : object_) {
    if (name == key) return &value;
  }
  return nullptr;
}

Value& Value::set(std::string key, Value value) {
  assert(isObject() || isNull());
  kind_ = Kind::object;
  for (auto& [name, member] : object_) {
    if (name == key) {
      member = std::move(value);
      return member;
    }
  }
  return object_.emplace_back(std::move(key), std::move(value)).second;
}

void Value::push(Value value) {
  assert(isArray() || isNull());
  kind_ = Kind::array;
  array_.push_back(std::move(value));
}

const SourcePosition& Value::position() const {
  static const SourcePosition nowhere;
  return position_ ? *position_ : nowhere;
}

const SourcePosition& Value::keyPosition() const {
  return keyPosition_ ? *keyPosition_ : position();
}

void Value::setPosition(SourcePosition position) {
  position_ = std::make_shared<const SourcePosition>(std::move(position));
}

void Value::setKeyPosition(SourcePosition position) {
  keyPosition_ = std::make_shared<const SourcePosition>(std::move(position));
}

Value parseJson(const std::string& text, const std::string& fileName, Diagnostics& diagnostics) {
  std::string_view body = text;
  if (body.starts_with("\xEF\xBB\xBF")) body.remove_prefix(3);  // a byte order mark is harmless
  const JsonText scan(body);
  if (scan.problem()) {
    diagnostics.error(scan.position(scan.problem()->offset, fileName), "json-syntax", scan.problem()->message);
    return {};
  }
  Diagnostics found;
  Json::Value root;
  try {
    Json::String errors;
    const std::unique_ptr<Json::CharReader> reader(readerSettings().newCharReader());
    const std::string& bare = scan.withoutComments();
    if (!reader->parse(bare.data(), bare.data() + bare.size(), &root, &errors)) {
      reportSyntaxError(errors, scan, fileName, found);
    }
  } catch (const Json::Exception& exception) {  // JsonCpp throws where its own limits are met
    found.error({fileName, 0, 0}, "json-syntax", fmt::format("this JSON cannot be read: {}", exception.what()));
  }
  Value value;
  if (!found.hasErrors()) value = Converter(scan, fileName, found).convert(root);
  diagnostics.append(found);
  return found.hasErrors() ? Value() : value;
}

}  // namespace goniolux::core
