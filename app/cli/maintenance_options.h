// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/maintenance/maintainer.h"
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

}  // namespace torsio::cli
