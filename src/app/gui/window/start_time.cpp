#include "app/gui/window/start_time.h"

#include <time.h>
#include <unistd.h>

#include <QApplication>
#include <QFile>
#include <QTimer>
#include <QWidget>
#include <cstdio>

namespace goniolux::gui {
namespace {

/// Since this process was started; the kernel counts it in ticks of 10 ms. 0 where it does not say.
double millisecondsSinceStart() {
  QFile file("/proc/self/stat");
  if (!file.open(QIODevice::ReadOnly)) return 0;
  const QByteArray text = file.readAll();
  const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
  if (fields.size() < 20) return 0;
  const double started = fields.at(19).toDouble() / static_cast<double>(sysconf(_SC_CLK_TCK));
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return 1000 * (static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - started);
}

}  // namespace

void reportStartAndQuit(QWidget& window) {
  window.repaint();  // not when the event loop finds time, but now
  QTimer::singleShot(0, &window, [] {
    std::printf("%.0f ms from the start of the process to the window\n", millisecondsSinceStart());
    QApplication::quit();
  });
}

}  // namespace goniolux::gui
