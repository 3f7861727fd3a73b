// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace torsio::cli {

/// The --database option as typed.
struct DatabaseOption {
  std::string address = "torsio.sqlite";
  bool askPassword = false;

  /// Returns the locator; asks for the server's password at the terminal, once, if requested by the option.
  [[nodiscard]] std::string locator() const;

 private:
  mutable std::string asked_;  // with the typed password
};

/// Adds --database and --ask-server-password. Rejects a password in the address, since every user of the
/// machine can read the command line.
CLI::Option* addDatabaseOption(CLI::App& command, DatabaseOption& option);

/// Adds an argument that is such an address.
CLI::Option* addDatabaseArgument(CLI::App& command, const std::string& name, std::string& address,
                                 const std::string& description);

}  // namespace torsio::cli
