// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/installation/unattended_setup.h"
#include "assessment/results/number_format.h"

namespace torsio::cli {

namespace {

struct SetupArguments {
  DatabaseOption database;
  std::string answers;
  bool check = false;
  bool json = false;
};

void printJsonOf(const SetUpRecord& done) {
  nlohmann::ordered_json accounts = nlohmann::ordered_json::array();
  for (const StartAccount& one : done.accounts) {
    accounts.push_back({{"login", one.login},
                        {"role", one.role},
                        {"person_code", one.personCode},
                        {"start_password", writtenPassword(one)},
                        {"awaits_second_person", one.part == PasswordPart::kFirstHalf}});
  }
  printJson({{"centre", done.centre},
             {"code", done.code},
             {"administrator", done.administrator},
             {"link", done.link},
             {"link_expires", done.link.empty() ? "" : formatUtc(done.linkExpiresUtc_us)},
             {"trainees", done.trainees},
             {"raters", done.raters},
             {"accounts", accounts}});
}

void print(const SetUpRecord& done) {
  std::cout << "Set up: " << done.centre << " (" << done.code << ")\n";
  if (done.trainees + done.raters > 0) {
    std::cout << "Added from the rosters: " << done.trainees << " trainees, " << done.raters << " raters\n";
  }
  if (!done.link.empty()) {
    std::cout << "Link with which " << done.administrator << " chooses a password, once, until "
              << formatUtc(done.linkExpiresUtc_us) << ":\n"
              << done.link << "\n";
  }
  if (!done.accounts.empty()) {
    std::cout << "Start passwords, shown only now:\n";
  }
  for (const StartAccount& one : done.accounts) {
    std::cout << one.login << "  " << writtenPassword(one) << "  " << one.role;
    if (one.part == PasswordPart::kFirstHalf) {
      std::cout << "; first half: another administrator confirms the request and gets the second";
    }
    std::cout << "\n";
  }
}

void setUp(const SetupArguments& arguments) {
  if (arguments.check) {
    tryAnswers(arguments.answers);
    std::cout << arguments.answers << " can be used\n";
    return;
  }
  const SetUpRecord done = setUpRecord(arguments.database.locator(), arguments.answers);
  if (arguments.json) {
    printJsonOf(done);
  } else {
    print(done);
  }
}

}  // namespace

void addSetup(CLI::App& program) {
  auto arguments = std::make_shared<SetupArguments>();
  CLI::App* command =
      program.add_subcommand("setup", "Sets up a record from a file of answers, without the window");
  addDatabaseOption(*command, arguments->database);
  command->add_option("--answers", arguments->answers, "File with the answers")->required();
  CLI::Option* check =
      command->add_flag("--check", arguments->check, "Only tries the answers; opens and writes no record");
  command->add_flag("--json", arguments->json, "Print JSON")->excludes(check);
  command->callback([arguments] { setUp(*arguments); });
}

}  // namespace torsio::cli
