// goniolux-studio: the interface. `goniolux-studio [PROJECT]`; `goniolux-studio --time-start` prints how long the
// window took to appear, and ends.
#include <QVTKOpenGLNativeWidget.h>
#include <vtkObject.h>
#include <QApplication>
#include <QSettings>
#include <QSurfaceFormat>

#include "app/gui/window/language.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/start_time.h"
#include "app/gui/window/theme.h"

int main(int count, char** arguments) {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  vtkObject::GlobalWarningDisplayOff();
  QApplication application(count, arguments);
  QApplication::setOrganizationName("Goniolux");
  QApplication::setApplicationName("goniolux-studio");
  QApplication::setApplicationDisplayName("Goniolux Studio");
  goniolux::gui::installLanguage(QSettings().value("language", "system").toString());
  goniolux::gui::applyTheme(QSettings().value("theme", "light").toString());
  goniolux::gui::MainWindow window;
  window.show();
  window.offerRecovery();
  QStringList given = QApplication::arguments().mid(1);
  if (given.removeAll("--time-start") > 0) goniolux::gui::reportStartAndQuit(window);
  if (!given.isEmpty()) window.openProject(given.first());
  return QApplication::exec();
}
