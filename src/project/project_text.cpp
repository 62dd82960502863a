#include "project/project_text.h"

#include <fmt/format.h>

#include <utility>

namespace goniolux::project {

using core::Value;

namespace {

// The entry's JSON, its lines moved in by four blanks.
std::string indented(const Value& value) {
  std::string json = core::toJson(value);
  while (!json.empty() && json.back() == '\n') json.pop_back();
  std::string out;
  for (const char c : json) {
    out += c;
    if (c == '\n') out += "    ";
  }
  return out;
}

std::string quoted(const std::string& word) {
  std::string json = core::toJson(Value(word));
  while (!json.empty() && json.back() == '\n') json.pop_back();
  return json;
}

}  // namespace

ProjectText::ProjectText(std::string text, std::string fileName) : text_(std::move(text)), file_(std::move(fileName)) {
  parse();
}

void ProjectText::parse() {
  core::Diagnostics diagnostics;
  root_ = core::parseJson(text_, file_, diagnostics);
  if (diagnostics.hasErrors()) throw core::InputError(diagnostics);
}

std::size_t ProjectText::offsetOf(const Value& value) const {
  return offsetOf(value.position());
}

std::size_t ProjectText::offsetOf(const core::SourcePosition& position) const {
  std::size_t begin = 0;
  for (int line = 1; line < position.line; ++line) begin = text_.find('\n', begin) + 1;
  return begin + static_cast<std::size_t>(position.column) - 1;
}

std::size_t ProjectText::endOfValue(std::size_t begin) const {
  const char c = text_[begin];
  return c == '{' || c == '[' || c == '"' ? endOf(begin) : text_.find_first_of(",]} \t\r\n/", begin);
}

std::size_t ProjectText::skipBlanks(std::size_t at) const {
  while (at < text_.size()) {
    if (text_.compare(at, 2, "//") == 0) {
      at = std::min(text_.find('\n', at), text_.size());
    } else if (text_.compare(at, 2, "/*") == 0) {
      at = text_.find("*/", at + 2) + 2;
    } else if (std::string_view(" \t\r\n").find(text_[at]) != std::string_view::npos) {
      ++at;
    } else {
      break;
    }
  }
  return at;
}

std::size_t ProjectText::endOf(std::size_t begin) const {
  int depth = 0;
  for (std::size_t i = begin; i < text_.size(); ++i) {
    const char c = text_[i];
    if (c == '/' && text_[i + 1] == '/') {
      i = std::min(text_.find('\n', i), text_.size() - 1);
    } else if (c == '/' && text_[i + 1] == '*') {
      i = text_.find("*/", i + 2) + 1;
    } else if (c == '"') {
      for (++i; text_[i] != '"'; ++i)
        if (text_[i] == '\\') ++i;
      if (depth == 0) return i + 1;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      if (--depth == 0) return i + 1;
    }
  }
  return text_.size();
}

void ProjectText::insertBeforeEnd(const Value& container, bool isEmpty, const std::string& entry) {
  std::size_t at = endOf(offsetOf(container)) - 1;
  // After the last value, not after the blanks and comments that may follow: JSON allows no comma before the end.
  if (!isEmpty) {
    const Value& last = container.isArray() ? container.array().back() : container.object().back().second;
    at = endOfValue(offsetOf(last));
  }
  text_.insert(at, (isEmpty ? "\n    " : ",\n    ") + entry + (isEmpty ? "\n  " : ""));
  parse();
}

void ProjectText::appendTo(const std::string& key, const Value& entry) {
  const Value* list = root_.find(key);
  if (!list || !list->isArray())
    throw core::InputError(list ? list->position() : root_.position(), "wrong-type",
                           fmt::format("the project has no list \"{0}\"; add \"{0}\": []", key));
  insertBeforeEnd(*list, list->array().empty(), indented(entry));
}

void ProjectText::addMember(const std::string& key, const std::string& name, const Value& value) {
  const std::string member = quoted(name) + ": " + indented(value);
  const Value* object = root_.find(key);
  if (!object) return insertBeforeEnd(root_, root_.object().empty(), quoted(key) + ": { " + member + " }");
  if (!object->isObject())
    throw core::InputError(object->position(), "wrong-type", fmt::format("\"{}\" must be an object", key));
  insertBeforeEnd(*object, object->object().empty(), member);
}

void ProjectText::replace(const Value& old, const Value& value) {
  const std::size_t begin = offsetOf(old);
  std::string json = indented(value);
  text_.replace(begin, endOfValue(begin) - begin, json);
  parse();
}

void ProjectText::append(const Value& list, const Value& entry) {
  insertBeforeEnd(list, list.array().empty(), indented(entry));
}

void ProjectText::add(const Value& object, const std::string& key, const Value& value) {
  insertBeforeEnd(object, object.object().empty(), quoted(key) + ": " + indented(value));
}

void ProjectText::remove(const Value& container, std::size_t index) {
  const bool isList = container.isArray();
  const std::size_t count = isList ? container.array().size() : container.object().size();
  const auto valueAt = [&](std::size_t i) -> const Value& {
    return isList ? container.array()[i] : container.object()[i].second;
  };
  const Value& gone = valueAt(index);
  std::size_t begin = isList ? offsetOf(gone) : offsetOf(gone.keyPosition());
  std::size_t end = endOfValue(offsetOf(gone));
  if (index + 1 < count) {
    end = skipBlanks(end);  // to the comma, which goes too, and the blanks after it
    if (end < text_.size() && text_[end] == ',') end = text_.find_first_not_of(" \t\r\n", end + 1);
  } else if (index > 0) {
    // The last one: the comma before it goes; comments between stay.
    const std::size_t comma = skipBlanks(endOfValue(offsetOf(valueAt(index - 1))));
    text_.erase(comma, 1);
    --begin;
    --end;
    while (begin > comma && std::string_view(" \t\r\n").find(text_[begin - 1]) != std::string_view::npos) --begin;
  }
  text_.erase(begin, end - begin);
  parse();
}

}  // namespace goniolux::project
