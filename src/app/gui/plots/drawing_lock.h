// One drawing at a time: VTK's letters and filters share tables that are not made for several threads.
#pragma once

#include <QMutex>

namespace goniolux::gui {

inline QMutex& drawingLock() {
  static QMutex mutex;
  return mutex;
}

}  // namespace goniolux::gui
