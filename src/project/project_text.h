// ProjectText: a project file as text that entries are added to, so that comments and layout of the rest stay.
#pragma once

#include <string>

#include "core/document.h"

namespace goniolux::project {

class ProjectText {
 public:
  /// `text` is valid JSON with comments; `fileName` for messages.
  ProjectText(std::string text, std::string fileName);

  /// Appends to the list under `key` of the project. Throws core::InputError when there is no such list.
  void appendTo(const std::string& key, const core::Value& entry);
  /// Adds a member to the object under `key`, which is made when the project has none.
  void addMember(const std::string& key, const std::string& name, const core::Value& value);
  /// Replaces a value that was read from this text (the latest root()).
  void replace(const core::Value& old, const core::Value& value);
  /// Appends to a list, or adds a member to an object, that was read from this text (the latest root()).
  void append(const core::Value& list, const core::Value& entry);
  void add(const core::Value& object, const std::string& key, const core::Value& value);
  /// Takes an entry out of a list or a member out of an object, with the comma that belongs to it; comments stay.
  void remove(const core::Value& container, std::size_t index);

  /// The text as it is now, parsed; positions belong to it.
  [[nodiscard]] const core::Value& root() const { return root_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void parse();
  [[nodiscard]] std::size_t offsetOf(const core::Value& value) const;
  [[nodiscard]] std::size_t offsetOf(const core::SourcePosition& position) const;
  /// One past the end of any value.
  [[nodiscard]] std::size_t endOfValue(std::size_t begin) const;
  /// The first place from `at` on that is neither blank nor comment.
  [[nodiscard]] std::size_t skipBlanks(std::size_t at) const;
  /// One past the end of the list, object or text that begins at `begin`.
  [[nodiscard]] std::size_t endOf(std::size_t begin) const;
  void insertBeforeEnd(const core::Value& container, bool isEmpty, const std::string& entry);

  std::string text_, file_;
  core::Value root_;
};

}  // namespace goniolux::project
