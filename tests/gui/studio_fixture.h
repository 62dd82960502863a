// A main window to drive: waiting, clicking, screenshots.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QPixmap>
#include <QTemporaryDir>
#include <QtTest/QtTest>
#include <functional>
#include <memory>

#include "app/gui/window/main_window.h"
#include "gui/watchdog.h"

namespace goniolux::test {

inline bool& displayIsThere() {
  static bool there = false;
  return there;
}

class StudioFixture : public testing::Test {
 protected:
  void SetUp() override {
    if (!displayIsThere())
      GTEST_SKIP()
          << "no display: xvfb-run and xauth are not installed (packages xvfb and xauth), and driven tests need one";
    window_ = std::make_unique<gui::MainWindow>();
    window_->resize(1440, 900);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  }
  void TearDown() override {
    watchdog_.reset();
    if (window_) window_->closeWithoutAsking();
    window_.reset();
  }

  /// Waits until the condition holds; a failure names it.
  static bool wait(const std::function<bool()>& condition, int milliseconds = 60000) {
    return QTest::qWaitFor(condition, milliseconds);
  }
  /// The engine has read the text as it is now.
  bool waitForCheck() {
    return wait([this] { return window_->checker().isCurrent(); });
  }
  bool waitForJobs(int milliseconds = 60000) {
    return wait([this] { return !window_->jobs().isBusy(); }, milliseconds);
  }

  /// A copy of a sample project that may be written to.
  QString copyOf(const QString& sample) {
    const QString from = QString(GONIOLUX_SOURCE_DIR) + "/projects/" + sample;
    const QString to = folder_.filePath(sample);
    QDir().mkpath(to);
    for (const QString& name : QDir(from).entryList(QDir::Files)) QFile::copy(from + "/" + name, to + "/" + name);
    return to;
  }

  /// Another accuracy in a copied project's file: tests of the interface need no exact numbers.
  static void setAccuracy(const QString& folder, const QByteArray& from, const QByteArray& to) {
    QFile file(folder + "/project.json");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QByteArray text = file.readAll();
    file.close();
    text.replace("\"grid\": \"" + from + "\"", "\"grid\": \"" + to + "\"");
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }

  /// Writes what the window shows into the folder of test artefacts (and of the guide, when
  /// GONIOLUX_UPDATE_PAGES is set).
  void screenshot(const QString& name) {
    QTest::qWait(150);
    const Watchdog::Blindfold blindfold(watchdog_.get());
    saveScreenshot(window_->grab(), name);
  }
  static void saveScreenshot(const QPixmap& picture, const QString& name) {
    ASSERT_FALSE(picture.isNull());
    QStringList folders{QString(GONIOLUX_BINARY_DIR) + "/studio-screenshots"};
    if (qEnvironmentVariableIsSet("GONIOLUX_UPDATE_PAGES"))
      folders << QString(GONIOLUX_SOURCE_DIR) + "/docs/studio/images";
    for (const QString& folder : folders) {
      QDir().mkpath(folder);
      ASSERT_TRUE(picture.save(folder + "/" + name + ".png"));
    }
  }

  QTemporaryDir folder_;
  std::unique_ptr<gui::MainWindow> window_;
  std::unique_ptr<Watchdog> watchdog_;  ///< of tests that have one
};

}  // namespace goniolux::test
