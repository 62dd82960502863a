// LuminairePage: a photometric file: polar diagram, photometric solid, Cartesian diagram, and its sheet with every
// assumption that was made in reading it.
#pragma once

#include <QWidget>
#include <memory>

#include "app/gui/jobs/latest.h"
#include "photometry/photometric_file.h"

class QComboBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTabWidget;

namespace goniolux::gui {

class Paper;

class LuminairePage final : public QWidget {
  Q_OBJECT
 public:
  explicit LuminairePage(QWidget* parent = nullptr);
  /// The files that may be looked at: those of the project first, then the program's own.
  void setFiles(const QStringList& ofProject, const QString& projectFolder);
  /// Shows a file by path or by the name in the list.
  void showFile(const QString& file);
  [[nodiscard]] QString sheetText() const;
  /// As the project would name it.
  [[nodiscard]] QString shownName() const { return shown_; }

 Q_SIGNALS:
  void importRequested();
  /// To use the shown file for the selected luminaires, or instead of `instead` everywhere.
  void useRequested(const QString& name);
  void replaceRequested(const QString& name);

 private:
  struct Loaded {
    QString name, text;
    std::shared_ptr<const photometry::PhotometricFile> file;  ///< null: it cannot be read, and the text says why
  };
  [[nodiscard]] QString pathOf(const QString& name) const;
  void take(const Loaded& loaded);

  QComboBox* files_;
  Paper *polar_, *solid_, *cartesian_;
  QPlainTextEdit* sheet_;
  QString folder_, shown_;
  Latest<Loaded> loading_;
};

}  // namespace goniolux::gui
