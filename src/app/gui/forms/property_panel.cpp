#include "app/gui/forms/property_panel.h"

#include <QDir>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/document/json_pointer.h"
#include "app/gui/forms/sections.h"
#include "core/document.h"
#include "project/reading.h"
#include "spectrum/cie_data.h"

namespace goniolux::gui {

using core::Value;
using project::Form;

namespace {

/// Lists of entries and the like have panels of their own.
bool isShown(const project::Key& key) {
  return key.form != Form::sections && key.form != Form::objects && key.form != Form::materials;
}

QStringList filesIn(const char* folder, const QStringList& patterns) {
  QStringList names;
  for (const auto& data : project::programDataFolders()) {
    const QDir dir(QString::fromStdString((data / folder).string()));
    names << dir.entryList(patterns, QDir::Files);
  }
  names.removeDuplicates();
  return names;
}

}  // namespace

PropertyPanel::PropertyPanel(Document& document, const ProjectChecker& checker, QWidget* parent)
    : QScrollArea(parent), document_(document), checker_(checker) {
  setObjectName("properties");
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(&document_, &Document::changed, this, &PropertyPanel::refresh);
  connect(&document_, &Document::opened, this, [this] { showEntries({}); });
  connect(&checker_, &ProjectChecker::checked, this, &PropertyPanel::showProblems);
  build();
}

void PropertyPanel::showEntries(const std::vector<std::string>& pointers) {
  pointers_ = pointers;
  refresh();
}

Field* PropertyPanel::field(const QString& key) const {
  const std::string inside = "/" + key.toStdString();
  for (const Placed& placed : fields_)
    if (placed.inside == inside) return placed.field;
  return nullptr;
}

void PropertyPanel::refresh() {
  if (structure() != builtFor_) build();
  fill();
  showProblems();
}

/// What decides which fields there are: the entries, their shape or model, and which parts they have.
std::string PropertyPanel::structure() const {
  std::string text;
  for (const std::string& pointer : pointers_) {
    text += pointer + "\n";
    const Value* value = document_.find(pointer);
    if (value == nullptr || !value->isObject()) continue;
    for (const auto& [key, member] : value->object()) {
      if (key == "shape" || key == "model") text += core::toJson(member);
      if (member.isObject()) text += key + " ";
    }
  }
  return text + document_.folder().toStdString();
}

void PropertyPanel::build() {
  builtFor_ = structure();
  fields_.clear();
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(10);
  const auto section = commonSection();
  if (section) {
    const Value* name = document_.find(under(pointers_.front(), "name"));
    QString title = name != nullptr && name->isString() ? QString::fromStdString(name->string())
                                                        : QString::fromStdString(lastStep(pointers_.front()));
    if (pointers_.front().empty()) title = document_.title();
    if (pointers_.size() > 1) title = tr("%n entries", nullptr, static_cast<int>(pointers_.size()));
    auto* heading = new QLabel("<b>" + title.toHtmlEscaped() + "</b><br><small>" +
                               QString::fromStdString(section->title).toHtmlEscaped() + "</small>");
    heading->setWordWrap(true);
    layout->addWidget(heading);
    addSection(*section, "", layout);
  } else {
    auto* hint = new QLabel(pointers_.empty() ? tr("Select something in the project or in the 3-D view.")
                            : pointers_.size() == 1
                                ? tr("This entry is edited in the text of the project.")
                                : tr("%n entries of several kinds: they are moved, turned, copied and removed "
                                     "together. Select entries of one kind to edit their values.",
                                     nullptr, static_cast<int>(pointers_.size())));
    hint->setWordWrap(true);
    hint->setEnabled(false);
    layout->addWidget(hint);
  }
  layout->addStretch(1);
  setWidget(page);
}

std::shared_ptr<const project::Section> PropertyPanel::commonSection() const {
  if (pointers_.empty()) return nullptr;
  const auto first = sectionAt(document_.root(), pointers_.front());
  if (!first || pointers_.size() == 1) return first;
  auto common = std::make_shared<project::Section>(*first);
  for (const std::string& pointer : pointers_) {
    if (parentOf(pointer) != parentOf(pointers_.front())) return nullptr;
    const auto section = sectionAt(document_.root(), pointer);
    if (!section) return nullptr;
    // A box and a sphere share their material, not their corners.
    std::erase_if(common->keys, [&](const project::Key& key) {
      const project::Key* other = section->find(key.name);
      return key.name == "name" || other == nullptr || other->form != key.form || other->section != key.section;
    });
  }
  return common;
}

void PropertyPanel::addSection(const project::Section& section, const std::string& inside, QVBoxLayout* into) {
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(7);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  into->addLayout(form);
  const Value* units = document_.find("/units");
  const std::string projectUnits = units != nullptr && units->isString() ? units->string() : "m";
  for (const project::Key& key : section.keys) {
    if (!isShown(key)) continue;
    const std::string place = under(inside, key.name);
    const Value* value = document_.find(pointers_.front() + place);
    if (key.form == Form::section && key.section != nullptr) {
      // Parts that are not there yet are offered closed; a first value makes them.
      auto* group = new QGroupBox(translatedLabelOf(key.name));
      group->setToolTip(QString::fromStdString(key.help));
      auto* inner = new QVBoxLayout(group);
      inner->setContentsMargins(10, 8, 10, 10);
      auto* body = new QWidget;
      auto* bodyLayout = new QVBoxLayout(body);
      bodyLayout->setContentsMargins(0, 0, 0, 0);
      inner->addWidget(body);
      group->setCheckable(true);
      group->setChecked(value != nullptr);
      body->setVisible(value != nullptr);
      connect(group, &QGroupBox::toggled, body, &QWidget::setVisible);
      addSection(*key.section, place, bodyLayout);
      into->addWidget(group);
      continue;
    }
    auto* field = new Field(key, suggestionsFor(key));
    QString label = translatedLabelOf(key.name);
    const QString unit = QString::fromStdString(unitOf(key, projectUnits));
    if (!unit.isEmpty()) label += " / " + unit;
    auto* words = new QLabel(label);
    words->setToolTip(field->toolTip());
    words->setMinimumWidth(112);
    form->addRow(words, field);
    fields_.push_back({place, field});
    connect(field, &Field::entered, this,
            [this, place, field](const std::optional<Value>& entered) { apply(place, *field, entered); });
  }
}

void PropertyPanel::fill() {
  for (const Placed& placed : fields_) {
    const Value* first = document_.find(pointers_.front() + placed.inside);
    bool differs = false;
    for (const std::string& pointer : pointers_) {
      const Value* other = document_.find(pointer + placed.inside);
      differs = differs || (first == nullptr) != (other == nullptr) ||
                (first != nullptr && core::toJson(*first) != core::toJson(*other));
    }
    placed.field->show(first, differs);
  }
}

void PropertyPanel::showProblems() {
  if (fields_.empty()) return;
  const CheckedProject& checked = *checker_.latest();
  for (const Placed& placed : fields_) {
    QString words;
    for (const core::Diagnostic& d : checked.diagnostics.all()) {
      if (d.severity != core::Severity::error || d.position.line == 0) continue;
      const std::string at = pointerAt(document_.root(), d.position.line, d.position.column);
      const std::string mine = pointers_.front() + placed.inside;
      if (at == mine || at.starts_with(mine + "/")) words = QString::fromStdString(d.message);
    }
    placed.field->setProblem(words);
  }
}

void PropertyPanel::apply(const std::string& inside, const Field& field, const std::optional<Value>& value) {
  const QString words = tr("Change %1").arg(translatedLabelOf(field.key().name));
  document_.edit(words, [&](project::ProjectText& text) {
    for (const std::string& pointer : pointers_) {
      if (value) {
        setIn(text, pointer + inside, *value);
      } else {
        removeIn(text, pointer + inside);
      }
    }
  });
}

QStringList PropertyPanel::suggestionsFor(const project::Key& key) const {
  QStringList names;
  if (key.name == "material") {
    if (const Value* materials = document_.find("/materials"); materials != nullptr && materials->isObject())
      for (const auto& [name, material] : materials->object()) names << QString::fromStdString(name);
  } else if (key.form == Form::photometry) {
    names = filesIn("luminaires", {"*.ies", "*.ldt", "*.xml"});
    for (const std::string& name : project::builtInPhotometry()) names << QString::fromStdString(name);
  } else if (key.form == Form::reflectance) {
    names = filesIn("materials", {"*.spd"});
  } else if (key.form == Form::source) {
    for (const std::string& name : spectrum::illuminantNames()) names << QString::fromStdString(name);
  }
  return names;
}

}  // namespace goniolux::gui
