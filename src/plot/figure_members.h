// Members of a figure's document, or an InputError at their place.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"

namespace goniolux::plot {

[[noreturn]] void badFigure(const core::Value& where, const std::string& what);
const core::Value& figureMember(const core::Value& object, const char* key, core::Value::Kind kind);
std::string figureText(const core::Value& object, const char* key);
std::vector<std::string> figureTexts(const core::Value& object, const char* key);
/// A list of finite numbers.
std::vector<double> figureNumbers(const core::Value& object, const char* key);

/// The head that every figure has.
core::Value figureHead(const char* kind, const std::string& title, const std::string& subtitle,
                       const std::vector<std::string>& facts, const std::string& footer);

}  // namespace goniolux::plot
