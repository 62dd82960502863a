// The sections of the report, each as HTML.
#pragma once

#include <string>

#include "report/report.h"
#include "report/words.h"

namespace goniolux::report {

std::string coverSection(const Report& report, const Words& words);
std::string summarySection(const Report& report, const Words& words);
std::string luminaireSections(const Report& report, const Words& words);
std::string contributionSection(const Report& report, const Words& words);
std::string planSection(const Report& report, const Words& words);
std::string gridSections(const Report& report, const Words& words);
std::string renderingSection(const Report& report, const Words& words);
std::string basisSection(const Report& report, const Words& words);

/// "<img …>" with the picture in it.
std::string imageTag(const Picture& picture, const char* cssClass);

}  // namespace goniolux::report
