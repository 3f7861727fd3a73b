// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/installation/computer_settings.h"

#include <array>
#include <fstream>
#include <functional>

#include "app/services/access/station_name.h"
#include "app/services/access/station_record.h"
#include "app/services/devices/device_choice.h"
#include "app/services/maintenance/kept_backups.h"
#include "db/connection/locator.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Returns what holds where the configuration is silent.
ComputerSetting unconfigured(const ConfiguredKey& key) {
  if (&key == &kConfiguredRecord) {
    const StationRecord record = stationRecord();
    return {&key, record.locator, wordsFor(record.origin)};
  }
  if (&key == &kConfiguredStation) {
    const StationSign sign = stationSign();
    return {&key, sign.name,
            sign.made ? Text::tr("made once, kept in %1", sign.settings.string())
                      : Text(Text::tr("of the computer: no window started yet"))};
  }
  if (&key == &kConfiguredDevice) {
    const std::string driver = rememberedDevice().driver;
    return {&key, driver,
            driver.empty() ? Text::tr("nobody chose one: the first that is connected")
                           : Text::tr("chosen at this station")};
  }
  if (&key == &kConfiguredLanguage || &key == &kConfiguredTheme) {
    return {&key, "", Text::tr("each user's choice")};
  }
  return {&key, "", Text::tr("not set")};
}

/// Throws what is wrong with a value, at its line.
void check(const Configuration& configuration, const ConfiguredKey& key,
           const std::function<void(const std::string&)>& judge) {
  if (const auto value = configuration.at(key)) {
    try {
      judge(*value);
    } catch (const Error& error) {
      throw Error(ErrorCode::kBadData, error.happenedText(), configuration.placeOf(key), error.remedyText());
    }
  }
}

void requireReadable(const std::string& file) {
  if (!std::ifstream(file)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("%1 cannot be read", file), "",
                Text::tr("Check that the file exists and that this account may read it"));
  }
}

}  // namespace

std::vector<ComputerSetting> computerSettings() {
  std::vector<ComputerSetting> all;
  for (const ConfiguredKey* key : kConfiguredKeys) {
    const auto value = configured(*key);
    const bool chosen =
        key == &kConfiguredDevice && !rememberedDevice().driver.empty() && rememberedDevice().driver != value;
    all.push_back(value && !chosen
                      ? ComputerSetting{key, *value, Text::tr("set in %1", configuration().placeOf(*key))}
                      : unconfigured(*key));
  }
  return all;
}

void requireUsable(const Configuration& configuration) {
  check(configuration, kConfiguredRecord, [](const std::string& record) { requireRecordOfAll(record, ""); });
  check(configuration, kConfiguredDevice, [](const std::string& id) { (void)chosenDriver({.driver = id}); });
  check(configuration, kConfiguredBackupKeep, [](const std::string& keep) { (void)keepRule(keep); });
  for (const ConfiguredKey* file :
       {&kConfiguredPassfile, &kConfiguredCertificate, &kConfiguredCertificateKey}) {
    check(configuration, *file, requireReadable);
  }
}

}  // namespace torsio
