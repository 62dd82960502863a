#include "app/gui/document/json_pointer.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace goniolux::gui {
namespace {

using core::Value;

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

const Value* childOf(const Value& value, const std::string& step) {
  if (value.isObject()) return value.find(step);
  if (!value.isArray()) return nullptr;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
  if (error != std::errc() || end != step.data() + step.size() || index >= value.array().size()) return nullptr;
  return &value.array()[index];
}

bool isAtOrBefore(const core::SourcePosition& position, int line, int column) {
  return position.line > 0 && std::pair(position.line, position.column) <= std::pair(line, column);
}

}  // namespace

std::vector<std::string> stepsOf(const std::string& pointer) {
  std::vector<std::string> steps;
  for (std::size_t begin = 0; begin < pointer.size();) {
    const std::size_t end = std::min(pointer.find('/', begin + 1), pointer.size());
    std::string step = pointer.substr(begin + 1, end - begin - 1);
    replaceAll(step, "~1", "/");
    replaceAll(step, "~0", "~");
    steps.push_back(std::move(step));
    begin = end;
  }
  return steps;
}

std::string under(const std::string& pointer, const std::string& key) {
  std::string step = key;
  replaceAll(step, "~", "~0");
  replaceAll(step, "/", "~1");
  return pointer + "/" + step;
}

std::string under(const std::string& pointer, std::size_t index) {
  return pointer + "/" + std::to_string(index);
}

std::string parentOf(const std::string& pointer) {
  return pointer.substr(0, std::min(pointer.rfind('/'), pointer.size()));
}

std::string lastStep(const std::string& pointer) {
  const std::vector<std::string> steps = stepsOf(pointer);
  return steps.empty() ? std::string() : steps.back();
}

const Value* valueAt(const Value& root, const std::string& pointer) {
  const Value* value = &root;
  for (const std::string& step : stepsOf(pointer)) {
    value = childOf(*value, step);
    if (value == nullptr) return nullptr;
  }
  return value;
}

std::string pointerAt(const Value& root, int line, int column) {
  std::string pointer;
  const Value* value = &root;
  while (true) {
    const Value* inner = nullptr;
    std::string step;
    if (value->isObject()) {
      for (const auto& [key, member] : value->object())
        if (isAtOrBefore(member.keyPosition(), line, column)) inner = &member, step = key;
    } else if (value->isArray()) {
      for (const Value& entry : value->array())
        if (isAtOrBefore(entry.position(), line, column)) inner = &entry;
      if (inner != nullptr) step = std::to_string(inner - value->array().data());
    }
    if (inner == nullptr) return pointer;
    value = inner;
    pointer = under(pointer, step);
  }
}

}  // namespace goniolux::gui
