// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/station_record.h"

#include <QSettings>
#include <QStandardPaths>
#include <QString>

#include "app/services/access/first_run.h"
#include "app/services/base/configuration.h"
#include "db/connection/locator.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

const QString kChosen = QStringLiteral("station/database");

/// The window's settings of this account, whatever the name of the application.
QSettings windowSettings() {
  return QSettings(QStringLiteral("torsio"),
                   QStringLiteral("torsio"));  // NOLINT(modernize-return-braced-init-list)
}

std::filesystem::path usualFile() {
  return dataFolder() / "torsio.sqlite";
}

}  // namespace

StationRecord stationRecord() {
  if (const auto set = configured(kConfiguredRecord)) {
    requireRecordOfAll(*set, configuration().placeOf(kConfiguredRecord));
    return {*set, RecordOrigin::kConfigured};
  }
  if (std::string chosen = chosenRecord(); !chosen.empty()) {
    return {std::move(chosen), RecordOrigin::kChosen};
  }
  return {usualFile().string(), RecordOrigin::kUsual};
}

void requireRecordOfAll(const std::string& locator, const Text& place) {
  if (saysPassword(locator)) {
    throw Error(ErrorCode::kUsage, Text::tr("a password in an address is seen by every user of this machine"),
                place, Text::tr("Leave it out, and name the file with it: passfile = /etc/torsio/pgpass"));
  }
  const Locator where = parseLocator(locator);
  if (where.engine == Engine::kSqlite && !std::filesystem::path(where.file).is_absolute()) {
    throw Error(ErrorCode::kBadData, Text::tr("\"%1\" depends on the folder in which Torsio starts", locator),
                place, Text::tr("Write a path that begins with /"));
  }
}

Text wordsFor(RecordOrigin origin) {
  switch (origin) {
    case RecordOrigin::kConfigured:
      return Text::tr("set in %1", configuration().placeOf(kConfiguredRecord));
    case RecordOrigin::kChosen:
      return Text::tr("chosen in the window");
    case RecordOrigin::kUsual:
      break;
  }
  return Text::tr("where nothing else is said");
}

std::string chosenRecord() {
  return windowSettings().value(kChosen).toString().toStdString();
}

void chooseRecord(const std::string& locator) {
  windowSettings().setValue(kChosen, QString::fromStdString(locator));
}

std::filesystem::path dataFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString();
}

std::string usualRecord() {
  ensureFolder(dataFolder());
  return usualFile().string();
}

}  // namespace torsio
