// Material preview: a ball of a finish on the floor of a small room, rendered by the engine as any view is.
#pragma once

#include <memory>
#include <string>

#include "app/gui/jobs/rendering.h"
#include "core/progress.h"

namespace goniolux::gui {

/// The project of the preview: the finish `material` of the project in `source`, lit by a lamp with the spectrum
/// `light` ("CIE D65").
std::string previewProject(const Source& source, const std::string& material, const std::string& light);

/// Renders it, within some seconds; what is wrong with the finish is the picture's failure. Runs on a drawing thread.
std::shared_ptr<const ShownImage> materialPreview(const Source& source, const std::string& material,
                                                  const std::string& light, core::ProgressSink& progress);

}  // namespace goniolux::gui
