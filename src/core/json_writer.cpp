// The JSON writer. Ours, because JsonCpp's prints 0.1 as 0.10000000000000001 (it always writes 17 digits, or a fixed
// smaller count that does not read back): results are read by people and compared by tools.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/document.h"

namespace goniolux::core {
namespace {

constexpr std::size_t lineWidth = 120;

bool isScalar(const Value& value) {
  return !value.isArray() && !value.isObject();
}

/// A scalar, or a point or pair of angles: what may stand with others on one line.
bool isSmall(const Value& value) {
  if (isScalar(value)) return true;
  return value.isArray() && value.array().size() <= 4 &&
         std::all_of(value.array().begin(), value.array().end(),
                     [](const Value& element) { return isScalar(element); });
}

class Writer {
 public:
  std::string text;

  void write(const Value& value, std::size_t indent) {
    switch (value.kind()) {
      case Value::Kind::null:
        text += "null";
        break;
      case Value::Kind::boolean:
        text += value.boolean() ? "true" : "false";
        break;
      case Value::Kind::number:
        writeNumber(value.number());
        break;
      case Value::Kind::string:
        writeString(value.string());
        break;
      case Value::Kind::array:
        writeArray(value.array(), indent);
        break;
      case Value::Kind::object:
        writeObject(value.object(), indent);
        break;
    }
  }

 private:
  // fmt writes the fewest digits that read back to the same double.
  void writeNumber(double number) {
    if (std::isfinite(number)) {
      fmt::format_to(std::back_inserter(text), "{}", number);
    } else {
      text += "null";
    }
  }

  void writeString(const std::string& string) {
    text += '"';
    for (const char c : string) {
      if (c == '"' || c == '\\') {
        text += '\\';
        text += c;
      } else if (c == '\n') {
        text += "\\n";
      } else if (c == '\t') {
        text += "\\t";
      } else if (static_cast<unsigned char>(c) < 0x20) {
        fmt::format_to(std::back_inserter(text), "\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
      } else {
        text += c;
      }
    }
    text += '"';
  }

  void newLine(std::size_t indent) {
    text += '\n';
    text.append(indent, ' ');
  }

  void writeArray(const Value::Array& values, std::size_t indent) {
    if (values.empty()) {
      text += "[]";
      return;
    }
    text += '[';
    if (std::all_of(values.begin(), values.end(), isSmall)) {
      writePacked(values, indent);
    } else {
      for (std::size_t i = 0; i < values.size(); ++i) {
        newLine(indent + 2);
        write(values[i], indent + 2);
        if (i + 1 < values.size()) text += ',';
      }
      newLine(indent);
    }
    text += ']';
  }

  /// Elements side by side, broken where a line would grow longer than lineWidth.
  void writePacked(const Value::Array& values, std::size_t indent) {
    std::size_t lineStart = text.rfind('\n') + 1;  // npos + 1 == 0: the first line
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t before = text.size();
      if (i > 0) text += ' ';
      write(values[i], 0);
      if (i + 1 < values.size()) text += ',';
      if (i == 0 || text.size() - lineStart <= lineWidth) continue;
      text.replace(before, 1, "\n" + std::string(indent + 2, ' '));
      lineStart = before + 1;
    }
  }

  void writeObject(const Value::Object& members, std::size_t indent) {
    if (members.empty()) {
      text += "{}";
      return;
    }
    text += '{';
    for (std::size_t i = 0; i < members.size(); ++i) {
      newLine(indent + 2);
      writeString(members[i].first);
      text += ": ";
      write(members[i].second, indent + 2);
      if (i + 1 < members.size()) text += ',';
    }
    newLine(indent);
    text += '}';
  }
};

}  // namespace

std::string toJson(const Value& value) {
  Writer writer;
  writer.write(value, 0);
  return writer.text + '\n';
}

}  // namespace goniolux::core
