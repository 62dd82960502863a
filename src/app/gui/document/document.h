// Document: the project that is open, as the text of its project.json. Every change is a step that can be undone, made
// on the text itself, so that comments and layout of what is not touched stay. A text that is no JSON stays editable as
// text; structured edits wait until it is mended. GUI thread only.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <string>

#include "core/document.h"
#include "project/project_text.h"

namespace goniolux::gui {

class Document final : public QObject {
  Q_OBJECT
 public:
  explicit Document(QObject* parent = nullptr);

  /// Opens a folder with a project.json, or such a file; a broken one too. Throws core::InputError when there is none.
  void open(const QString& path);
  /// A text in place of the file's: recovered, or of a project that is not saved yet; counts as changed.
  void openText(const std::string& text, const QString& file);
  void close();
  [[nodiscard]] bool isOpen() const { return !file_.isEmpty(); }

  [[nodiscard]] const QString& file() const { return file_; }
  [[nodiscard]] QString folder() const;
  /// The project's name, else its folder's.
  [[nodiscard]] QString title() const;
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool parses() const { return parses_; }
  /// The text as values with positions; of the last text that could be read.
  [[nodiscard]] const core::Value& root() const { return root_; }
  [[nodiscard]] const core::Diagnostics& syntaxErrors() const { return syntaxErrors_; }
  [[nodiscard]] const core::Value* find(const std::string& pointer) const;

  /// Each is one step of undo, named by `words`. Edits of a text that is no JSON do nothing and emit refused().
  void set(const std::string& pointer, const core::Value& value, const QString& words);
  void append(const std::string& listPointer, const core::Value& entry, const QString& words);
  void remove(const std::string& pointer, const QString& words);
  /// Several edits as one step.
  void edit(const QString& words, const std::function<void(project::ProjectText&)>& change);
  /// Replaces the whole text; consecutive replacements by typing become one step.
  void setText(const std::string& text, const QString& words, bool isTyping = false);

  void save();                         ///< throws core::RunError
  void saveAs(const QString& folder);  ///< writes folder/project.json and goes on there; throws core::RunError
  [[nodiscard]] QUndoStack& undoStack() { return undo_; }
  [[nodiscard]] bool isModified() const { return recovered_ || !undo_.isClean(); }
  /// Counts up with every change of the text.
  [[nodiscard]] quint64 revision() const { return revision_; }

 Q_SIGNALS:
  void opened();
  void changed();
  void modifiedChanged();
  void refused(const QString& why);

 private:
  friend class TextStep;
  void replaceRange(std::size_t at, std::size_t length, const std::string& text);
  void parse();

  QString file_;
  std::string text_;
  core::Value root_;
  core::Diagnostics syntaxErrors_;
  bool parses_ = false, recovered_ = false;
  quint64 revision_ = 0;
  QUndoStack undo_;
};

/// Edits on a ProjectText by pointer: sets (or adds, with what is missing above it), or removes a value.
void setIn(project::ProjectText& text, const std::string& pointer, const core::Value& value);
void removeIn(project::ProjectText& text, const std::string& pointer);

}  // namespace goniolux::gui
