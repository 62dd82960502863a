// Language: the words of the interface.
#pragma once

#include <QString>

namespace goniolux::gui {

/// "en", "de", or "system": that of the person's session. English where there is no translation.
void installLanguage(const QString& language);

}  // namespace goniolux::gui
