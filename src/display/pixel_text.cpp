#include "display/pixel_text.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace goniolux::display {
namespace {

struct Glyph {
  char letter;
  std::array<std::string_view, 7> rows;
};

constexpr std::array<Glyph, 19> glyphs{{
    {'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    {'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'2', {" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"}},
    {'3', {"#####", "   # ", "  #  ", "   # ", "    #", "#   #", " ### "}},
    {'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    {'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    {'6', {"  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### "}},
    {'7', {"#####", "    #", "   # ", "  #  ", " #   ", " #   ", " #   "}},
    {'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    {'9', {" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "}},
    {'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}},
    {'-', {"     ", "     ", "     ", "#####", "     ", "     ", "     "}},
    {'+', {"     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "}},
    {'/', {"    #", "    #", "   # ", "  #  ", " #   ", "#    ", "#    "}},
    {'c', {"     ", "     ", " ### ", "#    ", "#    ", "#   #", " ### "}},
    {'d', {"    #", "    #", " ## #", "#  ##", "#   #", "#   #", " ####"}},
    {'m', {"     ", "     ", "## # ", "# # #", "# # #", "#   #", "#   #"}},
    {'e', {"     ", "     ", " ### ", "#   #", "#####", "#    ", " ### "}},
    {'E', {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"}},
}};

}  // namespace

void drawText(const std::string& text, int x, int y, int size, const std::function<void(int, int)>& dot) {
  int left = x;
  for (const char letter : text) {
    const auto glyph =
        std::find_if(glyphs.begin(), glyphs.end(), [&](const Glyph& each) { return each.letter == letter; });
    if (glyph != glyphs.end())
      for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 5; ++column) {
          if (glyph->rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] != '#') continue;
          for (int v = 0; v < size; ++v)
            for (int u = 0; u < size; ++u) dot(left + column * size + u, y + row * size + v);
        }
    left += glyphWidth * size;
  }
}

}  // namespace goniolux::display
