// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/tracker/tracker_choice.h"

#include <QSettings>

#include "app/connectors/tracker/own_address.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

const QString kAddressKey = QStringLiteral("tracker/address");
const QString kPortKey = QStringLiteral("tracker/port");
const QString kListensKey = QStringLiteral("tracker/listens");
const QString kInstrumentKey = QStringLiteral("tracker/instrument");
const QString kOutletPortKey = QStringLiteral("tracker/outlet_port");
const QString kOutletAddressKey = QStringLiteral("tracker/outlet_address");

QSettings trackerSettings() {
  return {QSettings::IniFormat, QSettings::UserScope, QStringLiteral("torsio"), QStringLiteral("station")};
}

std::uint16_t portIn(const QSettings& settings, const QString& key) {
  const uint port = settings.value(key).toUInt();
  return port <= 0xffffU ? static_cast<std::uint16_t>(port) : std::uint16_t{0};
}

}  // namespace

TrackerChoice rememberedTracker() {
  const QSettings settings = trackerSettings();
  TrackerChoice choice;
  if (const std::uint16_t port = portIn(settings, kPortKey); port != 0) {
    choice.tracker = TrackerPlace{.address = settings.value(kAddressKey).toString().toStdString(),
                                  .port = port,
                                  .listens = settings.value(kListensKey).toBool(),
                                  .instrument = settings.value(kInstrumentKey).toString().toStdString()};
  }
  choice.outletPort = portIn(settings, kOutletPortKey);
  choice.outletAddress = settings.value(kOutletAddressKey, QString::fromStdString(choice.outletAddress))
                             .toString()
                             .toStdString();
  return choice;
}

void rememberTracker(const TrackerChoice& choice) {
  if (choice.tracker && (choice.tracker->address.empty() || choice.tracker->port == 0)) {
    refuseParameter(Text::tr("address or port is missing"), Text::tr("tracker"),
                    Text::tr("Enter both; %1 is the usual port", std::to_string(kIgtlPort)));
  }
  if (choice.outletPort != 0 && ownAddress(choice.outletAddress).isNull()) {
    refuseParameter(
        Text::tr("not an address of this computer; use 127.0.0.1, or 0.0.0.0 for all its addresses"),
        choice.outletAddress, Text::tr("Give another one"));
  }
  QSettings settings = trackerSettings();
  const TrackerPlace place = choice.tracker.value_or(TrackerPlace{.port = 0});
  settings.setValue(kAddressKey, QString::fromStdString(place.address));
  settings.setValue(kPortKey, place.port);
  settings.setValue(kListensKey, place.listens);
  settings.setValue(kInstrumentKey, QString::fromStdString(place.instrument));
  settings.setValue(kOutletPortKey, choice.outletPort);
  settings.setValue(kOutletAddressKey, QString::fromStdString(choice.outletAddress));
}

}  // namespace torsio
