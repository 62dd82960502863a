// Reading: what the readers of a project's sections share: the diagnostics, the units, and the files that the project
// names. One object per readProject; not thread safe.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "core/document.h"
#include "photometry/photometric_file.h"
#include "project/project.h"

namespace goniolux::project {

/// The program's own folder of a kind of file, looked in when a file is not in the project's folder.
enum class Library { none, luminaires, materials };

class Reading {
 public:
  explicit Reading(std::filesystem::path folder) : folder_(std::move(folder)) {}

  core::Diagnostics diagnostics;
  double metresPerUnit = 1;

  /// An error at a value: "KEY is wrong; what to do".
  void error(const core::Value& at, std::string rule, std::string message) {
    diagnostics.error(at.position(), std::move(rule), std::move(message));
  }
  void warning(const core::Value& at, std::string rule, std::string message) {
    diagnostics.warning(at.position(), std::move(rule), std::move(message));
  }
  /// The format has it, this version does not.
  void notSupported(const core::SourcePosition& at, const std::string& what) {
    diagnostics.error(at, "not-supported", "not supported yet: " + what);
  }

  /// The path of the file that `name` (a string value) names, read and counted among the project's inputs; an error
  /// with the search order when there is none.
  std::optional<std::string> file(const core::Value& name, Library library, const std::string& hint = {});
  /// A photometric file, read once however many luminaires use it; nullptr after an error.
  const photometry::PhotometricFile* photometricFile(const std::string& path);
  /// Takes over the errors of a reader that threw.
  void adopt(const core::InputError& error) { diagnostics.append(error.diagnostics()); }

  void addInput(const std::string& name, const std::string& bytes);
  [[nodiscard]] const std::vector<InputFile>& inputs() const { return inputs_; }

 private:
  std::filesystem::path folder_;
  std::vector<InputFile> inputs_;
  std::map<std::string, std::optional<photometry::PhotometricFile>> photometry_;
};

/// Folders that may hold the program's luminaires/ and materials/, best first: GONIOLUX_DATA, beside the installed
/// program, the source tree.
std::vector<std::filesystem::path> programDataFolders();

}  // namespace goniolux::project
