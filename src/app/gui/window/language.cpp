#include "app/gui/window/language.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace goniolux::gui {

void installLanguage(const QString& language) {
  const QString wanted = language == "system" ? QLocale::system().name().left(2) : language;
  if (wanted == "en") return;
  auto* own = new QTranslator(qApp);
  if (!own->load(":/translations/" + wanted + ".qm")) return;
  QApplication::installTranslator(own);
  // Qt's own words: buttons of dialogs.
  auto* buttons = new QTranslator(qApp);
  if (buttons->load("qtbase_" + wanted, QLibraryInfo::location(QLibraryInfo::TranslationsPath)))
    QApplication::installTranslator(buttons);
}

}  // namespace goniolux::gui
