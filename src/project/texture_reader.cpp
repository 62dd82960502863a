#include "project/texture_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/closest_name.h"
#include "display/picture_file.h"
#include "project/section_reader.h"
#include "reflection/bsdf.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "texture/colour_texture.h"

namespace goniolux::project {
namespace {

using material::Material;
using spectrum::SpectralDistribution;
using texture::Pattern;
using texture::Projection;

constexpr double mostTexturePixels = 4e7;

double decoded(double code) {  // IEC 61966-2-1
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

SpectralDistribution meanOf(const std::vector<const SpectralDistribution*>& curves, const std::vector<double>& shares) {
  const bool flat = std::all_of(curves.begin(), curves.end(), [](const auto* curve) { return curve->isFlat(); });
  const auto at = [&](double nm) {
    double sum = 0;
    for (std::size_t i = 0; i < curves.size(); ++i) sum += shares[i] * curves[i]->continuum(nm);
    return sum;
  };
  if (flat) return SpectralDistribution::flat(at(555));
  std::vector<SpectralDistribution::Sample> samples;
  for (int nm = 360; nm <= 830; nm += 5) samples.push_back({static_cast<double>(nm), at(nm)});
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
}

class TextureReader {
 public:
  TextureReader(scene::Environment& environment, Reading& reading)
      : environment_(environment), reading_(reading), plain_(environment.materials) {}

  void read(Material& material, const core::Value& value) {
    if (const core::Value* bump = value.find("bump")) readRelief(material, *bump);
    if (const core::Value* given = value.find("texture")) readTexture(material, *given);
  }

 private:
  void readRelief(Material& material, const core::Value& value) {
    SectionReader section(value, bumpSection(), reading_);
    if (!section.isObject()) return;
    const auto pattern = patternOf(section, "bump");
    const auto projection = projectionOf(section);
    const auto depth = section.length("depth");
    if (!pattern || !projection || !depth || section.failed()) return;
    texture::Relief relief{*projection, pattern, *depth};
    material.relief = static_cast<std::uint32_t>(environment_.reliefs.size());
    environment_.reliefs.push_back(std::make_shared<const texture::Relief>(std::move(relief)));
  }

  void readTexture(Material& material, const core::Value& value) {
    SectionReader section(value, textureSection(), reading_);
    if (!section.isObject()) return;
    const auto projection = projectionOf(section);
    if (section.failed() || !projection) return;
    if (section.has("with") || !section.has("image")) {
      mixTwo(material, section, *projection);
    } else {
      takeColours(material, section, *projection);
    }
  }

  // Two finishes of the project by a pattern, or by how light a picture is.
  void mixTwo(Material& material, SectionReader& section, const Projection& projection) {
    if (section.has("calibrated"))
      return section.refuse("calibrated", "texture-form", "\"calibrated\" goes with the colours of an \"image\"");
    const auto pattern = patternOf(section, "texture");
    const auto name = section.text("with");
    if (!name && !section.failed())
      return section.refuse("with", "missing-key",
                            "a pattern needs \"with\": the name of the material that shows where the pattern is 1");
    if (!pattern || !name) return;
    const auto other = std::find_if(plain_.begin(), plain_.end(), [&](const Material& m) { return m.name == *name; });
    if (other == plain_.end()) {
      std::vector<std::string> names;
      for (const Material& known : plain_) names.push_back(known.name);
      return section.refuse("with", "unknown-material",
                            fmt::format("the material \"{}\" is not defined{}", *name, core::suggestion(*name, names)));
    }
    if (other->name == material.name)
      return section.refuse("with", "texture-form", "\"with\" names the material itself; name another one");
    compose(material, {plainOf(material), *other}, std::make_shared<texture::PatternTexture>(projection, pattern),
            section);
  }

  // A picture in colour: components are this finish with other diffuse reflectances.
  void takeColours(Material& material, SectionReader& section, const Projection& projection) {
    if (section.has("pattern"))
      return section.refuse("pattern", "texture-form",
                            "a texture has a \"pattern\" or an \"image\"; a picture that mixes two materials has "
                            "\"with\"");
    const auto diffuse = material.spectra.find("diffuse");
    if (diffuse == material.spectra.end())
      return section.refuse(
          "image", "texture-form",
          fmt::format("the colours of a picture are those of a diffuse reflectance; \"{}\" has none", material.model));
    const auto picture = pictureOf(section);
    if (!picture) return;
    double scale = 1;
    const double mean = texture::PicturePattern(picture).mean();
    if (!section.boolean("calibrated").value_or(false)) {
      if (!(mean > 0))
        return section.refuse("image", "texture-form", "the picture is black; it has no colours to take");
      scale = spectrum::tristimulus(diffuse->second, *spectrum::illuminant("CIE D65")).Y / mean;
    }
    const auto colours = std::make_shared<texture::ColourTexture>(projection, picture, scale);
    std::vector<Material> components;
    for (const SpectralDistribution& reflectance : colours->reflectances()) {
      components.push_back(plainOf(material));
      components.back().spectra["diffuse"] = reflectance;
    }
    if (colours->shareCutOff() > 0.001) {
      reading_.warning(*section.find("image"), "texture-cut-off",
                       fmt::format("{:.2g} % of the picture's pixels would reflect more than all light when its mean "
                                   "is the material's \"diffuse\"; they are cut off at 1, so that the mean is lower: "
                                   "take a picture with less contrast, or a lower \"diffuse\"",
                                   100 * colours->shareCutOff()));
    }
    compose(material, std::move(components), colours, section);
  }

  void compose(Material& material, std::vector<Material> components, std::shared_ptr<const texture::Texture> made,
               SectionReader& section) {
    for (const Material& component : components) {
      // Which directions a finish knows does not depend on the wavelengths.
      const reflection::ReflectionModel* model = reflection::findReflectionModel(component.model);
      const bool unfinished =
          model == nullptr ||
          std::any_of(model->parameters.begin(), model->parameters.end(), [&](const core::Parameter& parameter) {
            return parameter.required && !component.spectra.contains(parameter.key);
          });
      if (model != nullptr && unfinished) return;  // has its own error
      const auto bsdf = model == nullptr ? nullptr : model->make(component, spectrum::flatQuadrature({}));
      if (bsdf == nullptr || bsdf->lobes().single || bsdf->medium() != nullptr) {
        section.refuse(
            "with", "texture-form",
            fmt::format("\"{}\" ({}) cannot be part of a texture: only finishes that scatter light can, such "
                        "as lambert, oren-nayar, ward or a rough conductor",
                        component.name, component.model));
        return;
      }
    }
    material.shares = made->meanShares();
    for (auto& [key, curve] : material.spectra) {
      std::vector<const SpectralDistribution*> curves;
      for (const Material& component : components) {
        const auto found = component.spectra.find(key);
        if (found != component.spectra.end()) curves.push_back(&found->second);
      }
      if (curves.size() == components.size()) curve = meanOf(curves, material.shares);
    }
    material.components = std::move(components);
    material.texture = static_cast<std::uint32_t>(environment_.textures.size());
    environment_.textures.push_back(std::move(made));
  }

  // A component has no texture and does not emit: that is the whole finish's.
  static Material plainOf(const Material& material) {
    Material plain = material;
    plain.emission.reset();
    return plain;
  }

  std::shared_ptr<const Pattern> patternOf(SectionReader& section, const char* kind) {
    if (section.has("image") == section.has("pattern")) {
      section.refuse("pattern", "texture-form", fmt::format("a {} has either a \"pattern\" or an \"image\"", kind));
      return nullptr;
    }
    if (section.has("image")) {
      const auto picture = pictureOf(section);
      return picture ? std::make_shared<texture::PicturePattern>(picture) : nullptr;
    }
    const auto name = section.choice("pattern");
    const texture::PatternType* type = name ? texture::findPatternType(*name) : nullptr;
    if (type == nullptr) return nullptr;
    core::Arguments arguments;
    for (const texture::PatternType& each : texture::patternTypes())
      for (const core::Parameter& parameter : each.parameters) {
        if (!section.has(parameter.key)) continue;
        const bool own = std::any_of(type->parameters.begin(), type->parameters.end(),
                                     [&](const core::Parameter& p) { return p.key == parameter.key; });
        if (!own) {
          section.refuse(parameter.key, "texture-form",
                         fmt::format("\"{}\" belongs to \"pattern\": \"{}\"", parameter.key, each.name));
        } else if (const auto number = section.number(parameter.key)) {
          arguments[parameter.key] = *number;
        }
      }
    return section.failed() ? nullptr : type->make(arguments);
  }

  std::shared_ptr<const texture::Picture> pictureOf(SectionReader& section) {
    const core::Value& name = *section.find("image");
    const auto path = reading_.file(name, Library::materials);
    if (!path) return nullptr;
    auto& known = pictures_[*path];
    if (known) return known;
    try {
      display::CodeImage image = display::readPicture(*path, mostTexturePixels);
      auto picture = std::make_shared<texture::Picture>();
      picture->width = image.width;
      picture->height = image.height;
      picture->codes = std::move(image.rgb);
      const auto codes = static_cast<std::size_t>(1) << image.bits;
      for (std::size_t code = 0; code < codes; ++code)
        picture->linear.push_back(
            static_cast<float>(decoded(static_cast<double>(code) / static_cast<double>(codes - 1))));
      known = std::move(picture);
    } catch (const core::InputError& error) {
      reading_.adopt(error);
    }
    return known;
  }

  std::optional<Projection> projectionOf(SectionReader& section) {
    Projection projection;
    const bool byCoordinates = section.choice("mapping").value_or("box") == "uv";
    const auto pair = [&](const char* key, core::Vec2& into) {
      const core::Value* value = section.find(key);
      if (value == nullptr) return true;
      const Key single{.name = key};
      const bool isPair = value->isArray() && value->array().size() == 2;
      const auto x = isPair ? readNumber(value->array()[0], single, reading_) : std::nullopt;
      const auto y = isPair ? readNumber(value->array()[1], single, reading_) : std::nullopt;
      if (x && y) {
        into = {*x, *y};
        return true;
      }
      section.refuse(key, "wrong-type", fmt::format("\"{}\" must be two numbers", key));
      return false;
    };
    if (byCoordinates) {
      projection.mapping = Projection::Mapping::uv;
      if (section.has("width") || section.has("height"))
        section.refuse(section.has("width") ? "width" : "height", "texture-form",
                       "with \"mapping\": \"uv\" the pattern's size is given by \"repeats\": [along u, along v]");
      core::Vec2 repeats(1);
      if (!pair("repeats", repeats)) return std::nullopt;
      if (!(repeats.x > 0 && repeats.y > 0)) {
        section.refuse("repeats", "out-of-range", "\"repeats\" must be above 0");
        return std::nullopt;
      }
      projection.size = 1.0 / repeats;
    } else {
      if (section.has("repeats"))
        section.refuse("repeats", "texture-form", "\"repeats\" goes with \"mapping\": \"uv\"; give a \"width\"");
      const auto width = section.length("width");
      if (!width) {
        if (!section.failed())
          section.refuse("width", "missing-key", "a texture needs \"width\": how long one repeat of it is");
        return std::nullopt;
      }
      double height = *width;
      if (const core::Value* image = section.find("image"); image != nullptr && !section.has("height")) {
        if (const auto picture = pictureOf(section)) height *= static_cast<double>(picture->height) / picture->width;
      }
      projection.size = {*width, section.length("height").value_or(height)};
    }
    if (!pair("shift", projection.shift)) return std::nullopt;
    projection.turn = section.number("turn").value_or(0) * core::degree;
    return section.failed() ? std::nullopt : std::optional(projection);
  }

  scene::Environment& environment_;
  Reading& reading_;
  const std::vector<Material> plain_;  // before any has a texture: textures do not hold textures
  std::map<std::string, std::shared_ptr<const texture::Picture>> pictures_;
};

}  // namespace

void readTextures(const core::Value& section, scene::Environment& environment, Reading& reading) {
  if (!section.isObject()) return;
  TextureReader reader(environment, reading);
  std::size_t i = 0;
  for (const auto& [name, value] : section.object()) reader.read(environment.materials[i++], value);
}

}  // namespace goniolux::project
