// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/usage_errors.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/cli/options.h"
#include "app/services/base/nearest_name.h"

namespace torsio::cli {

namespace {

constexpr std::string_view kNotConverted = "Could not convert: ";  // words of the parser

bool isOption(const std::string& word) {
  return word.size() > 1 && word[0] == '-';
}

std::vector<std::string> commandsOf(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_name().empty()) {
      names.push_back(command->get_name());
    }
  }
  return names;
}

const CLI::App* commandNamed(const CLI::App& program, const std::string& name) {
  const auto found = program.get_subcommands([&](const CLI::App* one) { return one->get_name() == name; });
  return name.empty() || found.empty() ? nullptr : found.front();
}

/// "torsio export", the words that lead to a command.
std::string pathOf(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : pathOf(*parent) + " " + command.get_name();
}

std::string suggestion(const std::string& nearest) {
  return nearest.empty() ? "" : "Did you mean '" + nearest + "'? ";
}

[[noreturn]] void refuseCommand(const CLI::App& at, const std::string& word) {
  const std::vector<std::string> names = commandsOf(at);
  refuseUsage(word.empty() ? "one of its commands is missing" : "no such command",
              word.empty() ? pathOf(at) : word,
              suggestion(word.empty() ? "" : nearestOf(names, word)) + "Commands" +
                  (at.get_parent() == nullptr ? "" : " of '" + pathOf(at) + "'") + ": " + joined(names));
}

/// Returns the last command that was given.
const CLI::App& givenCommand(const CLI::App& program) {
  const auto given = program.get_subcommands();
  return given.empty() ? program : givenCommand(*given.front());
}

/// Of the command and its groups of options.
std::vector<std::string> optionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* group :
       command.get_subcommands([](const CLI::App* one) { return one->get_name().empty(); })) {
    const std::vector<std::string> own = optionsOf(*group);
    names.insert(names.end(), own.begin(), own.end());
  }
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

/// Replaces "--size: 1 required TEXT missing".
std::string withPlainMissing(const std::string& said) {
  const std::size_t colon = said.find(": 1 required ");
  return colon != std::string::npos && said.ends_with(" missing")
             ? said.substr(0, colon) + ": the value is missing"
             : said;
}

}  // namespace

std::vector<std::string> withHelpAsOption(std::vector<std::string> words) {
  if (!words.empty() && words.front() == "help") {
    std::rotate(words.begin(), words.begin() + 1, words.end());
    words.back() = "--help";
  }
  return words;
}

void requireKnownCommands(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* at = &program;
  const auto helps = [](const std::string& word) { return word == "--help" || word == "-h"; };
  for (const std::string& word : words) {
    const CLI::App* next = commandNamed(*at, word);
    if (next == nullptr) {
      // The program itself has options; a command of commands has none but help.
      if ((at == &program && isOption(word)) || helps(word)) {
        return;
      }
      if (!commandsOf(*at).empty() && isOption(word)) {
        refuseUsage("no such command: options come after one", word,
                    "Commands of '" + pathOf(*at) + "': " + joined(commandsOf(*at)));
      }
      if (!commandsOf(*at).empty()) {
        refuseCommand(*at, word);
      }
      return;
    }
    at = next;
  }
  if (at != &program && !commandsOf(*at).empty()) {
    refuseCommand(*at, {});
  }
}

std::string describedParseError(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& command = givenCommand(program);
  const std::string help = ". Run '" + pathOf(command) + " --help' for its options";
  const std::string said = error.what();
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr && said.starts_with(kNotConverted)) {
    const std::size_t equals = said.find(" = ");
    return said.substr(kNotConverted.size(), equals - kNotConverted.size()) + ": '" +
           (equals == std::string::npos ? "" : said.substr(equals + 3)) + "' is not a number" + help;
  }
  const std::vector<std::string> extra = program.remaining(true);
  if (extra.empty()) {  // else a word that is not known explains what is missing
    return withPlainMissing(said) + help;
  }
  const std::string first = extra.empty() ? std::string() : extra.front().substr(0, extra.front().find('='));
  const std::string nearest = isOption(first) ? nearestOf(optionsOf(command), first) : std::string();
  return (isOption(first) ? first : joined(extra)) + ": " +
         (isOption(first) ? "'" + pathOf(command) + "' has no option of this name"
                          : "'" + pathOf(command) + "' takes no further words") +
         (nearest.empty() ? "" : ". Did you mean '" + nearest + "'?") + (nearest.empty() ? help : "");
}

}  // namespace torsio::cli
