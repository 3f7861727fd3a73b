// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/cli/terminal.h"
#include "app/connectors/xapi/learning_records.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

struct XapiArguments {
  DatabaseOption database;
  LrsSettings settings;
  bool on = false;
  bool off = false;
  std::string user;
  int secretDescriptor = -1;
  bool drop = false;
  MaintenanceOptions maintenance;
  bool json = false;
};

void printStatus(const LearningRecordsView& view, bool json) {
  if (json) {
    nlohmann::ordered_json dead = nlohmann::ordered_json::array();
    for (const auto& [event, answer] : view.dead) {
      dead.push_back({{"kind", storedText(event.kind)},
                      {"object", event.objectId},
                      {"tries", event.tries},
                      {"answer", answer.str()}});
    }
    printJson(nlohmann::ordered_json{{"on", view.settings.on},
                                     {"endpoint", view.settings.endpoint},
                                     {"home_page", view.settings.homePage},
                                     {"key_at_this_station", view.hasKey},
                                     {"waiting", view.counts.waiting},
                                     {"delivered", view.counts.delivered},
                                     {"refused", view.counts.dead},
                                     {"trouble", view.trouble.str()},
                                     {"dead", std::move(dead)}});
    return;
  }
  std::cout << "Sending: " << (view.settings.on ? "on, to " + view.settings.endpoint : std::string("off"))
            << "\nKey at this station: " << (view.hasKey ? "yes" : "no")
            << "\nWaiting: " << view.counts.waiting << "\nDelivered: " << view.counts.delivered
            << "\nRefused for good: " << view.counts.dead << "\n";
  if (!view.trouble.empty()) {
    std::cout << "Last trouble: " << view.trouble.str() << "\n";
  }
  for (const auto& [event, answer] : view.dead) {
    std::cout << storedText(event.kind) << " " << event.objectId << ": " << answer.str() << "\n";
  }
}

void status(const XapiArguments& given) {
  MaintenanceDesk desk(given.maintenance.maintainer(), given.database.locator());
  printStatus(learningRecords(desk.session()), given.json);
}

void set(const XapiArguments& given) {
  MaintenanceDesk desk(given.maintenance.maintainer(), given.database.locator());
  LrsSettings settings = lrsSettings(desk.session());
  settings.endpoint = given.settings.endpoint.empty() ? settings.endpoint : given.settings.endpoint;
  settings.homePage = given.settings.homePage.empty() ? settings.homePage : given.settings.homePage;
  settings.on = (settings.on || given.on) && !given.off;
  setLrsSettings(desk.session(), settings);
  printStatus(learningRecords(desk.session()), given.json);
}

void setKey(const XapiArguments& given) {
  LrsKey key{given.user, {}};
  if (!key.user.empty()) {
    key.secret = given.secretDescriptor >= 0
                     ? secretFrom(given.secretDescriptor)
                     : typedSecret("Secret of " + key.user + " at the learning record store: ");
  }
  setStationLrsKey(key);
  std::cout << (key.user.empty() ? "This station has no key any more and sends nothing.\n"
                                 : "Kept for this account only; this station sends from now on.\n");
}

void send(const XapiArguments& given) {
  MaintenanceOptions maintenance = given.maintenance;
  maintenance.asSystem = maintenance.login.empty();
  MaintenanceDesk desk(maintenance.maintainer(), given.database.locator());
  const LrsDelivery done = sendLearningRecords(desk.session());
  if (given.json) {
    printJson(nlohmann::ordered_json{{"delivered", done.delivered},
                                     {"refused", done.dead},
                                     {"later", done.later},
                                     {"nothing_to_tell", done.forgotten},
                                     {"stopped", done.stopped}});
  } else {
    std::cout << "Delivered " << done.delivered << ", refused for good " << done.dead << ", later "
              << done.later << "\n";
  }
  if (done.stopped) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::verbatim("the learning record store does not accept anything now"), Text(),
                Text::verbatim("The rest is kept; torsio xapi status shows why"));
  }
}

void retry(const XapiArguments& given) {
  MaintenanceDesk desk(given.maintenance.maintainer(), given.database.locator());
  const std::int64_t count =
      given.drop ? dropLearningRecords(desk.session()) : retryLearningRecords(desk.session());
  std::cout << count << (given.drop ? " given up\n" : " will be tried again\n");
}

}  // namespace

void addXapi(CLI::App& program) {
  auto arguments = std::make_shared<XapiArguments>();
  CLI::App* xapi = program.add_subcommand("xapi", "Learning records for the learning system of the centre");
  xapi->require_subcommand(1);
  const auto add = [&](const char* name, const char* what, bool signIn) {
    CLI::App* command = xapi->add_subcommand(name, what);
    addDatabaseOption(*command, arguments->database);
    CLI::Option* login = addSignIn(*command, arguments->maintenance, "--login");
    if (signIn) {
      login->required();
    }
    command->add_flag("--json", arguments->json, "Print JSON");
    return command;
  };
  add("status", "Shows what is pending, delivered, and refused and why", true)->callback([arguments] {
    status(*arguments);
  });
  CLI::App* command = add("set", "Sets where learning records go, and turns them on or off", true);
  command->add_option("--endpoint", arguments->settings.endpoint, "Address of the learning record store");
  command->add_option("--home-page", arguments->settings.homePage,
                      "Address of the system to which the accounts of trainees belong");
  CLI::Option* on = command->add_flag("--on", arguments->on, "Stores and sends events from now on");
  command->add_flag("--off", arguments->off, "Stores and sends nothing")->excludes(on);
  command->callback([arguments] { set(*arguments); });

  command = xapi->add_subcommand("key", "Sets the key by which this station signs in to the store");
  CLI::Option* user = command->add_option("--user", arguments->user, "Name of the key; empty: removes it");
  command
      ->add_option("--secret-fd", arguments->secretDescriptor,
                   "Reads the secret from this file descriptor instead of asking for it")
      ->needs(user);
  command->callback([arguments] { setKey(*arguments); });

  add("send", "Sends now what is due", false)->callback([arguments] { send(*arguments); });
  command = add("retry", "Retries at once what is pending or was refused for good", true);
  command->add_flag("--drop", arguments->drop, "Instead drops what was refused for good");
  command->callback([arguments] { retry(*arguments); });
}

}  // namespace torsio::cli
