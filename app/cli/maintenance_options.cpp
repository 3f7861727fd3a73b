// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/maintenance_options.h"

#include <iostream>

#include <CLI/CLI.hpp>

#include "app/cli/terminal.h"

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

}  // namespace torsio::cli
