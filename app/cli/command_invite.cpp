// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/services/access/access_service.h"
#include "app/services/access/invitations.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

struct InviteArguments {
  DatabaseOption database;
  std::string address;
  std::string revoke;
  std::vector<std::string> logins;
  MaintenanceOptions maintenance;
};

std::vector<UserId> idsOf(SessionContext& session, const std::vector<std::string>& logins) {
  const std::vector<UserAccount> accounts = users(session);
  std::vector<UserId> ids;
  for (const std::string& login : logins) {
    const auto found = std::find_if(accounts.begin(), accounts.end(),
                                    [&](const UserAccount& user) { return user.login == login; });
    if (found == accounts.end()) {
      refuseParameter(Text::verbatim("there is no such user"), login,
                      Text::verbatim("Write the sign-in name as the list of users shows it"));
    }
    ids.push_back(found->id);
  }
  return ids;
}

void inviteUsers(const InviteArguments& arguments) {
  MaintenanceDesk desk(arguments.maintenance.maintainer(), arguments.database.locator());
  const std::vector<UserId> ids = idsOf(desk.session(), arguments.logins);
  if (!arguments.revoke.empty()) {
    std::cout << "Invitations revoked: " << revokeInvitations(desk.session(), ids, arguments.revoke) << "\n";
    return;
  }
  if (!arguments.address.empty()) {
    setBrowserAddress(desk.session(), arguments.address);
  }
  const std::string address = browserAddress(desk.session());
  if (address.empty()) {
    refuseUsage("the address of the review desk is not set", "",
                "Give --address https://..., once; the record remembers it");
  }
  for (const Invitation& one : invite(desk.session(), ids)) {
    std::cout << one.login << "  " << invitationLink(address, one.secret, false) << "\n";
  }
}

}  // namespace

void addInvite(CLI::App& program) {
  auto arguments = std::make_shared<InviteArguments>();
  CLI::App* command =
      program.add_subcommand("invite", "Makes links with which users set a password in a browser");
  addDatabaseOption(*command, arguments->database);
  addSignIn(*command, arguments->maintenance, kLoginOrAs)->required();
  command->add_option("--address", arguments->address,
                      "Address of the review desk for browsers, https://...");
  command->add_option("--revoke", arguments->revoke, "Revokes their links instead, for this reason");
  command->add_option("login", arguments->logins, "Sign-in names")->required();
  command->callback([arguments] { inviteUsers(*arguments); });
}

}  // namespace torsio::cli
