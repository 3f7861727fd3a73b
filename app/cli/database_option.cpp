// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/database_option.h"

#include <CLI/CLI.hpp>

#include "app/cli/terminal.h"
#include "app/services/access/first_run.h"
#include "db/connection/locator.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

constexpr const char* kWhat = "SQLite file or postgresql://user@host:port/database?sslmode=verify-full";

/// Empty: no password. The command reports other faults of the address.
std::string withoutPassword(const std::string& address) {
  try {
    if (!saysPassword(address)) {
      return {};
    }
  } catch (const Error&) {
    return {};
  }
  return "a password in an address is seen by every user of this machine: leave it out, and write it to "
         "~/.pgpass or a service file, or give --ask-server-password";
}

CLI::Option* checked(CLI::Option* option) {
  return option->check(CLI::Validator(withoutPassword, "", "address"));
}

}  // namespace

std::string DatabaseOption::locator() const {
  if (!askPassword) {
    return address;
  }
  if (!asked_.empty()) {
    return asked_;
  }
  Locator server = parseLocator(address);
  if (server.engine != Engine::kPostgresql) {
    throw Error(ErrorCode::kUsage, Text::verbatim("a file has no password of a server"), address,
                Text::verbatim("Leave --ask-server-password out"));
  }
  server.password = typedSecret("Password of the server at " + server.shown() + ": ");
  asked_ = addressOf(server);
  return asked_;
}

CLI::Option* addDatabaseOption(CLI::App& command, DatabaseOption& option) {
  command.add_flag("--ask-server-password", option.askPassword,
                   "Asks at the terminal for the password of the server");
  return checked(command.add_option("--database", option.address, kWhat))->capture_default_str();
}

CLI::Option* addDatabaseArgument(CLI::App& command, const std::string& name, std::string& address,
                                 const std::string& description) {
  return checked(command.add_option(name, address, description));
}

}  // namespace torsio::cli
