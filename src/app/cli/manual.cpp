#include "app/cli/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/cli/help.h"

namespace goniolux::app {
namespace {

/// Text as roff: minus signs that can be copied, no line that is taken for a request.
std::string roff(const std::string& text) {
  std::string result;
  bool lineBegins = true;
  for (const char c : text) {
    if (lineBegins && (c == '.' || c == '\'')) result += "\\&";
    lineBegins = c == '\n';
    if (c == '-') {
      result += "\\-";
    } else if (c == '\\') {
      result += "\\e";
    } else {
      result += c;
    }
  }
  return result;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string head(const std::string& page, const std::string& title) {
  return fmt::format(".TH {} 1 \"\" \"goniolux {}\" \"Goniolux\"\n.SH NAME\n{} \\- {}\n", roff(upper(page)),
                     GONIOLUX_VERSION, roff(page), roff(title));
}

std::string optionList(const std::vector<HelpRow>& rows) {
  std::string text;
  for (const HelpRow& row : rows) {
    const std::size_t begin = row.name.find_first_not_of(' ');
    text += fmt::format(".TP\n.B {}\n{}\n", roff(row.name.substr(begin)), roff(row.text));
  }
  return text;
}

const char* exitStatus =
    ".SH EXIT STATUS\n.TP\n.B 0\ndone\n.TP\n.B 1\na requirement failed, or a value has changed (verify)\n.TP\n.B "
    "2\nbad "
    "input or usage; nothing was written\n.TP\n.B 3\ncould not finish; what was done is kept\n";

}  // namespace

std::string programManual() {
  std::string text = head("goniolux", "lighting-design analysis in which every number has an interval that holds");
  text +=
      ".SH SYNOPSIS\n.B goniolux\n.I VERB INPUT\n[options]\n.SH DESCRIPTION\n"
      "Calculates the light in a room: illuminance, glare and photometrically calibrated images, each number with the "
      "half\\-width of its confidence interval. Every verb is one step, which reads files and writes files.\n.SH "
      "VERBS\n";
  for (const pipeline::Stage& stage : pipeline::stages())
    text += fmt::format(".TP\n.BR goniolux\\-{} (1)\n{}\n", roff(stage.name), roff(stage.title));
  text += exitStatus;
  text +=
      ".SH ENVIRONMENT\n.TP\n.B GONIOLUX_DATA\nfolder with luminaires/ and materials/ to look in first\n.TP\n"
      ".B GONIOLUX_PLOT, GONIOLUX_WEASYPRINT, GONIOLUX_PROGRAM\nthe programs that draw, print and calculate for "
      "others, where they are not beside this one or in PATH\n";
  return text;
}

std::string verbManual(const pipeline::Stage& stage) {
  std::string text = head("goniolux-" + stage.name, stage.title);
  const std::string input = stage.inputName.empty() ? "" : " " + stage.inputName + (stage.manyInputs ? "..." : "");
  text += fmt::format(".SH SYNOPSIS\n.B goniolux {}\n.I{}\n[options]\n.SH DESCRIPTION\n{}\n", roff(stage.name),
                      input.empty() ? " \"\"" : roff(input), roff(stage.help.empty() ? stage.title + "." : stage.help));
  text += ".SH OPTIONS\n" + optionList(ownOptionRows(stage)) + optionList(commonOptionRows(stage)) + exitStatus;
  return text + ".SH SEE ALSO\n.BR goniolux (1)\n";
}

}  // namespace goniolux::app
