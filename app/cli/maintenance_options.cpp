// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/maintenance_options.h"

#include <iostream>

#include <CLI/CLI.hpp>

#include "app/cli/options.h"
#include "app/cli/terminal.h"
#include "app/services/access/first_run.h"
#include "db/connection/locator.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

constexpr int kLastDescriptor = 1 << 16;

std::function<std::string()> secretOf(int descriptor, const std::string& login) {
  return [descriptor, login] {
    return descriptor >= 0 ? secretFrom(descriptor) : typedSecret("Password of " + login + ": ");
  };
}

}  // namespace

void say(const Text& sentence) {
  std::cerr << "torsio: " << sentence.str() << "\n";
}

CLI::Option* addSignIn(CLI::App& command, MaintenanceOptions& options, const char* loginOption) {
  CLI::Option* login = command.add_option(loginOption, options.login, "Signs in to the record as this user");
  command
      .add_option("--password-fd", options.passwordDescriptor,
                  "Reads the password from this file descriptor instead of asking for it")
      ->check(CLI::Range(0, kLastDescriptor))
      ->needs(login);
  return login;
}

void addMaintenanceOptions(CLI::App& command, MaintenanceOptions& options) {
  CLI::Option* login = addSignIn(command, options, "--as");
  command.add_flag("--as-system", options.asSystem, "Without signing in, as the owner of the record's file")
      ->excludes(login);
}

void addSecondPerson(CLI::App& command, MaintenanceOptions& options) {
  CLI::Option* login =
      command.add_option("--with", options.secondLogin, "The second person, if the centre requires two")
          ->needs("--as");
  command
      .add_option("--with-password-fd", options.secondDescriptor,
                  "Reads that person's password from this file descriptor")
      ->check(CLI::Range(0, kLastDescriptor))
      ->needs(login);
}

Maintainer MaintenanceOptions::maintainer() const {
  return {.login = login,
          .password = secretOf(passwordDescriptor, login),
          .secondLogin = secondLogin,
          .secondPassword = secretOf(secondDescriptor, secondLogin),
          .systemAccount = asSystem ? systemAccount() : "",
          .ownsFile = ownsFile,
          .tell = say};
}

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
    refuseUsage("a file has no password of a server", address, "Leave --ask-server-password out");
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
