// HelpWindow: the documentation, read in a window of its own: pages of docs/ with their pictures, forward and back.
#pragma once

#include <QMainWindow>

class QTextBrowser;

namespace goniolux::gui {

class HelpWindow final : public QMainWindow {
  Q_OBJECT
 public:
  explicit HelpWindow(QWidget* parent = nullptr);
  /// Opens a page of the documentation ("studio/README.md"). False where it is not installed.
  bool open(const QString& page);
  /// The file that is shown.
  [[nodiscard]] QString shown() const;
  /// The page of the documentation as a file: beside the program's data when it is installed, else in the repository;
  /// "" where there is none.
  static QString fileOf(const QString& page);

 private:
  QTextBrowser* browser_;
};

}  // namespace goniolux::gui
