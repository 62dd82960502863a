// The sections of the format that describe textures. The procedures' own keys come from the registry of patterns.
#include <algorithm>

#include "project/format.h"
#include "texture/pattern.h"

namespace goniolux::project {
namespace {

std::vector<Key> patternKeys() {
  std::vector<std::string> names;
  for (const texture::PatternType& type : texture::patternTypes()) names.push_back(type.name);
  std::vector<Key> keys{
      {.name = "pattern", .form = Form::choice, .help = "a procedure", .choices = names},
      {.name = "image", .form = Form::file, .help = "PNG, TIFF or JPEG picture, read as sRGB, instead of a procedure"}};
  for (const texture::PatternType& type : texture::patternTypes())
    for (const core::Parameter& parameter : type.parameters)
      keys.push_back({.name = parameter.key,
                      .form = Form::number,
                      .help = "of " + type.name + ": " + parameter.help,
                      .minimum = parameter.minimum,
                      .maximum = parameter.maximum});
  const auto length = [&](const char* name, const char* help) {
    keys.push_back({.name = name, .form = Form::length, .help = help, .minimum = 0, .minimumIsAllowed = false});
  };
  keys.push_back({.name = "mapping",
                  .form = Form::choice,
                  .help =
                      "box (default): by place, along the two axes that the surface runs along; uv: by the surface's "
                      "own coordinates",
                  .choices = {"box", "uv"}});
  length("width", "of one repeat, with box");
  length("height", "of one repeat, with box; default: as wide, of pictures by their shape");
  keys.push_back({.name = "repeats", .form = Form::numbers, .help = "[along u, along v], with uv; default [1, 1]"});
  keys.push_back({.name = "shift", .form = Form::numbers, .help = "[to the right, up], in repeats"});
  keys.push_back({.name = "turn", .form = Form::number, .help = "of the pattern, anticlockwise", .unit = "°"});
  return keys;
}

}  // namespace

const Section& textureSection() {
  static const Section section = [] {
    Section made{"a texture", patternKeys()};
    made.keys.push_back(
        {.name = "with",
         .form = Form::text,
         .help = "the material where the pattern is 1 or the picture white; this one is where it is 0"});
    made.keys.push_back({.name = "calibrated",
                         .form = Form::boolean,
                         .help = "a picture's values are reflectances; default: they are scaled so that their mean is "
                                 "the luminous reflectance of \"diffuse\""});
    return made;
  }();
  return section;
}

const Section& bumpSection() {
  static const Section section = [] {
    Section made{"a bump", patternKeys()};
    made.keys.push_back({.name = "depth",
                         .form = Form::length,
                         .help = "from the pattern's 0 to its 1, which is nearer to the eye",
                         .required = true,
                         .minimum = 0,
                         .minimumIsAllowed = false});
    return made;
  }();
  return section;
}

}  // namespace goniolux::project
