// shedlight completion: the words that a shell completes.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/options.h"

namespace apps {
namespace {

enum class Shell { bash };
const Choices<Shell> shell_choices{{"bash", Shell::bash}};

/// All names of the options of a command, as they are typed.
std::string option_words(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) words += " --" + name;
    for (const std::string& name : option->get_snames()) words += " -" + name;
  }
  return words;
}

/// One branch for each option with named values: "a|b|c" is how add_choice writes them.
std::string choice_branches(const CLI::App& command) {
  std::string branches;
  for (const CLI::Option* option : command.get_options()) {
    std::string values = option->get_type_name();
    if (option->get_positional() || values.find('|') == std::string::npos) continue;
    for (char& c : values)
      if (c == '|') c = ' ';
    for (const std::string& name : option->get_lnames())
      branches += fmt::format("    {}:--{}) words='{}' ;;\n", command.get_name(), name, values);
  }
  return branches;
}

std::string bash_completion(const CLI::App& app) {
  std::string commands, options, choices;
  for (const CLI::App* command : app.get_subcommands({})) {
    commands += " " + command->get_name();
    options += fmt::format("    {}) words='{}' ;;\n", command->get_name(), option_words(*command));
    choices += choice_branches(*command);
  }
  return fmt::format(
      "# bash completion of shedlight; made by `shedlight completion bash`.\n"
      "_shedlight() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]}} words=\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    mapfile -t COMPREPLY < <(compgen -W '--help --version{}' -- \"$current\")\n"
      "    return\n"
      "  fi\n"
      "  case $command:${{COMP_WORDS[COMP_CWORD - 1]}} in\n"
      "{}"
      "  esac\n"
      "  if [[ -z $words && $current == -* ]]; then\n"
      "    case $command in\n"
      "{}"
      "    esac\n"
      "  fi\n"
      "  # Nothing fits: the shell's own completion of files.\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
      "}}\n"
      "complete -o default -F _shedlight shedlight\n",
      commands, choices, options);
}

}  // namespace

void add_completion(CLI::App& app) {
  auto shell = std::make_shared<Shell>(Shell::bash);
  CLI::App* completion = app.add_subcommand("completion", "Print the completion of a shell");
  completion->footer(
      "Example:\n  shedlight completion bash > "
      "~/.local/share/bash-completion/completions/shedlight");
  add_choice(completion, "shell", *shell, shell_choices, "the shell")->required();
  completion->callback([shell, &app] { print(bash_completion(app)); });
}

}  // namespace apps
