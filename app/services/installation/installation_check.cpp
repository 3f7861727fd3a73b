// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/installation/installation_check.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <future>
#include <iterator>
#include <memory>
#include <thread>

#include "app/services/access/station_record.h"
#include "app/services/base/build_info.h"
#include "app/services/base/configuration.h"
#include "app/services/installation/installation_checks.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

struct CheckLabel {
  std::string_view name;
  Phrase label;
};
constexpr auto kLabels = std::to_array<CheckLabel>({
    {"program", Text::tr("Program")},
    {"configuration", Text::tr("Configuration")},
    {"record", Text::tr("Record")},
    {"schema", Text::tr("Schema of the record")},
    {"trail_clock", Text::tr("Times in the audit trail")},
    {"access", Text::tr("Cards and links")},
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
    return failed(name, error);
  } catch (const std::exception& error) {
    return {name, CheckState::kFailed, Text::tr("could not be checked: %1", error.what()),
            Text::tr("Check the paths and permissions of this account")};
  }
}

/// Reads the record in a thread of its own: a server that does not answer must not stop the others.
std::vector<InstallationCheck> timedRecordChecks(const Installation& of) {
  auto task = std::make_shared<std::packaged_task<std::vector<InstallationCheck>()>>(
      [of] { return recordChecks(of); });
  std::future<std::vector<InstallationCheck>> checks = task->get_future();
  std::thread([task] { (*task)(); }).detach();
  if (checks.wait_for(std::chrono::seconds(kPatience_s)) == std::future_status::ready) {
    try {
      return checks.get();
    } catch (const std::exception& error) {
      return {{"record", CheckState::kFailed, Text::tr("could not be checked: %1", error.what()),
               Text::tr("Check the path and its permissions")}};
    }
  }
  return {{"record", CheckState::kFailed, Text::tr("it did not answer within %1 s", kPatience_s),
           Text::tr("Ask who runs the database server, or check the disk")}};
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
  return Text::tr("not checked");
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
  return failed + warned == 0
             ? Text(Text::tr("No problems."))
             : Text::tr("%1 {problem|problems}, %2 {thing|things} that could be better.", failed, warned);
}

std::vector<InstallationCheck> checkInstallation(const Installation& installation) {
  Installation of = installation;
  of.named = !of.locator.empty();
  if (of.certificate.empty()) {
    of.certificate = configured(kConfiguredCertificate).value_or("");
  }
  if (!of.named) {
    try {
      of.locator = stationRecord().locator;
    } catch (const Error&) {
      of.locator = chosenRecord();  // the check of the configuration tells why
    }
  }
  std::vector<InstallationCheck> checks = {good("program", Text::tr("Torsio %1", softwareVersion())),
                                           made("configuration", configurationCheck)};
  std::vector<InstallationCheck> record = timedRecordChecks(of);
  std::move(record.begin(), record.end(), std::back_inserter(checks));
  for (const char* name : {"schema", "trail_clock", "fleet", "copies", "backup"}) {
    if (std::none_of(checks.begin(), checks.end(), [name](const auto& one) { return one.name == name; })) {
      checks.push_back({name, CheckState::kSkipped, Text::tr("the record could not be opened"), {}});
    }
  }
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
