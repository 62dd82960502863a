// docs/validation.md, written from the cases that were calculated.
#pragma once

#include <string>
#include <vector>

#include "validation/case.h"

namespace goniolux::validation {

/// A case's part of the page: its row of the summary and its table.
struct PagePart {
  std::string id;
  std::string summary;  ///< a row, without line end
  std::string table;    ///< heading, text and table
};

PagePart partOf(const Case& of, const std::vector<Number>& numbers);
/// The part of a case that was not calculated now, as it stands in `page`; empty strings where it does not.
PagePart partFrom(const std::string& page, const std::string& id);

/// The part of a case that takes minutes and has never been calculated: a row that says so.
PagePart partNotCalculated(const Case& of);

/// `parts`: of every case of every section, in their order.
std::string validationPage(const std::vector<Section>& sections, const std::vector<std::vector<PagePart>>& parts);

/// The first place where the two pages differ by more than chance explains: everything must be equal but for numbers
/// with half-widths and what follows from them; such numbers must agree within both half-widths. Empty: none.
std::string firstDifference(const std::string& written, const std::string& page);

}  // namespace goniolux::validation
