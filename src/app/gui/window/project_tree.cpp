#include "app/gui/window/project_tree.h"

#include <QHeaderView>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <set>

#include "app/gui/document/json_pointer.h"
#include "app/gui/window/icons.h"
#include "app/gui/window/theme.h"

namespace goniolux::gui {

using core::Value;

namespace {

constexpr int pointerRole = Qt::UserRole;

std::string pointerOf(const QTreeWidgetItem* item) {
  return item->data(0, pointerRole).toString().toStdString();
}

/// How an entry of a list is called: by its name, else by what it is about.
QString titleOf(const Value& entry, std::size_t index) {
  for (const char* key : {"name", "grid", "observer", "shape"})
    if (const Value* text = entry.find(key); text != nullptr && text->isString())
      return QString::fromStdString(text->string());
  return QString("%1").arg(index + 1);
}

QString detailOf(const Value& entry) {
  if (const Value* array = entry.find("array"))
    if (const Value* counts = array->find("counts");
        counts != nullptr && counts->isArray() && counts->array().size() == 2)
      if (counts->array()[0].isNumber() && counts->array()[1].isNumber())
        return QString("%1 × %2").arg(counts->array()[0].number()).arg(counts->array()[1].number());
  for (const char* key : {"photometry", "model", "shape", "quantity"})
    if (const Value* text = entry.find(key); text != nullptr && text->isString())
      return QString::fromStdString(text->string());
  return {};
}

}  // namespace

ProjectTree::ProjectTree(Document& document, const ProjectChecker& checker, QWidget* parent)
    : QTreeWidget(parent), document_(document), checker_(checker) {
  setObjectName("projectTree");
  setAccessibleName(tr("Project"));
  setColumnCount(2);
  setHeaderHidden(true);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setUniformRowHeights(true);
  setContextMenuPolicy(Qt::CustomContextMenu);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setMinimumSectionSize(60);
  header()->resizeSection(1, 92);
  connect(this, &QTreeWidget::customContextMenuRequested, this, &ProjectTree::showMenu);
  connect(this, &QTreeWidget::itemSelectionChanged, this, [this] {
    if (!isRebuilding_) Q_EMIT chosen(selection());
  });
  connect(&document_, &Document::changed, this, &ProjectTree::rebuild);
  connect(&document_, &Document::opened, this, [this] {
    clear();
    rebuild();
  });
  connect(&checker_, &ProjectChecker::checked, this, &ProjectTree::markProblems);
}

std::vector<std::string> ProjectTree::selection() const {
  std::vector<std::string> pointers;
  for (const QTreeWidgetItem* item : selectedItems()) pointers.push_back(pointerOf(item));
  if (pointers.size() > 1) {
    std::erase_if(pointers, [](const std::string& p) { return stepsOf(p).size() != 2; });
    // In the order of the document, whatever was clicked first.
    std::sort(pointers.begin(), pointers.end(), [](const std::string& a, const std::string& b) {
      const std::string listA = parentOf(a), listB = parentOf(b);
      return listA != listB ? listA < listB : a.size() != b.size() ? a.size() < b.size() : a < b;
    });
  }
  return pointers;
}

void ProjectTree::rebuild() {
  isRebuilding_ = true;
  const std::vector<std::string> chosenBefore = selection();
  std::set<std::string> open;
  const bool isFirst = topLevelItemCount() == 0;
  for (int i = 0; i < topLevelItemCount(); ++i)
    if (topLevelItem(i)->isExpanded()) open.insert(pointerOf(topLevelItem(i)));
  setUpdatesEnabled(false);
  clear();
  if (document_.isOpen()) {
    auto* project = new QTreeWidgetItem(this, {document_.title()});
    project->setIcon(0, icon("project"));
    project->setFirstColumnSpanned(true);
    project->setData(0, pointerRole, QString());
    addList(tr("Objects"), "objects", "object");
    addList(tr("Materials"), "materials", "material");
    addList(tr("Luminaires"), "luminaires", "luminaire");
    addList(tr("Lighting scenes"), "scenes", "scene");
    addList(tr("Grids"), "grids", "grid");
    addList(tr("Observers"), "observers", "observer");
    addList(tr("Views"), "views", "view");
    addList(tr("Requirements"), "requirements", "requirement");
    auto* settings = new QTreeWidgetItem(this, {tr("Settings")});
    settings->setIcon(0, icon("settings"));
    settings->setData(0, pointerRole, "/settings");
  }
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = topLevelItem(i);
    const std::string pointer = pointerOf(item);
    item->setExpanded(isFirst ? pointer == "/luminaires" || pointer == "/grids" || pointer == "/views"
                              : open.contains(pointer));
    for (int k = 0; k < item->childCount(); ++k)
      if (std::find(chosenBefore.begin(), chosenBefore.end(), pointerOf(item->child(k))) != chosenBefore.end())
        item->child(k)->setSelected(true);
    if (std::find(chosenBefore.begin(), chosenBefore.end(), pointer) != chosenBefore.end()) item->setSelected(true);
  }
  setUpdatesEnabled(true);
  isRebuilding_ = false;
  markProblems();
}

void ProjectTree::addList(const QString& title, const char* key, const QString& iconName) {
  auto* parent = new QTreeWidgetItem(this, {title});
  const std::string list = under("", key);
  parent->setIcon(0, icon(iconName));
  parent->setData(0, pointerRole, QString::fromStdString(list));
  const Value* value = document_.find(list);
  const auto add = [&](const std::string& pointer, const QString& name, const Value& entry) {
    auto* item = new QTreeWidgetItem(parent, {name, detailOf(entry)});
    item->setData(0, pointerRole, QString::fromStdString(pointer));
    item->setForeground(1, theme().faintText);
  };
  if (value != nullptr && value->isArray()) {
    for (std::size_t i = 0; i < value->array().size(); ++i)
      add(under(list, i), titleOf(value->array()[i], i), value->array()[i]);
  } else if (value != nullptr && value->isObject()) {
    for (const auto& [name, entry] : value->object()) add(under(list, name), QString::fromStdString(name), entry);
  }
  parent->setText(1, parent->childCount() > 0 ? QString::number(parent->childCount()) : QString("–"));
  parent->setForeground(1, theme().faintText);
}

void ProjectTree::markProblems() {
  std::set<std::string> wrong;
  for (const core::Diagnostic& d : checker_.latest()->diagnostics.all()) {
    if (d.severity != core::Severity::error || d.position.line == 0) continue;
    const auto steps = stepsOf(pointerAt(document_.root(), d.position.line, d.position.column));
    if (!steps.empty()) wrong.insert(under("", steps[0]));
    if (steps.size() > 1) wrong.insert(under(under("", steps[0]), steps[1]));
  }
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = topLevelItem(i);
    const auto mark = [&](QTreeWidgetItem* entry) {
      entry->setForeground(0, wrong.contains(pointerOf(entry)) ? theme().fail : theme().text);
    };
    mark(item);
    for (int k = 0; k < item->childCount(); ++k) mark(item->child(k));
  }
}

void ProjectTree::select(const std::string& pointer, bool together) {
  isRebuilding_ = true;
  if (!together) clearSelection();
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = topLevelItem(i);
    if (!pointer.empty() && pointerOf(item) == pointer) setCurrentItem(item);
    for (int k = 0; k < item->childCount(); ++k) {
      QTreeWidgetItem* entry = item->child(k);
      if (pointerOf(entry) != pointer) continue;
      item->setExpanded(true);
      if (together) {
        entry->setSelected(!entry->isSelected());
      } else {
        setCurrentItem(entry);
        entry->setSelected(true);
      }
    }
  }
  isRebuilding_ = false;
  Q_EMIT chosen(selection());
}

void ProjectTree::addEntry(const std::string& list) {
  const Value* value = document_.find(list);
  std::set<std::string> names;
  std::size_t count = 0;
  if (value != nullptr && value->isArray()) {
    count = value->array().size();
    for (const Value& entry : value->array())
      if (const Value* name = entry.find("name"); name != nullptr && name->isString()) names.insert(name->string());
  } else if (value != nullptr && value->isObject()) {
    for (const auto& [name, entry] : value->object()) names.insert(name);
  }
  std::string kind = list.substr(1);
  if (kind.ends_with('s')) kind.pop_back();
  std::string name = kind;
  for (int k = 2; names.contains(name); ++k) name = kind + " " + std::to_string(k);
  const Value entry = newEntryFor(list, checker_.latestGood()->scene.get(), name);
  const QString words = tr("Add %1").arg(QString::fromStdString(name));
  if (list == "/materials") {
    document_.set(under(list, name), entry, words);
    select(under(list, name));
  } else {
    document_.append(list, entry, words);
    select(under(list, count));
  }
}

void ProjectTree::removeSelection() {
  std::vector<std::string> pointers = selection();
  std::erase_if(pointers, [](const std::string& p) { return stepsOf(p).size() != 2; });
  if (pointers.empty()) return;
  // From the last to the first, so that the numbers of those that are left stay right.
  std::sort(pointers.begin(), pointers.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() > b.size() : a > b;
  });
  clearSelection();
  document_.edit(tr("Remove %n entries", nullptr, static_cast<int>(pointers.size())), [&](project::ProjectText& text) {
    for (const std::string& pointer : pointers) removeIn(text, pointer);
  });
}

void ProjectTree::showMenu(const QPoint& at) {
  QMenu menu(this);
  const QTreeWidgetItem* item = itemAt(at);
  if (item != nullptr) {
    const auto steps = stepsOf(pointerOf(item));
    if (!steps.empty() && steps[0] != "settings") {
      const std::string list = under("", steps[0]);
      menu.addAction(tr("Add"), this, [this, list] { addEntry(list); });
    }
    if (steps.size() == 2) {
      menu.addAction(tr("Duplicate"), this, &ProjectTree::duplicateSelection);
      menu.addAction(tr("Copy"), this, &ProjectTree::copySelection);
      menu.addAction(tr("Remove"), this, &ProjectTree::removeSelection);
    }
  }
  menu.addAction(tr("Paste"), this, &ProjectTree::paste);
  if (!menu.isEmpty()) menu.exec(viewport()->mapToGlobal(at));
}

Value newEntryFor(const std::string& list, const RoomScene* scene, const std::string& name) {
  const core::Vec3 low = scene != nullptr ? scene->low : core::Vec3(0);
  const core::Vec3 high = scene != nullptr ? scene->high : core::Vec3(4, 3, 2.5);
  const auto rounded = [](double x) { return std::round(x * 100) / 100; };
  const auto point = [&](double x, double y, double z) {
    return Value(Value::Array{rounded(x), rounded(y), rounded(z)});
  };
  const core::Vec3 m = 0.5 * (low + high);
  if (list == "/materials") return Value::Object{{"model", "lambert"}, {"diffuse", 0.5}};
  if (list == "/objects")
    return Value::Object{{"name", name},
                         {"shape", "box"},
                         {"min", point(m.x - 0.5, m.y - 0.4, low.z)},
                         {"max", point(m.x + 0.5, m.y + 0.4, low.z + 0.75)}};
  if (list == "/luminaires")
    return Value::Object{
        {"name", name}, {"photometry", "cosine"}, {"flux", 3000}, {"position", point(m.x, m.y, high.z - 0.05)}};
  if (list == "/grids")
    return Value::Object{{"name", name},
                         {"origin", point(low.x, low.y, low.z + 0.8)},
                         {"u", point(high.x - low.x, 0, 0)},
                         {"v", point(0, high.y - low.y, 0)},
                         {"counts", Value::Array{20, 14}},
                         {"normal", Value::Array{0, 0, 1}}};
  if (list == "/views")
    return Value::Object{{"name", name},
                         {"eye", point(low.x + 0.4, low.y + 0.4, low.z + 1.6)},
                         {"target", point(m.x, m.y, low.z + 1)},
                         {"fov", 60},
                         {"width", 400},
                         {"height", 300}};
  if (list == "/observers")
    return Value::Object{{"name", name},
                         {"eye", point(low.x + 0.6, m.y, low.z + 1.2)},
                         {"direction", Value::Array{1, 0, 0}},
                         {"quantity", "ugr"}};
  if (list == "/scenes") return Value::Object{{"name", name}, {"groups", Value::Object{}}};
  if (list == "/requirements") return Value::Object{{"grid", "work plane"}, {"mean_lx", Value::Object{{"min", 500}}}};
  return Value::Object{};
}

}  // namespace goniolux::gui
