// PropertyPanel: the selected entry of the project as a form, made from the format's tables. Several entries of one
// kind are edited together, by the keys that all of them have.
#pragma once

#include <QScrollArea>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/document/checked_project.h"
#include "app/gui/document/document.h"
#include "app/gui/forms/field.h"

class QVBoxLayout;

namespace goniolux::gui {

class PropertyPanel final : public QScrollArea {
  Q_OBJECT
 public:
  PropertyPanel(Document& document, const ProjectChecker& checker, QWidget* parent = nullptr);

  void showEntries(const std::vector<std::string>& pointers);
  /// The field of a key of the shown entry ("array/counts" for nested ones); null when there is none.
  [[nodiscard]] Field* field(const QString& key) const;

 private:
  void refresh();
  void build();
  /// What all shown entries have: null where they are of several kinds, or of one without a form.
  [[nodiscard]] std::shared_ptr<const project::Section> commonSection() const;
  void addSection(const project::Section& section, const std::string& inside, QVBoxLayout* into);
  void fill();
  void showProblems();
  void apply(const std::string& inside, const Field& field, const std::optional<core::Value>& value);
  [[nodiscard]] std::string structure() const;
  [[nodiscard]] QStringList suggestionsFor(const project::Key& key) const;

  struct Placed {
    std::string inside;  ///< pointer below the entry
    Field* field;
  };
  Document& document_;
  const ProjectChecker& checker_;
  std::vector<std::string> pointers_;
  std::vector<Placed> fields_;
  std::string builtFor_;
};

}  // namespace goniolux::gui
