// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/installation/support_report.h"

#include <regex>
#include <string>
#include <vector>

#include <QDir>
#include <QSysInfo>
#include <QtGlobal>
#include <nlohmann/json.hpp>

#include "app/services/base/build_info.h"
#include "app/services/base/log.h"
#include "app/services/installation/computer_settings.h"
#include "assessment/results/number_format.h"
#include "db/migrations/migrations.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

using Json = nlohmann::ordered_json;

/// Removes what names the account: its folder, and the user in addresses of servers.
std::string withoutAccount(std::string text) {
  const std::string home = QDir::homePath().toStdString();
  for (std::size_t at = text.find(home); home.size() > 1 && at != std::string::npos;
       at = text.find(home, at)) {
    text.replace(at, home.size(), "~");
  }
  static const std::regex user("//[^/@\\s]*@");
  return std::regex_replace(text, user, "//");
}

Json configurationJson() {
  Json all = Json::array();
  try {
    for (const ComputerSetting& setting : computerSettings()) {
      all.push_back({{"key", setting.key->name},
                     {"value", withoutAccount(setting.value)},
                     {"origin", withoutAccount(setting.origin.str())}});
    }
  } catch (const Error&) {
    return Json::array();  // the check "configuration" says why
  }
  return all;
}

Json checksJson(const std::vector<InstallationCheck>& checks) {
  Json all = Json::array();
  for (const InstallationCheck& check : checks) {
    all.push_back({{"name", check.name},
                   {"state", storedText(check.state)},
                   {"finding", withoutAccount(check.finding.str())},
                   {"remedy", withoutAccount(check.remedy.str())}});
  }
  return all;
}

Json logJson() {
  Json lines = Json::array();
  for (const std::string& line : newestLogLines(kSupportLogLines)) {
    lines.push_back(withoutAccount(line));
  }
  return lines;
}

}  // namespace

void writeSupportReport(const std::filesystem::path& file, const Installation& installation) {
  const Json report{{"made", formatUtc(installation.now_us)},
                    {"torsio", softwareVersion()},
                    {"program", programHash()},
                    {"newest_schema_of_program", embeddedMigrations().back().version},
                    {"qt", qVersion()},
                    {"system", QSysInfo::prettyProductName().toStdString()},
                    {"kernel", QSysInfo::kernelVersion().toStdString()},
                    {"processor", QSysInfo::currentCpuArchitecture().toStdString()},
                    {"configuration", configurationJson()},
                    {"checks", checksJson(checkInstallation(installation))},
                    {"log", logJson()}};
  writeFileAtomically(file, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace torsio
