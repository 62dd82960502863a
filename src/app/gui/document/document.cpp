#include "app/gui/document/document.h"

#include <QDir>
#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "app/gui/document/json_pointer.h"

namespace goniolux::gui {

using core::Value;

/// One change of the text: only what differs is kept.
class TextStep final : public QUndoCommand {
 public:
  TextStep(Document& document, const std::string& after, const QString& words, bool isTyping)
      : QUndoCommand(words), document_(document), isTyping_(isTyping) {
    const std::string& before = document.text_;
    const std::size_t most = std::min(before.size(), after.size());
    while (at_ < most && before[at_] == after[at_]) ++at_;
    std::size_t tail = 0;
    while (tail < most - at_ && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
    removed_ = before.substr(at_, before.size() - tail - at_);
    inserted_ = after.substr(at_, after.size() - tail - at_);
  }
  void redo() override { document_.replaceRange(at_, removed_.size(), inserted_); }
  void undo() override { document_.replaceRange(at_, inserted_.size(), removed_); }
  [[nodiscard]] int id() const override { return isTyping_ ? 1 : -1; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto& typed = static_cast<const TextStep&>(*next);
    if (!typed.removed_.empty() || typed.at_ != at_ + inserted_.size()) return false;
    inserted_ += typed.inserted_;
    return true;
  }

 private:
  Document& document_;
  std::size_t at_ = 0;
  std::string removed_, inserted_;
  bool isTyping_;
};

void setIn(project::ProjectText& text, const std::string& pointer, const Value& value) {
  if (const Value* old = valueAt(text.root(), pointer)) return text.replace(*old, value);
  const std::string parent = parentOf(pointer);
  const Value* container = valueAt(text.root(), parent);
  if (container == nullptr) return setIn(text, parent, Value::Object{{lastStep(pointer), value}});
  if (container->isArray()) return text.append(*container, value);
  if (container->isObject()) return text.add(*container, lastStep(pointer), value);
  text.replace(*container, Value::Object{{lastStep(pointer), value}});
}

void removeIn(project::ProjectText& text, const std::string& pointer) {
  const Value* container = valueAt(text.root(), parentOf(pointer));
  const Value* gone = valueAt(text.root(), pointer);
  if (container == nullptr || gone == nullptr) return;
  if (container->isArray()) {
    text.remove(*container, static_cast<std::size_t>(gone - container->array().data()));
    return;
  }
  for (std::size_t i = 0; i < container->object().size(); ++i)
    if (&container->object()[i].second == gone) return text.remove(*container, i);
}

Document::Document(QObject* parent) : QObject(parent) {
  connect(&undo_, &QUndoStack::cleanChanged, this, &Document::modifiedChanged);
}

void Document::open(const QString& path) {
  const QFileInfo given(path);
  const QString file = given.isDir() ? QDir(path).filePath("project.json") : path;
  text_ = core::readFile(file.toStdString());
  file_ = QFileInfo(file).absoluteFilePath();
  recovered_ = false;
  undo_.clear();
  parse();
  Q_EMIT opened();
  Q_EMIT changed();
  Q_EMIT modifiedChanged();
}

void Document::openText(const std::string& text, const QString& file) {
  text_ = text;
  file_ = QFileInfo(file).absoluteFilePath();
  recovered_ = true;
  undo_.clear();
  parse();
  Q_EMIT opened();
  Q_EMIT changed();
  Q_EMIT modifiedChanged();
}

void Document::close() {
  file_.clear();
  text_.clear();
  recovered_ = false;
  undo_.clear();
  root_ = {};
  parses_ = false;
  Q_EMIT opened();
  Q_EMIT modifiedChanged();
}

QString Document::folder() const {
  return QFileInfo(file_).absolutePath();
}

QString Document::title() const {
  const Value* name = root_.find("name");
  if (name != nullptr && name->isString() && !name->string().empty()) return QString::fromStdString(name->string());
  return QFileInfo(folder()).fileName();
}

const Value* Document::find(const std::string& pointer) const {
  return valueAt(root_, pointer);
}

void Document::edit(const QString& words, const std::function<void(project::ProjectText&)>& change) {
  if (!parses_) {
    Q_EMIT refused(tr("The project's text is no valid JSON at the moment; mend it in the text panel first."));
    return;
  }
  try {
    project::ProjectText text(text_, file_.toStdString());
    change(text);
    setText(text.text(), words);
  } catch (const core::InputError& error) {
    Q_EMIT refused(QString::fromUtf8(error.what()));
  }
}

void Document::set(const std::string& pointer, const Value& value, const QString& words) {
  edit(words, [&](project::ProjectText& text) { setIn(text, pointer, value); });
}

void Document::append(const std::string& listPointer, const Value& entry, const QString& words) {
  edit(words, [&](project::ProjectText& text) {
    if (valueAt(text.root(), listPointer) == nullptr) setIn(text, listPointer, Value::Array{});
    text.append(*valueAt(text.root(), listPointer), entry);
  });
}

void Document::remove(const std::string& pointer, const QString& words) {
  edit(words, [&](project::ProjectText& text) { removeIn(text, pointer); });
}

void Document::setText(const std::string& text, const QString& words, bool isTyping) {
  if (text == text_) return;
  undo_.push(new TextStep(*this, text, words, isTyping));
}

void Document::replaceRange(std::size_t at, std::size_t length, const std::string& text) {
  text_.replace(at, length, text);
  parse();
  Q_EMIT changed();
}

void Document::parse() {
  ++revision_;
  core::Diagnostics diagnostics;
  Value root = core::parseJson(text_, file_.toStdString(), diagnostics);
  parses_ = !diagnostics.hasErrors() && root.isObject();
  syntaxErrors_ = diagnostics;
  if (parses_) root_ = std::move(root);
}

void Document::save() {
  core::writeFile(file_.toStdString(), text_);
  recovered_ = false;
  undo_.setClean();
  Q_EMIT modifiedChanged();
}

void Document::saveAs(const QString& folder) {
  const QString file = QDir(folder).filePath("project.json");
  QDir().mkpath(folder);
  core::writeFile(file.toStdString(), text_);
  file_ = QFileInfo(file).absoluteFilePath();
  recovered_ = false;
  undo_.setClean();
  parse();
  Q_EMIT modifiedChanged();
  Q_EMIT changed();
}

}  // namespace goniolux::gui
