// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/installation/installation_check.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "app/services/base/build_info.h"
#include "app/services/installation/installation_checks.h"
#include "app/services/recording/unstored_trials.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Makes a check; what it throws is its finding.
InstallationCheck made(const char* name, const std::function<InstallationCheck()>& check) {
  try {
    return check();
  } catch (const Error& error) {
    return {name, CheckState::kFailed, error.happenedText(), error.remedyText()};
  } catch (const std::exception& error) {
    return {name, CheckState::kFailed, Text::tr("could not be looked at: %1", error.what()), {}};
  }
}

/// Returns the folder of a record; the working folder's disk for a record on a server.
std::filesystem::path folderOf(const std::string& locator) {
  if (isOnServer(locator)) {
    return std::filesystem::current_path();
  }
  const std::filesystem::path folder = std::filesystem::absolute(locator).parent_path();
  return std::filesystem::exists(folder) ? folder : std::filesystem::current_path();
}

}  // namespace

std::string_view storedText(CheckState state) noexcept {
  switch (state) {
    case CheckState::kGood:
      return "good";
    case CheckState::kWarning:
      return "warning";
    case CheckState::kFailed:
      return "failed";
    case CheckState::kSkipped:
      break;
  }
  return "skipped";
}

std::vector<InstallationCheck> checkInstallation(const Installation& installation) {
  Installation of = installation;
  if (of.locator.empty()) {
    of.locator = defaultDatabase();
  }
  std::vector<InstallationCheck> checks = {good("program", Text::tr("Torsio %1", softwareVersion()))};
  std::vector<InstallationCheck> record = recordChecks(of);
  std::move(record.begin(), record.end(), std::back_inserter(checks));
  checks.push_back(made("disk", [&] { return diskCheck(folderOf(of.locator)); }));
  checks.push_back(made("clock", clockCheck));
  checks.push_back(made("key", [&] { return keyCheck(of.locator); }));
  checks.push_back(made("witness", witnessCheck));
  checks.push_back(made("certificate", [&] { return certificateCheck(of); }));
  checks.push_back(made("real_time", realTimeCheck));
  checks.push_back(made("memory", memoryCheck));
  checks.push_back(made("device", deviceCheck));
  checks.push_back(made("display", displayCheck));
  checks.push_back(made("graphics", graphicsCheck));
  return checks;
}

CheckState worstOf(const std::vector<InstallationCheck>& checks) noexcept {
  const auto any = [&](CheckState state) {
    return std::any_of(checks.begin(), checks.end(),
                       [state](const InstallationCheck& check) { return check.state == state; });
  };
  return any(CheckState::kFailed)    ? CheckState::kFailed
         : any(CheckState::kWarning) ? CheckState::kWarning
                                     : CheckState::kGood;
}

}  // namespace torsio
