// ProjectTree: everything that the project holds, by kind. Entries may be selected together; a context menu adds,
// duplicates and removes.
#pragma once

#include <QTreeWidget>
#include <string>
#include <vector>

#include "app/gui/document/checked_project.h"
#include "app/gui/document/document.h"

namespace goniolux::gui {

class ProjectTree final : public QTreeWidget {
  Q_OBJECT
 public:
  ProjectTree(Document& document, const ProjectChecker& checker, QWidget* parent = nullptr);

  /// Selects the entry; "" selects nothing.
  void select(const std::string& pointer);
  [[nodiscard]] std::vector<std::string> selection() const;

  void addEntry(const std::string& listPointer);
  /// Shows everything anew: after a change of the theme.
  void rebuild();
  void duplicateSelection();
  void removeSelection();

 Q_SIGNALS:
  void chosen(const std::vector<std::string>& pointers);

 private:
  void addList(const QString& title, const char* key, const QString& iconName);
  void markProblems();
  void showMenu(const QPoint& at);

  Document& document_;
  const ProjectChecker& checker_;
  bool isRebuilding_ = false;
};

/// What a new entry of a list begins with: "/grids" gives a small grid in the middle of the room.
core::Value newEntryFor(const std::string& listPointer, const RoomScene* scene, const std::string& name);

}  // namespace goniolux::gui
