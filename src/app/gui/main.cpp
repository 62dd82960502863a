// goniolux-studio: the interface. `goniolux-studio [PROJECT]`
#include <QVTKOpenGLNativeWidget.h>
#include <vtkObject.h>
#include <QApplication>
#include <QSettings>
#include <QSurfaceFormat>

#include "app/gui/window/main_window.h"
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
  goniolux::gui::applyTheme(QSettings().value("theme", "light").toString());
  goniolux::gui::MainWindow window;
  window.show();
  window.offerRecovery();
  const QStringList given = QApplication::arguments();
  if (given.size() > 1) window.openProject(given.at(1));
  return QApplication::exec();
}
