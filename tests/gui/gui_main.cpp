// The driven tests' program. Without a display it starts itself again under xvfb-run; without that, every test skips.
#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkObject.h>
#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>

#include <cstdlib>
#include <vector>

#include "app/gui/window/theme.h"
#include "gui/studio_fixture.h"

namespace {

bool hasDisplay() {
  const char* display = std::getenv("DISPLAY");
  return display != nullptr && *display != '\0' && std::getenv("GONIOLUX_GUI_DISPLAY") != nullptr;
}

/// A display of a known size, so that pictures are the same everywhere.
void startAgainUnderXvfb(char** arguments) {
  if (QStandardPaths::findExecutable("xvfb-run").isEmpty() || QStandardPaths::findExecutable("xauth").isEmpty()) return;
  setenv("GONIOLUX_GUI_DISPLAY", "1", 1);
  std::vector<char*> command;
  static char program[] = "xvfb-run", automatic[] = "-a", option[] = "-s", screen[] = "-screen 0 1600x1000x24";
  for (char* word : {program, automatic, option, screen}) command.push_back(word);
  for (char** word = arguments; *word != nullptr; ++word) command.push_back(*word);
  command.push_back(nullptr);
  execvp(program, command.data());
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> given(arguments, arguments + count);
  testing::InitGoogleTest(&count, arguments);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  if (!hasDisplay()) {
    std::vector<char*> words;
    for (const std::string& word : given) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    startAgainUnderXvfb(words.data());
    return RUN_ALL_TESTS();  // every test says that it skips
  }
  // Settings of the person who runs the tests stay as they are.
  const QTemporaryDir home;
  setenv("XDG_CONFIG_HOME", home.path().toUtf8().constData(), 1);
  setenv("XDG_DATA_HOME", home.path().toUtf8().constData(), 1);
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  vtkObject::GlobalWarningDisplayOff();
  QApplication application(count, arguments);
  QApplication::setOrganizationName("Goniolux");
  QApplication::setApplicationName("goniolux-studio");
  goniolux::gui::applyTheme("light");
  goniolux::test::displayIsThere() = true;
  return RUN_ALL_TESTS();
}
