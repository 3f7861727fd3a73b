// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/installation/installation_check.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include "app/services/base/build_info.h"
#include "app/services/installation/installation_checks.h"
#include "app/services/recording/unstored_trials.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

struct CheckLabel {
  std::string_view name;
  Phrase label;
};
constexpr auto kLabels = std::to_array<CheckLabel>({
    {"program", Text::tr("Program")},
    {"record", Text::tr("Record")},
    {"schema", Text::tr("Schema of the record")},
    {"trail_clock", Text::tr("Times in the audit trail")},
    {"backup", Text::tr("Backup")},
    {"copies", Text::tr("Copies")},
    {"fleet", Text::tr("Versions of the stations")},
    {"disk", Text::tr("Disk")},
    {"clock", Text::tr("Clock")},
    {"key", Text::tr("Signing key")},
    {"witness", Text::tr("Witness file")},
    {"certificate", Text::tr("Certificate of the browser desk")},
    {"real_time", Text::tr("Real-time priority")},
    {"memory", Text::tr("Memory of the servo")},
    {"device", Text::tr("Haptic device")},
    {"display", Text::tr("Display")},
    {"graphics", Text::tr("Graphics card")},
});

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

Text labelOf(CheckState state) {
  switch (state) {
    case CheckState::kGood:
      return Text::tr("in order");
    case CheckState::kWarning:
      return Text::tr("could be better");
    case CheckState::kFailed:
      return Text::tr("does not work");
    case CheckState::kSkipped:
      break;
  }
  return Text::tr("not looked at");
}

Text labelOf(const InstallationCheck& check) {
  const auto* label = std::find_if(kLabels.begin(), kLabels.end(),
                                   [&](const CheckLabel& one) { return one.name == check.name; });
  return label == kLabels.end() ? Text(check.name) : Text(label->label);
}

void sortByUrgency(std::vector<InstallationCheck>& checks) {
  const auto urgency = [](CheckState state) {
    return state == CheckState::kFailed    ? 0
           : state == CheckState::kWarning ? 1
           : state == CheckState::kGood    ? 2
                                           : 3;
  };
  std::stable_sort(checks.begin(), checks.end(),
                   [&](const auto& a, const auto& b) { return urgency(a.state) < urgency(b.state); });
}

Text summaryOf(const std::vector<InstallationCheck>& checks) {
  const auto count = [&](CheckState state) {
    return std::count_if(checks.begin(), checks.end(),
                         [state](const InstallationCheck& check) { return check.state == state; });
  };
  const auto failed = count(CheckState::kFailed);
  const auto warned = count(CheckState::kWarning);
  return failed + warned == 0 ? Text::tr("Everything that was looked at is in order.")
                              : Text::tr("%1 {does|do} not work, %2 could be better.", failed, warned);
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
