// JSON pointers: how a place in the project's document is named: "/luminaires/0/position" (RFC 6901).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/document.h"

namespace goniolux::gui {

/// The steps of a pointer, unescaped; "" has none.
std::vector<std::string> stepsOf(const std::string& pointer);
/// The pointer to a member or entry of what `pointer` names.
std::string under(const std::string& pointer, const std::string& key);
std::string under(const std::string& pointer, std::size_t index);
/// What a pointer is without its last step, and that step.
std::string parentOf(const std::string& pointer);
std::string lastStep(const std::string& pointer);

/// The value that the pointer names; nullptr where there is none.
const core::Value* valueAt(const core::Value& root, const std::string& pointer);
/// The innermost value that begins at or before a line and column: what a message at that place is about.
std::string pointerAt(const core::Value& root, int line, int column);

}  // namespace goniolux::gui
