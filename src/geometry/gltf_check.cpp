#include "geometry/gltf_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "core/document.h"

namespace goniolux::geometry {
namespace {

using core::Value;

constexpr double mostElements = 6e7;

class Check {
 public:
  explicit Check(std::string path) : path_(std::move(path)) {}

  void run() {
    const std::string bytes = core::readFile(path_);
    core::Diagnostics diagnostics;
    root_ = core::parseJson(bytes.starts_with("glTF") ? jsonChunk(bytes) : bytes, path_, diagnostics);
    if (diagnostics.hasErrors()) refuse(toString(diagnostics.all().front()));
    if (!root_.isObject()) refuse("it holds no glTF document");
    nodes();
    buffers();
    meshes();
    pictures();
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw std::invalid_argument(fmt::format("{}: is damaged ({}); export it again", path_, why));
  }

  static std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    return value;
  }

  std::string jsonChunk(const std::string& bytes) {
    if (bytes.size() < 20 || word(bytes, 4) != 2 || word(bytes, 8) != bytes.size() || bytes.compare(16, 4, "JSON") != 0)
      refuse("its header does not fit its length");
    const std::size_t length = word(bytes, 12);
    if (20 + length > bytes.size()) refuse("its JSON part ends beyond the file");
    const std::size_t binary = 20 + length;
    if (binary + 8 <= bytes.size()) {
      binaryLength_ = word(bytes, binary);
      if (binary + 8 + binaryLength_ > bytes.size()) refuse("its binary part ends beyond the file");
    }
    return bytes.substr(20, length);
  }

  const Value::Array& list(const Value& of, const char* key) const {
    static const Value::Array none;
    const Value* value = of.find(key);
    if (!value) return none;
    if (!value->isArray()) refuse(fmt::format("\"{}\" is no list", key));
    return value->array();
  }

  double count(const Value& of, const char* key, double standard) const {
    const Value* value = of.find(key);
    if (!value) return standard;
    if (!value->isNumber() || !(value->number() >= 0) || value->number() != std::floor(value->number()) ||
        value->number() > 1e12)
      refuse(fmt::format("\"{}\" is no count", key));
    return value->number();
  }

  // An index that is there and names an entry.
  std::size_t index(const Value& value, std::size_t size, const char* what) const {
    if (!value.isNumber() || !(value.number() >= 0) || value.number() != std::floor(value.number()) ||
        value.number() >= double(size))
      refuse(fmt::format("it names a {} that does not exist", what));
    return static_cast<std::size_t>(value.number());
  }
  void optionalIndex(const Value& of, const char* key, std::size_t size) const {
    if (const Value* value = of.find(key)) index(*value, size, key);
  }

  void nodes() {
    const auto& all = list(root_, "nodes");
    std::vector<std::size_t> parent(all.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      optionalIndex(all[i], "mesh", list(root_, "meshes").size());
      for (const Value& child : list(all[i], "children")) {
        const std::size_t k = index(child, all.size(), "node");
        if (parent[k] != all.size() || k == i) refuse(fmt::format("node {} has two parents or is its own", k));
        parent[k] = i;
      }
    }
    // With one parent each, a way up that is longer than all nodes goes round in a circle.
    std::vector<bool> ends(all.size(), false);
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::size_t at = i, steps = 0;
      while (at != all.size() && !ends[at] && steps++ <= all.size()) at = parent[at];
      if (at != all.size() && !ends[at]) refuse("its nodes go round in a circle");
      if (steps > 512) refuse("its nodes are nested too deeply");
      for (at = i; at != all.size() && !ends[at]; at = parent[at]) ends[at] = true;
    }
    for (const Value& scene : list(root_, "scenes"))
      for (const Value& node : list(scene, "nodes")) index(node, all.size(), "node");
    optionalIndex(root_, "scene", list(root_, "scenes").size());
  }

  void buffers() {
    const auto& all = list(root_, "buffers");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double length = count(all[i], "byteLength", 0);
      if (i == 0 && !all[i].find("uri") && length > double(binaryLength_) + 3)
        refuse("its binary part is shorter than it says");
    }
    for (const Value& view : list(root_, "bufferViews")) {
      const Value* buffer = view.find("buffer");
      if (!buffer) refuse("a buffer view has no buffer");
      const Value& whole = all[index(*buffer, all.size(), "buffer")];
      if (count(view, "byteOffset", 0) + count(view, "byteLength", 0) > count(whole, "byteLength", 0))
        refuse("a buffer view ends beyond its buffer");
    }
    for (const Value& accessor : list(root_, "accessors")) accessorFits(accessor);
  }

  void accessorFits(const Value& accessor) const {
    const double elements = count(accessor, "count", 0);
    if (elements < 1 || elements > mostElements) refuse("an accessor has no or too many elements");
    const Value* type = accessor.find("type");
    const std::string name = type && type->isString() ? type->string() : "";
    const double components = name == "SCALAR" ? 1
                              : name == "VEC2" ? 2
                              : name == "VEC3" ? 3
                              : name == "VEC4" ? 4
                              : name == "MAT2" ? 4
                              : name == "MAT3" ? 9
                              : name == "MAT4" ? 16
                                               : 0;
    const double component = count(accessor, "componentType", 0);
    const double size = component == 5120 || component == 5121   ? 1
                        : component == 5122 || component == 5123 ? 2
                        : component == 5125 || component == 5126 ? 4
                                                                 : 0;
    if (components == 0 || size == 0) refuse("an accessor's type is unknown");
    const auto& views = list(root_, "bufferViews");
    const Value* view = accessor.find("bufferView");
    if (!view) return;  // zeros
    const Value& held = views[index(*view, views.size(), "buffer view")];
    const double stride = std::max(count(held, "byteStride", 0), components * size);
    if (count(accessor, "byteOffset", 0) + stride * (elements - 1) + components * size > count(held, "byteLength", 0))
      refuse("an accessor ends beyond its buffer view");
  }

  void meshes() const {
    const std::size_t accessors = list(root_, "accessors").size();
    for (const Value& mesh : list(root_, "meshes")) {
      for (const Value& primitive : list(mesh, "primitives")) {
        optionalIndex(primitive, "indices", accessors);
        optionalIndex(primitive, "material", list(root_, "materials").size());
        const Value* attributes = primitive.find("attributes");
        if (!attributes || !attributes->isObject()) refuse("a primitive has no attributes");
        for (const auto& [name, value] : attributes->object()) index(value, accessors, "accessor");
      }
    }
  }

  // The importer (assimp 5.2) follows a null pointer where a media type has no "/" (found by fuzzing).
  void pictures() const {
    for (const Value& image : list(root_, "images")) {
      optionalIndex(image, "bufferView", list(root_, "bufferViews").size());
      const Value* type = image.find("mimeType");
      if (type && !(type->isString() && type->string().starts_with("image/") && type->string().size() > 6))
        refuse("the media type of a picture is not image/png or image/jpeg");
      if (!type && image.find("bufferView")) refuse("a picture within the file has no media type");
    }
    for (const Value& texture : list(root_, "textures")) optionalIndex(texture, "source", list(root_, "images").size());
  }

  std::string path_;
  Value root_;
  std::size_t binaryLength_ = 0;
};

}  // namespace

void checkGltf(const std::string& path) {
  Check(path).run();
}

}  // namespace goniolux::geometry
