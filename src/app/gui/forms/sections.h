// Sections: which part of the project format describes a place of the document. Forms are made from the same tables as
// the reader, so that they offer every key and no other.
#pragma once

#include <QString>
#include <memory>
#include <string>

#include "core/document.h"
#include "project/format.h"

namespace goniolux::gui {

/// The section of the format that the object at `pointer` follows; null where there is none (a list, a number) or where
/// what decides it ("shape", "model") is unknown.
std::shared_ptr<const project::Section> sectionAt(const core::Value& root, const std::string& pointer);

/// "maintenance factor" of "maintenance_factor".
std::string labelOf(const std::string& key);
/// The same in the language of the interface (context "format" of the translations).
QString translatedLabelOf(const std::string& key);
/// The unit that stands behind a field: the key's own, the project's for lengths, "" for plain numbers.
std::string unitOf(const project::Key& key, const std::string& projectUnits);

/// What a key's value may be in words, for the field's tooltip.
std::string explanationOf(const project::Key& key);

}  // namespace goniolux::gui
