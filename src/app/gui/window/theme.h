// Theme: the colours of the interface, light or dark.
#pragma once

#include <QColor>
#include <QString>

class QApplication;

namespace goniolux::gui {

struct Theme {
  bool isDark = false;
  QColor window, base, panel, border, text, faintText, accent, pass, fail, undecided;
  QColor viewTop, viewBottom;  ///< background of the 3-D view
  QColor edge;                 ///< lines of objects
  QColor luminaire, aim, selection;
};

const Theme& lightTheme();
const Theme& darkTheme();
/// The one that is shown.
const Theme& theme();
/// "light", "dark" or "system".
void applyTheme(const QString& name);

}  // namespace goniolux::gui
