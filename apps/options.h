// Options of the command line, parsed by our own rules and refused in one line.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "brdf/levelling.h"
#include "evaluation/axis.h"
#include "evaluation/readers/height_reader.h"
#include "evaluation/writers/output_file.h"

namespace apps {

/// An option whose text goes through `parse(option name, text)` into `target`.
template <class T, class Parse>
CLI::Option* add_parsed(CLI::App* app, const std::string& name, T& target, Parse parse,
                        const std::string& help, const std::string& value_name) {
  return app
      ->add_option_function<std::string>(
          name, [&target, parse, name](const std::string& text) { target = parse(name, text); },
          help)
      ->type_name(value_name);
}

template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

/// An option with named values; any other is refused with the names there are.
template <class T, class Target>
CLI::Option* add_choice(CLI::App* app, const std::string& name, Target& target,
                        const Choices<T>& choices, const std::string& help) {
  std::string names;
  for (const auto& [choice, value] : choices) names.append(names.empty() ? "" : "|").append(choice);
  return add_parsed(
      app, name, target,
      [choices, names](const std::string& option, const std::string& text) {
        for (const auto& [choice, value] : choices)
          if (choice == text) return value;
        throw brdf::Error(brdf::Errc::invalid_argument,
                          option + " " + text + ": must be one of " + names);
      },
      help, names);
}

/// The name of a value.
template <class T>
std::string name_in(const Choices<T>& choices, T value) {
  for (const auto& [name, choice] : choices)
    if (choice == value) return name;
  return "?";
}

/// A file name from the command line; one that looks like an option is refused.
std::string parse_path(const std::string& option, const std::string& text);

/// A height file and how it is prepared: the options that `info` and `sweep` share.
struct HeightOptions {
  std::string file;
  evaluation::HeightChoice choice;
  int reduction = 1;
  std::optional<brdf::Level> level;  ///< none, unless a preset says otherwise

  void add_to(CLI::App* app);
  /// All but the file.
  void add_preparation_to(CLI::App* app);
  /// What is subtracted, for sidecars.
  std::string level_name() const;
  /// Grid and preparation of the heights as they were read, for sidecars.
  evaluation::Json parameters(const brdf::HeightField& field) const;
  /// Reads the file, reduces it, then levels it.
  evaluation::HeightFile read() const;
};

extern const Choices<brdf::Level> level_choices;
extern const Choices<evaluation::MissingHeights> missing_choices;

/// An option of the command line, and whether it was given.
using Given = std::pair<bool, const char*>;

/// Refuses the first of the options that was given: "--sigma has no meaning for " + what.
void require_not_given(std::initializer_list<Given> options, const std::string& what);

/// Adds -o; required or not as the caller says with ->required().
CLI::Option* add_output(CLI::App* app, std::string& output, const std::string& help);

/// Refuses an output, or its sidecar, that is the input or the input's sidecar.
void require_other_file(const std::string& output, const std::string& input);

/// Refuses a picture that is the output; either may be empty.
void require_apart(const std::string& output, const std::string& picture);

/// What every sidecar begins with.
evaluation::Json sidecar_head(const std::string& command, const std::string& input,
                              const std::string& input_sha256);

/// First, last, step and count of an axis.
evaluation::Json axis_json(const evaluation::Axis& axis);

}  // namespace apps
