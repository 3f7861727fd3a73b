// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/device_choice.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include <QSettings>

#include "app/services/base/configuration.h"
#include "assessment/results/number_format.h"
#include "sim/core/error.h"
#include "sim/device/drivers/device_list.h"

namespace torsio {

namespace {

const QString kDriverKey = QStringLiteral("device/driver");
const QString kNameKey = QStringLiteral("device/name");

/// The same settings for the window and the command line, whatever their application names.
QSettings stationSettings() {
  return {QSettings::IniFormat, QSettings::UserScope, QStringLiteral("torsio"), QStringLiteral("station")};
}

const DeviceDriver& stationDriver(const std::string& id) {
  const DeviceDriver& driver = deviceDriver(id);
  if (driver.use != DriverUse::kStation) {
    refuseParameter(Text::tr("\"%1\" is not a device that can be connected", driver.name), Text::tr("device"),
                    Text::tr("`torsio device list` shows the others"));
  }
  return driver;
}

}  // namespace

void pause_s(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

void requireTime(double seconds, double longest, Phrase what) {
  if (seconds > 0.0 && seconds <= longest) {
    return;
  }
  refuseParameter(Text::tr("%1 must lie above 0 s and not above %2 s, got %3", what, formatFixed(longest, 0),
                           formatFixed(seconds, 2)),
                  Text::tr("device"), Text::tr("Give another number of seconds"));
}

DeviceRequest deviceRequest(const DeviceChoice& choice, const std::function<bool()>& cancelled) {
  DeviceRequest request;
  request.library = choice.library;
  request.name = choice.name;
  request.inThisProcess = choice.inThisProcess;
  request.cancelled = cancelled;
  return request;
}

const DeviceDriver& chosenDriver(const DeviceChoice& choice) {
  if (!choice.driver.empty()) {
    return stationDriver(choice.driver);
  }
  const std::vector<DeviceDriver>& drivers = deviceDrivers();
  const auto first = [&](const auto& fits) {
    return std::find_if(drivers.begin(), drivers.end(), [&](const DeviceDriver& driver) {
      return driver.use == DriverUse::kStation && fits(driver);
    });
  };
  const auto named =
      first([&](const DeviceDriver& driver) { return driver.takesLibrary && !choice.library.empty(); });
  if (named != drivers.end()) {
    return *named;
  }
  const std::string remembered = rememberedDevice().driver;
  const auto known = first([&](const DeviceDriver& driver) { return driver.id == remembered; });
  if (known != drivers.end()) {
    return *known;
  }
  const DeviceRequest request = deviceRequest(choice);
  const auto present = first([&](const DeviceDriver& driver) { return driver.look(request).available; });
  return present != drivers.end() ? *present : *first([](const DeviceDriver&) { return true; });
}

DeviceChoice rememberedDevice() {
  const QSettings settings = stationSettings();
  const std::string chosen = settings.value(kDriverKey).toString().toStdString();
  return {.driver = chosen.empty() ? configured(kConfiguredDevice).value_or("") : chosen,
          .name = settings.value(kNameKey).toString().toStdString()};
}

void rememberDevice(const DeviceChoice& choice) {
  if (!choice.driver.empty()) {
    static_cast<void>(stationDriver(choice.driver));
  }
  QSettings settings = stationSettings();
  settings.setValue(kDriverKey, QString::fromStdString(choice.driver));
  settings.setValue(kNameKey, QString::fromStdString(choice.name));
}

}  // namespace torsio
