// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

// What the command line says about words that it does not know.
namespace torsio::cli {

/// Returns `words` with "help twist" as "twist --help".
[[nodiscard]] std::vector<std::string> withHelpAsOption(std::vector<std::string> words);

/// Throws Error{kUsage} where one of `words` (without the program's name) should be a command and is none, or
/// a command is missing: names the commands there, and the one that was probably meant. Otherwise the parser
/// would only report an unexpected word.
void requireKnownCommands(const CLI::App& program, const std::vector<std::string>& words);

/// Describes what the parser refused, with the option that was probably meant. Call after program.parse().
[[nodiscard]] std::string describedParseError(const CLI::App& program, const CLI::ParseError& error);

}  // namespace torsio::cli
