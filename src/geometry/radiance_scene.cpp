#include "geometry/radiance_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "core/text.h"
#include "geometry/triangulate.h"

namespace goniolux::geometry {

using core::Vec3;

namespace {

constexpr std::size_t mostArguments = 100'000;

struct Word {
  std::string_view text;
  int line = 0;
};

// Words without comments; a command is one word that begins with '!'.
std::vector<Word> wordsOf(std::string_view text) {
  std::vector<Word> words;
  core::TextScanner lines(text);
  while (const auto line = lines.line()) {
    std::string_view rest = core::trimmed(line->text);
    if (rest.starts_with('!')) {
      words.push_back({rest, line->line});
      continue;
    }
    if (const auto comment = rest.find('#'); comment != std::string_view::npos) rest = rest.substr(0, comment);
    std::size_t at = 0;
    while ((at = rest.find_first_not_of(" \t", at)) != std::string_view::npos) {
      const std::size_t end = std::min(rest.find_first_of(" \t", at), rest.size());
      words.push_back({rest.substr(at, end - at), line->line});
      at = end;
    }
  }
  return words;
}

class Reader {
 public:
  Reader(std::string_view text, std::string file) : words_(wordsOf(text)), file_(std::move(file)) {}

  RadianceScene read() {
    while (at_ < words_.size()) primitive();
    return std::move(scene_);
  }

 private:
  [[noreturn]] void refuse(int line, const std::string& message) const {
    throw core::InputError({file_, line, 0}, "radiance", message);
  }
  void leave(int line, const std::string& what) {
    scene_.left.warning({file_, line, 0}, "not-understood", what + " is left out");
  }

  const Word& next(const char* what) {
    if (at_ >= words_.size())
      refuse(words_.back().line, fmt::format("the file ends where {} is expected; is it complete?", what));
    return words_[at_++];
  }

  std::size_t count(const char* what) {
    const Word& word = next(what);
    const auto number = core::parseNumber(word.text);
    if (!number || *number < 0 || *number != std::floor(*number) || *number > double(mostArguments))
      refuse(word.line, fmt::format("\"{}\" is no {}; a whole number is expected", word.text, what));
    return static_cast<std::size_t>(*number);
  }

  void primitive() {
    const Word modifier = next("a modifier");
    if (modifier.text.starts_with('!')) {
      leave(modifier.line, fmt::format("the command \"{}\"", modifier.text));
      return;
    }
    const Word type = next("a type");
    const Word name = next("a name");
    if (type.text == "alias") {
      const Word original = next("the aliased name");
      aliases_[std::string(name.text)] = resolved(std::string(original.text));
      return;
    }
    for (std::size_t k = count("number of texts"); k > 0; --k) next("a text");
    if (const std::size_t integers = count("number of integers"); integers > 0) {
      for (std::size_t k = integers; k > 0; --k) next("an integer");
    }
    std::vector<double> reals(count("number of reals"));
    for (double& real : reals) {
      const Word& word = next("a number");
      const auto number = core::parseNumber(word.text);
      if (!number || !std::isfinite(*number)) refuse(word.line, fmt::format("\"{}\" is no finite number", word.text));
      real = *number;
    }
    take(std::string(modifier.text), std::string(type.text), std::string(name.text), reals, type.line);
  }

  std::string resolved(const std::string& name) const {
    const auto alias = aliases_.find(name);
    return alias == aliases_.end() ? name : alias->second;
  }

  void take(const std::string& modifier, const std::string& type, const std::string& name, const std::vector<double>& r,
            int line) {
    const auto needs = [&](std::size_t least, std::size_t most) {
      if (r.size() < least || r.size() > most)
        refuse(line, fmt::format("{} \"{}\" has {} numbers; {} are expected", type, name, r.size(), least));
    };
    const auto point = [&](std::size_t first) { return Vec3(r[first], r[first + 1], r[first + 2]); };
    using Kind = RadianceRound::Kind;
    const std::string material = resolved(modifier);
    if (type == "plastic" || type == "metal" || type == "mirror") {
      needs(type == "mirror" ? 3 : 5, 5);
      scene_.materials.push_back({name, type, r[0], r[1], r[2], type == "mirror" ? 1.0 : r[3]});
    } else if (type == "polygon") {
      if (r.size() < 9 || r.size() % 3 != 0)
        refuse(line, fmt::format("polygon \"{}\" has {} numbers; three for each of three or more corners are expected",
                                 name, r.size()));
      polygon(material, name, r, line);
    } else if (type == "sphere" || type == "bubble") {
      needs(4, 4);
      scene_.rounds.push_back({Kind::sphere, point(0), Vec3(0), r[3], r[3], material});
    } else if (type == "cylinder" || type == "tube") {
      needs(7, 7);
      scene_.rounds.push_back({Kind::cylinder, point(0), point(3), r[6], r[6], material});
    } else if (type == "cone" || type == "cup") {
      needs(8, 8);
      scene_.rounds.push_back({Kind::cone, point(0), point(3), r[6], r[7], material});
    } else if (type == "ring") {
      needs(8, 8);
      scene_.rounds.push_back({Kind::ring, point(0), point(3), std::min(r[6], r[7]), std::max(r[6], r[7]), material});
    } else {
      leave(line, fmt::format("{} \"{}\"", type, name));
    }
  }

  void polygon(const std::string& material, const std::string& name, const std::vector<double>& r, int line) {
    std::vector<Vec3> ring;
    for (std::size_t k = 0; k + 2 < r.size(); k += 3) ring.emplace_back(r[k], r[k + 1], r[k + 2]);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    try {
      triangles = triangulateInSpace({ring}, fmt::format("polygon \"{}\"", name));
    } catch (const std::invalid_argument& error) {  // also holes, which Radiance joins to the outline by a seam
      leave(line, error.what());
      return;
    }
    auto part = std::find(scene_.partNames.begin(), scene_.partNames.end(), material);
    if (part == scene_.partNames.end()) part = scene_.partNames.insert(part, material);
    const auto number = static_cast<std::uint32_t>(part - scene_.partNames.begin());
    const auto first = static_cast<std::uint32_t>(scene_.mesh.vertices.size());
    scene_.mesh.vertices.insert(scene_.mesh.vertices.end(), ring.begin(), ring.end());
    for (const auto& t : triangles) {
      scene_.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      scene_.mesh.parts.push_back(number);
    }
  }

  std::vector<Word> words_;
  std::string file_;
  std::size_t at_ = 0;
  std::map<std::string, std::string> aliases_;
  RadianceScene scene_;
};

}  // namespace

RadianceScene readRadianceScene(std::string_view text, const std::string& fileName) {
  return Reader(text, fileName).read();
}

}  // namespace goniolux::geometry
