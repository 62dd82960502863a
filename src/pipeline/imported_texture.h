// A model's base-colour picture as the texture of a project's material.
#pragma once

#include <string>

#include "core/document.h"
#include "geometry/mesh_import.h"

namespace goniolux::pipeline {

struct ImportedTexture {
  std::string bytes;       ///< of the picture file
  double reflectance = 0;  ///< luminous, mean over the picture: the material's "diffuse"
  core::Value texture;     ///< the material's "texture"
  std::string left;        ///< what of it was not taken over, as a sentence's end; empty: nothing
};

/// `file`: as the project names the copy. The picture's values are taken as reflectances, times the model's factor.
/// core::InputError when it cannot be read, is of another format than PNG, TIFF and JPEG, or is black.
ImportedTexture importedTexture(const geometry::MeshPicture& picture, const std::string& file);

}  // namespace goniolux::pipeline
