// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/station_name.h"

#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QSettings>
#include <QString>
#include <QSysInfo>

#include "app/services/access/start_password.h"
#include "app/services/base/configuration.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr int kSignLetters = 5;
constexpr int kPatience_ms = 2000;
const QString kStationName = QStringLiteral("station/name");

/// The same file as the device and the tracker of the station.
QSettings stationSettings() {
  return {QSettings::IniFormat, QSettings::UserScope, QStringLiteral("torsio"), QStringLiteral("station")};
}

std::string computerName() {
  return QSysInfo::machineHostName().toStdString();
}

QString freshName() {
  return QString::fromStdString(computerName() + "-" + legibleLetters(kSignLetters));
}

/// Stores a fresh name; with `keep`, only if there is none. Two windows that start at once agree on one.
bool storeName(bool keep) {
  QSettings stored = stationSettings();
  QDir().mkpath(QFileInfo(stored.fileName()).absolutePath());  // for the lock
  QLockFile lock(stored.fileName() + QStringLiteral(".name-lock"));
  (void)lock.tryLock(kPatience_ms);
  stored.sync();
  if (keep && !stored.value(kStationName).toString().isEmpty()) {
    return true;
  }
  stored.setValue(kStationName, freshName());
  stored.sync();
  return stored.status() == QSettings::NoError;
}

}  // namespace

StationSign stationSign() {
  if (const auto set = configured(kConfiguredStation)) {
    return {.name = *set, .computer = computerName(), .settings = configuration().file(), .made = true};
  }
  const QSettings stored = stationSettings();
  StationSign sign{.name = stored.value(kStationName).toString().toStdString(),
                   .computer = computerName(),
                   .settings = stored.fileName().toStdString()};
  sign.made = !sign.name.empty();
  if (!sign.made) {
    sign.name = sign.computer;
  }
  return sign;
}

std::string stationName() {
  return stationSign().name;
}

bool makeStationName() {
  return stationSign().made || storeName(true);
}

void renewStationName() {
  requireNotConfigured(kConfiguredStation, Text::tr("the name of the station"));
  if (!storeName(false)) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("the settings of this station cannot be written"),
                stationSign().settings.string(), Text::tr("Check the rights of the folder"));
  }
}

Text twinWords(const std::string& station) {
  return Text::tr(
      "Somebody else is the station %1 at the same time: another window with the same settings, "
      "or a copy of this computer",
      station);
}

Text twinRemedy() {
  return Text::tr(
      "Close the other window. On a copied computer give the copy a name of its own with \"torsio station "
      "renew\", then start Torsio there again");
}

}  // namespace torsio
