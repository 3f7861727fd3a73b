// SPDX-License-Identifier: GPL-3.0-or-later
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/installation/computer_settings.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

constexpr int kKeyWidth = 18;
constexpr const char* kNone = "This computer has no /etc/torsio/torsio.conf. ";

Configuration readOr(const std::string& file) {
  const std::filesystem::path named = file.empty() ? configurationFile() : std::filesystem::path(file);
  return named.empty() ? Configuration() : Configuration::read(named);
}

void show(bool json) {
  loadConfiguration();
  const std::string file = configuration().file().string();
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ComputerSetting& setting : computerSettings()) {
    all.push_back({{"key", setting.key->name},
                   {"value", setting.value},
                   {"origin", setting.origin.str()},
                   {"meaning", setting.key->label.english()},
                   {"rules", setting.key->force == ConfiguredForce::kRules}});
    if (!json) {
      std::cout << std::left << std::setw(kKeyWidth) << setting.key->name << " = "
                << (setting.value.empty() ? "-" : setting.value) << "  (" << setting.origin << ")\n";
    }
  }
  if (json) {
    printJson({{"file", file}, {"settings", all}});
    return;
  }
  std::cout << (file.empty() ? kNone : "")
            << "What the centre chose for all stations: torsio settings list\n";
}

void check(const std::string& file) {
  const Configuration read = readOr(file);
  if (read.file().empty()) {
    std::cout << kNone << "\n";
    return;
  }
  requireUsable(read);
  std::cout << read.file().string() << " can be used\n";
}

}  // namespace

void addConfig(CLI::App& program) {
  CLI::App* config = program.add_subcommand("config", "The configuration of this computer");
  config->require_subcommand(1);
  auto json = std::make_shared<bool>(false);
  CLI::App* command = config->add_subcommand("show", "Each value, and where it comes from");
  command->add_flag("--json", *json, "Print JSON");
  command->callback([json] { show(*json); });
  auto file = std::make_shared<std::string>();
  command = config->add_subcommand("check", "Says the line of the first fault in a configuration");
  command->add_option("FILE", *file, "Default: the one of this computer");
  command->callback([file] { check(*file); });
}

}  // namespace torsio::cli
