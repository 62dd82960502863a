// Field: one key of the format as a line of a form: it shows the document's value, checks what is typed, and says what
// was entered.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/document.h"
#include "project/format.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace goniolux::gui {

class Field final : public QWidget {
  Q_OBJECT
 public:
  /// `suggestions`: names that may be meant (materials, files).
  Field(const project::Key& key, const QStringList& suggestions, QWidget* parent = nullptr);

  [[nodiscard]] const project::Key& key() const { return key_; }
  /// Shows a value; null: the key is left out. `differs`: of several selected entries with different values.
  void show(const core::Value* value, bool differs = false);
  /// Marks the field with what the engine's reader says about it; "": nothing.
  void setProblem(const QString& message);
  [[nodiscard]] bool isWrong() const { return isWrong_; }

 Q_SIGNALS:
  void entered(const std::optional<core::Value>& value);

 private:
  void buildChoice();
  void buildLines(const QStringList& suggestions);
  void buildBrowse();
  void check();
  void commit();
  [[nodiscard]] QString typed() const;
  void mark(bool wrong, const QString& why);

  project::Key key_;
  QComboBox* choice_ = nullptr;
  std::vector<QLineEdit*> lines_;
  QString shown_, help_, problem_;
  bool isWrong_ = false;
};

}  // namespace goniolux::gui
