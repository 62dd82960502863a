// Icons: small line drawings in the colours of the theme; drawn, so that they are sharp on every screen.
#pragma once

#include <QIcon>
#include <QString>

namespace goniolux::gui {

/// "open", "save", "run", …; an empty icon for a name that has no drawing. Follows the theme that is shown when it is
/// made.
QIcon icon(const QString& name);
/// The program's own.
QIcon programIcon();

}  // namespace goniolux::gui
