// Copies of entries: duplicated, cut, copied and pasted, within a project or from one to another.
#include <QApplication>
#include <QClipboard>
#include <map>
#include <set>

#include "app/gui/document/json_pointer.h"
#include "app/gui/window/project_tree.h"

namespace goniolux::gui {

using core::Value;

namespace {

// On the clipboard: {"goniolux-entries": [{"list": "/luminaires", "entries": [{"name": …, "value": {…}}, …]}, …]} as
// text, so that it can be pasted into an editor, too.
constexpr const char* listsKey = "goniolux-entries";

std::set<std::string> namesIn(const Value* list) {
  std::set<std::string> names;
  if (list == nullptr) return names;
  if (list->isObject())
    for (const auto& [name, entry] : list->object()) names.insert(name);
  if (list->isArray())
    for (const Value& entry : list->array())
      if (const Value* name = entry.find("name"); name != nullptr && name->isString()) names.insert(name->string());
  return names;
}

/// "desk", "desk 2", "desk 3": the first that is free, which is taken then.
std::string freeName(const std::string& wanted, std::set<std::string>& taken) {
  std::string stem = wanted;
  if (const std::size_t blank = stem.find_last_of(' ');
      blank != std::string::npos && stem.find_first_not_of("0123456789", blank + 1) == std::string::npos)
    stem.resize(blank);
  std::string name = wanted;
  for (int k = 2; taken.contains(name); ++k) name = stem + " " + std::to_string(k);
  taken.insert(name);
  return name;
}

}  // namespace

Value ProjectTree::selectedEntries() const {
  std::map<std::string, Value> byList;
  for (const std::string& pointer : selection()) {
    const Value* value = document_.find(pointer);
    if (value == nullptr || stepsOf(pointer).size() != 2) continue;
    Value& entries = byList.try_emplace(parentOf(pointer), Value::Array{}).first->second;
    entries.push(Value::Object{{"name", lastStep(pointer)}, {"value", *value}});
  }
  Value lists = Value::Array{};
  for (const auto& [list, entries] : byList) lists.push(Value::Object{{"list", list}, {"entries", entries}});
  return lists;
}

void ProjectTree::copySelection() const {
  const Value lists = selectedEntries();
  if (lists.array().empty()) return;
  const Value copied = Value::Object{{listsKey, lists}};
  QApplication::clipboard()->setText(QString::fromStdString(core::toJson(copied)));
}

void ProjectTree::cutSelection() {
  copySelection();
  removeSelection();
}

void ProjectTree::duplicateSelection() {
  addCopies(selectedEntries(), [](int count) { return tr("Duplicate %n entries", nullptr, count); });
}

void ProjectTree::paste() {
  core::Diagnostics ignored;
  const Value copied = core::parseJson(QApplication::clipboard()->text().toStdString(), "clipboard", ignored);
  if (const Value* lists = copied.find(listsKey); lists != nullptr && lists->isArray())
    addCopies(*lists, [](int count) { return tr("Paste %n entries", nullptr, count); });
}

void ProjectTree::addCopies(const Value& lists, const std::function<QString(int)>& words) {
  int count = 0;
  for (const Value& some : lists.array())
    if (const Value* entries = some.find("entries"); entries != nullptr && entries->isArray())
      count += static_cast<int>(entries->array().size());
  if (count == 0) return;
  std::vector<std::string> added;
  document_.edit(words(count), [&](project::ProjectText& text) {
    for (const Value& some : lists.array()) {
      const Value *list = some.find("list"), *entries = some.find("entries");
      if (list != nullptr && list->isString() && entries != nullptr && entries->isArray())
        addCopies(text, list->string(), *entries, added);
    }
  });
  bool isFirst = true;
  for (const std::string& pointer : added) {
    select(pointer, !isFirst);
    isFirst = false;
  }
}

void ProjectTree::addCopies(project::ProjectText& text, const std::string& list, const Value& entries,
                            std::vector<std::string>& added) const {
  const Value* existing = document_.find(list);
  std::set<std::string> taken = namesIn(existing);
  const bool byName = list == "/materials";
  std::size_t next = existing != nullptr && existing->isArray() ? existing->array().size() : 0;
  if (valueAt(text.root(), list) == nullptr) setIn(text, list, byName ? Value(Value::Object{}) : Value(Value::Array{}));
  for (const Value& entry : entries.array()) {
    const Value *name = entry.find("name"), *value = entry.find("value");
    if (name == nullptr || !name->isString() || value == nullptr || !value->isObject()) continue;
    Value copy = *value;
    if (byName) {
      added.push_back(under(list, freeName(name->string(), taken)));
      text.add(*valueAt(text.root(), list), lastStep(added.back()), copy);
      continue;
    }
    if (const Value* own = copy.find("name"); own != nullptr && own->isString())
      copy.set("name", freeName(own->string(), taken));
    text.append(*valueAt(text.root(), list), copy);
    added.push_back(under(list, next++));
  }
}

}  // namespace goniolux::gui
