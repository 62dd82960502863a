// goniolux-studio: the interface. `goniolux-studio [PROJECT]`; `goniolux-studio --time-start` prints how long the
// window took to appear, and ends.
#include <QVTKOpenGLNativeWidget.h>
#include <vtkObject.h>
#include <QApplication>
#include <QSettings>
#include <QSurfaceFormat>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "app/gui/window/language.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/start_time.h"
#include "app/gui/window/theme.h"

namespace {

constexpr const char* help =
    R"(goniolux-studio - the window of Goniolux, which calculates the light in a room

Usage: goniolux-studio [OPTIONS] [PROJECT]

PROJECT is a folder with a project.json, or such a file; without it the start page opens.

  --help         prints this
  --version      prints the version
  --time-start   prints the milliseconds from the start to the window, and ends

The same calculations without a window: goniolux --help
Exit code: 0, or 2 for a wrong option and where there is no display.
)";

/// What is asked for without a window is answered before one is tried. Nothing: a window is wanted.
int answered(int count, char** arguments) {
  constexpr int aWindowIsWanted = -1;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    if (word == "--help" || word == "-h") return std::fputs(help, stdout), EXIT_SUCCESS;
    if (word == "--version") return std::puts("goniolux-studio " GONIOLUX_VERSION), EXIT_SUCCESS;
    // Qt's own options have one dash (-platform, -style …).
    if (word.substr(0, 2) == "--" && word != "--time-start") {
      std::fprintf(stderr, "goniolux-studio: there is no option %s; goniolux-studio --help lists them\n", arguments[i]);
      return 2;
    }
  }
  return aWindowIsWanted;
}

/// Qt ends the program with a message about its plugins where there is no display.
bool hasDisplay(int count, char** arguments) {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0') return true;
  for (int i = 1; i < count; ++i)
    if (std::string_view(arguments[i]) == "-platform" || std::string_view(arguments[i]) == "-display") return true;
  return false;
}

}  // namespace

int main(int count, char** arguments) {
  if (const int code = answered(count, arguments); code >= 0) return code;
  if (!hasDisplay(count, arguments)) {
    std::fputs(
        "goniolux-studio: there is no display to open a window on (DISPLAY is not set); start it in a graphical "
        "session, or use the command line: goniolux --help\n",
        stderr);
    return 2;
  }
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  vtkObject::GlobalWarningDisplayOff();
  QApplication application(count, arguments);
  QApplication::setOrganizationName("Goniolux");
  QApplication::setApplicationName("goniolux-studio");
  QApplication::setApplicationVersion(GONIOLUX_VERSION);
  QApplication::setApplicationDisplayName("Goniolux Studio");
  goniolux::gui::installLanguage(QSettings().value("language", "system").toString());
  goniolux::gui::applyTheme(QSettings().value("theme", "light").toString());
  goniolux::gui::MainWindow window;
  window.restoreLayout();
  window.show();
  window.offerRecovery();
  QStringList given = QApplication::arguments().mid(1);
  if (given.removeAll("--time-start") > 0) goniolux::gui::reportStartAndQuit(window);
  if (!given.isEmpty()) window.openProject(given.first());
  return QApplication::exec();
}
