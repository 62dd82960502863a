// Short texts drawn as pixels: digits, signs, "cd/m2".
#pragma once

#include <functional>
#include <string>

namespace goniolux::display {

inline constexpr int glyphWidth = 6, glyphHeight = 8;  ///< with the space about a glyph, times `size`

/// Calls `dot(x, y)` for every pixel of the text whose upper left corner is (x, y); `size` pixels make a dot. Letters
/// without a glyph are spaces.
void drawText(const std::string& text, int x, int y, int size, const std::function<void(int, int)>& dot);

}  // namespace goniolux::display
