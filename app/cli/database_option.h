// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace torsio::cli {

/// The record that a command works with, as somebody wrote it.
struct DatabaseOption {
  std::string address = "torsio.sqlite";
  bool askPassword = false;

  /// The locator; asks at the terminal, once, for the password of the server where the command was told to.
  [[nodiscard]] std::string locator() const;

 private:
  mutable std::string asked_;  // with the password that was typed
};

/// Adds --database and --ask-server-password. A password within an address is refused, since every user of
/// the machine sees the command line.
CLI::Option* addDatabaseOption(CLI::App& command, DatabaseOption& option);

/// Adds an argument that is such an address.
CLI::Option* addDatabaseArgument(CLI::App& command, const std::string& name, std::string& address,
                                 const std::string& description);

}  // namespace torsio::cli
