// Document: a JSON value that knows where it stands in its file, and a writer. The JSON library is used in document.cpp
// only. Reading allows // and /* */ comments, refuses repeated keys and trailing commas (advice: positions are what
// errors need).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnostics.h"

namespace goniolux::core {

/// A JSON value. Objects keep the order of their members.
class Value {
 public:
  enum class Kind { null, boolean, number, string, array, object };
  using Array = std::vector<Value>;
  using Object = std::vector<std::pair<std::string, Value>>;

  Value() = default;
  Value(bool value) : kind_(Kind::boolean), boolean_(value) {}                  // NOLINT: values convert on purpose
  Value(double value) : kind_(Kind::number), number_(value) {}                  // NOLINT
  Value(int value) : Value(static_cast<double>(value)) {}                       // NOLINT
  Value(std::int64_t value) : Value(static_cast<double>(value)) {}              // NOLINT
  Value(std::uint64_t value) : Value(static_cast<double>(value)) {}             // NOLINT
  Value(std::string value) : kind_(Kind::string), string_(std::move(value)) {}  // NOLINT
  Value(std::string_view value) : Value(std::string(value)) {}                  // NOLINT
  Value(const char* value) : Value(std::string(value)) {}                       // NOLINT
  Value(Array values) : kind_(Kind::array), array_(std::move(values)) {}        // NOLINT
  Value(Object members) : kind_(Kind::object), object_(std::move(members)) {}   // NOLINT
  template <typename T>
  static Value arrayOf(const std::vector<T>& values) {
    Array array;
    array.reserve(values.size());
    for (const T& value : values) array.emplace_back(value);
    return array;
  }

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] bool isNull() const { return kind_ == Kind::null; }
  [[nodiscard]] bool isNumber() const { return kind_ == Kind::number; }
  [[nodiscard]] bool isString() const { return kind_ == Kind::string; }
  [[nodiscard]] bool isBoolean() const { return kind_ == Kind::boolean; }
  [[nodiscard]] bool isArray() const { return kind_ == Kind::array; }
  [[nodiscard]] bool isObject() const { return kind_ == Kind::object; }

  /// The content; asserts that the kind is right (check first: input is checked where it is read).
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] const std::string& string() const;
  [[nodiscard]] const Array& array() const;
  [[nodiscard]] const Object& object() const;

  /// The member named `key`, or nullptr (also when this is no object).
  [[nodiscard]] const Value* find(std::string_view key) const;
  /// Sets or replaces a member; a null value becomes an object first.
  Value& set(std::string key, Value value);
  /// Appends to an array; a null value becomes an array first.
  void push(Value value);

  /// Where the value begins; for an object member, keyPosition is where its key begins.
  [[nodiscard]] const SourcePosition& position() const;
  [[nodiscard]] const SourcePosition& keyPosition() const;
  void setPosition(SourcePosition position);
  void setKeyPosition(SourcePosition position);

 private:
  Kind kind_ = Kind::null;
  bool boolean_ = false;
  double number_ = 0;
  std::string string_;
  Array array_;
  Object object_;
  std::shared_ptr<const SourcePosition> position_, keyPosition_;  // null for values that were made, not read
};

/// Parses JSON text. On bad syntax `diagnostics` gets errors with line and column and a null value is returned.
Value parseJson(const std::string& text, const std::string& fileName, Diagnostics& diagnostics);

/// JSON text of the value, ending in a newline; numbers are written with the fewest digits that read back the same, NaN
/// and infinities as null. Arrays of scalars stay on one line (broken at 120 columns).
std::string toJson(const Value& value);

/// Whole file as bytes; an InputError names the file if it cannot be read.
std::string readFile(const std::string& path);
/// What a power cut may take: nothing, or a file that can be made again from others.
enum class Durability { toTheDisk, whenConvenient };
/// Writes beside the target and renames: an earlier file stays whole until the new one is. RunError when the disk says
/// no.
void writeFile(const std::string& path, std::string_view bytes, Durability durability = Durability::toTheDisk);

}  // namespace goniolux::core
