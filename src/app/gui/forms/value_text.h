// ValueText: values of the document as one types them in a field, and back, checked against the format's tables.
#pragma once

#include <QString>
#include <optional>

#include "core/document.h"
#include "project/format.h"

namespace goniolux::gui {

/// The value as it stands in a field: numbers and texts plain, everything else as JSON on one line.
QString textOf(const core::Value& value, project::Form form);

struct Typed {
  std::optional<core::Value> value;  ///< nothing: left out (an empty field)
  QString complaint;                 ///< not empty: the text is no such value
};
/// What was typed into the field of a key.
Typed valueOf(const QString& text, const project::Key& key);

/// How many numbers a key's field has: 3 for points and directions, 2 for counts, else 1.
int partsOf(project::Form form);

}  // namespace goniolux::gui
