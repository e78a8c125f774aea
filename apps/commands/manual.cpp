// shedlight manual: the manual page, made of what the options say of themselves.
#include <fmt/format.h>

#include <string>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/version.h"

namespace apps {
namespace {

/// Text as roff shows it: no escapes, no requests, hyphens that can be copied.
std::string roff(const std::string& text) {
  std::string result;
  bool at_line_start = true;
  for (const char c : text) {
    if (at_line_start && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\(rs";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
    at_line_start = c == '\n';
  }
  return result;
}

std::string option_entry(const CLI::Option& option) {
  const std::string value = option.get_items_expected_max() > 0 ? option.get_type_name() : "";
  return fmt::format(
      ".TP\n\\fB{}\\fR{}\n{}\n", roff(option.get_name(option.get_positional(), true)),
      value.empty() ? "" : " \\fI" + roff(value) + "\\fR", roff(option.get_description()));
}

std::string command_section(const CLI::App& command) {
  std::string text =
      fmt::format(".SS {}\n{}.\n", command.get_name(), roff(command.get_description()));
  for (const CLI::Option* option : command.get_options()) text += option_entry(*option);
  return text + ".PP\n.nf\n" + roff(command.get_footer()) + "\n.fi\n";
}

std::string manual(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH SHEDLIGHT 1 \"\" \"shedlight {}\" \"User Commands\"\n"
      ".SH NAME\nshedlight \\- diffraction from measured and synthetic gratings\n"
      ".SH SYNOPSIS\n\\fBshedlight\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n"
      ".SH DESCRIPTION\n{}\n.PP\n"
      "Every quantity carries its unit (65um, 75deg); ranges are start:stop:step. Beside every\n"
      "output lies \\fIOUTPUT\\fR.json, which says how it was made and how wrong it may be.\n"
      ".SH COMMANDS\n",
      version, roff(app.get_description()));
  for (const CLI::App* command : app.get_subcommands({})) text += command_section(*command);
  return text +
         ".SH EXIT STATUS\n"
         "0 done; 1 a validation failed; 2 wrong usage; 3 bad input; 4 an output could not be\n"
         "written; 5 accuracy or physics not attainable; 6 over a limit of memory or time;\n"
         "70 internal error.\n";
}

}  // namespace

void add_manual(CLI::App& app) {
  CLI::App* command = app.add_subcommand("manual", "Print the manual page");
  command->footer("Example:\n  shedlight manual | man -l -");
  command->callback([&app] { print(manual(app)); });
}

}  // namespace apps
