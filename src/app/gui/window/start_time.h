// StartTime: how long the program took until its window was there, loading of libraries included.
#pragma once

class QWidget;

namespace goniolux::gui {

/// Prints the milliseconds from the start of the process to the window's first picture, and ends the program.
void reportStartAndQuit(QWidget& window);

}  // namespace goniolux::gui
