// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/station_anchor.h"

#include <QSettings>

#include "app/services/maintenance/anchor.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr const char* kWitness = "witness";
constexpr const char* kKey = "key";

/// A separate file in the account's settings.
QSettings settings() {
  return {QSettings::IniFormat, QSettings::UserScope, QStringLiteral("torsio"), QStringLiteral("anchor")};
}

QString textOf(const fs::path& path) {
  return path.empty() ? QString() : QString::fromStdString(fs::absolute(path).string());
}

}  // namespace

StationAnchor stationAnchor() {
  const QSettings stored = settings();
  return {stored.value(QLatin1String(kWitness)).toString().toStdString(),
          stored.value(QLatin1String(kKey)).toString().toStdString()};
}

void setStationAnchor(const StationAnchor& anchor) {
  if (!anchor.witness.empty()) {
    requireNoDatabase(anchor.witness);
  }
  if (!anchor.key.empty()) {
    (void)publicAnchorKey(anchor.key);
  }
  QSettings stored = settings();
  stored.setValue(QLatin1String(kWitness), textOf(anchor.witness));
  stored.setValue(QLatin1String(kKey), textOf(anchor.key));
}

bool remindOfKey() {
  QSettings stored = settings();
  const QString told = QStringLiteral("told_of_no_key");
  if (!stored.value(QLatin1String(kKey)).toString().isEmpty() || stored.value(told).toBool()) {
    return false;
  }
  stored.setValue(told, true);
  return true;
}

LeftHead witnessHead(Connection& connection, std::int64_t now_us) {
  const StationAnchor anchor = stationAnchor();
  LeftHead head{.line = anchoredHead(connection, anchor.key, now_us), .witness = anchor.witness};
  if (!head.witness.empty()) {
    appendToWitness(head.witness, head.line);
  }
  return head;
}

LeftHead headOnLeaving(Connection& connection, std::int64_t now_us) {
  try {
    return witnessHead(connection, now_us);
  } catch (const Error& error) {
    return {.line = anchoredHead(connection, {}, now_us),
            .trouble = Text::tr("%1: %2", error.whereText(), error.happenedText())};
  }
}

}  // namespace torsio
