// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/maintenance/maintenance_desk.h"
#include "sim/core/text.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace torsio::cli {

/// Options that identify the maintainer of a record.
struct MaintenanceOptions {
  std::string login{};
  int passwordDescriptor = -1;  ///< -1: ask at the terminal
  std::string secondLogin{};
  int secondDescriptor = -1;
  bool asSystem = false;

  [[nodiscard]] Maintainer maintainer() const;
};

/// Prints a line to standard error.
void say(const Text& sentence);

/// Adds the sign-in option `login`, and --password-fd.
CLI::Option* addSignIn(CLI::App& command, MaintenanceOptions& options, const char* login);
/// Adds --as, --password-fd and --as-system and, for acts that need two people, --with and
/// --with-password-fd.
void addMaintenanceOptions(CLI::App& command, MaintenanceOptions& options);
void addSecondPerson(CLI::App& command, MaintenanceOptions& options);

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
