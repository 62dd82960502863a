// ProjectTree: everything that the project holds, by kind. Entries may be selected together; a context menu adds,
// duplicates and removes.
#pragma once

#include <QTreeWidget>
#include <functional>
#include <string>
#include <vector>

#include "app/gui/document/checked_project.h"
#include "app/gui/document/document.h"

namespace goniolux::gui {

class ProjectTree final : public QTreeWidget {
  Q_OBJECT
 public:
  ProjectTree(Document& document, const ProjectChecker& checker, QWidget* parent = nullptr);

  /// Selects the entry; "" selects nothing. `together`: with what is selected already, or out of it.
  void select(const std::string& pointer, bool together = false);
  /// Entries of several kinds may be selected together; a kind's title or the settings only alone.
  [[nodiscard]] std::vector<std::string> selection() const;

  void addEntry(const std::string& listPointer);
  /// Shows everything anew: after a change of the theme.
  void rebuild();
  void duplicateSelection();
  void removeSelection();
  /// Puts the selected entries on the clipboard as JSON; what is there goes into the project, under free names.
  void copySelection() const;
  void cutSelection();
  void paste();

 Q_SIGNALS:
  void chosen(const std::vector<std::string>& pointers);

 private:
  void addList(const QString& title, const char* key, const QString& iconName);
  void markProblems();
  void showMenu(const QPoint& at);
  /// The selected entries as copies are kept: [{"list": …, "entries": [{"name": …, "value": …}]}].
  [[nodiscard]] core::Value selectedEntries() const;
  void addCopies(const core::Value& lists, const std::function<QString(int)>& words);
  void addCopies(project::ProjectText& text, const std::string& list, const core::Value& entries,
                 std::vector<std::string>& added) const;

  Document& document_;
  const ProjectChecker& checker_;
  bool isRebuilding_ = false;
};

/// What a new entry of a list begins with: "/grids" gives a small grid in the middle of the room.
core::Value newEntryFor(const std::string& listPointer, const RoomScene* scene, const std::string& name);

}  // namespace goniolux::gui
