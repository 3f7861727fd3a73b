// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "app/services/access/outdated_access.h"
#include "app/services/base/build_info.h"
#include "app/services/installation/installation_checks.h"
#include "app/services/maintenance/copies.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

/// A record's clock may be this far ahead of this computer's before somebody should look.
constexpr std::int64_t kClockSlack_us = 5 * kMinute_us;

InstallationCheck trailClockCheck(Connection& connection, std::int64_t now_us) {
  const std::vector<AuditEntry> newest = AuditRepository(connection).entries({.limit = 1});
  if (newest.empty() || newest.front().atUtc_us <= now_us + kClockSlack_us) {
    return good("trail_clock", Text::tr("no entry of the audit trail is later than this computer's clock"));
  }
  return {
      "trail_clock", CheckState::kFailed,
      Text::tr("the newest entry of the audit trail is %1 {minute|minutes} ahead of this computer's clock",
               (newest.front().atUtc_us - now_us) / kMinute_us),
      Text::tr("Set the clocks of all stations by one time server")};
}

InstallationCheck backupCheck(const std::string& locator, const std::vector<ListedCopy>& copies,
                              std::int64_t now_us) {
  std::int64_t newest_us = 0;
  for (const ListedCopy& one : copies) {
    if (one.copy.kind == CopyKind::kBackup) {
      newest_us = std::max(newest_us, one.copy.madeUtc_us);
    }
  }
  const Text remedy = Text::tr("Make one: torsio db backup, or the page Maintenance");
  if (newest_us == 0 && isOnServer(locator)) {  // its own tools may make them
    return {"backup", CheckState::kWarning, Text::tr("no backup by torsio db backup is known"), remedy};
  }
  if (newest_us == 0) {
    return {"backup", CheckState::kFailed, Text::tr("no backup is known"), remedy};
  }
  const std::int64_t days = (now_us - newest_us) / kDay_us;
  const Text finding = Text::tr("the newest backup is %1 {day|days} old", days);
  return days <= kBackupDue_days ? good("backup", finding)
                                 : InstallationCheck{"backup", CheckState::kWarning, finding, remedy};
}

InstallationCheck copiesCheck(const std::vector<ListedCopy>& copies, std::int64_t now_us) {
  const auto due = std::count_if(copies.begin(), copies.end(), [now_us](const ListedCopy& one) {
    return one.dueUtc_us != 0 && one.dueUtc_us < now_us;
  });
  if (due == 0) {
    return good("copies", Text::tr("%1 {copy is|copies are} known, none past its date", copies.size()));
  }
  return {"copies", CheckState::kWarning,
          Text::tr("%1 of %2 {copy|copies} should have been deleted by now", due, copies.size()),
          Text::tr("torsio db copies lists them; delete those files")};
}

InstallationCheck accessCheck(Connection& connection, std::int64_t now_us) {
  if (tablesSeenInPart(connection).contains("kiosk_code")) {
    return {"access", CheckState::kSkipped, Text::tr("only whoever manages users sees cards and links"), {}};
  }
  const Text outdated = sentenceOf(AccessRepository(connection).outdatedAccess(now_us));
  if (outdated.empty()) {
    return good("access", Text::tr("none was made useless by a new version"));
  }
  return {"access", CheckState::kWarning, outdated, remedyForOutdatedAccess()};
}

InstallationCheck fleetCheck(Connection& connection, std::int64_t now_us) {
  std::set<std::string> others;
  std::size_t stations = 0;
  for (const StationState& station : StationRepository(connection).board()) {
    if (now_us - station.heartbeatUtc_us > kFleetRemembered_days * kDay_us) {
      continue;
    }
    ++stations;
    if (station.softwareVersion != softwareVersion()) {
      others.insert(station.station + " (" + station.softwareVersion + ")");
    }
  }
  if (others.empty()) {
    return good("fleet", Text::tr("%1 {station|stations} seen lately, all with this version", stations));
  }
  return {"fleet", CheckState::kWarning,
          Text::tr("other versions: %1", listed(std::vector<Text>(others.begin(), others.end()))),
          Text::tr("Update these stations to %1", softwareVersion())};
}

}  // namespace

std::vector<InstallationCheck> recordChecks(const Installation& of) {
  std::vector<InstallationCheck> checks;
  const char* at = "record";
  try {
    Connection connection = openDatabase(of.locator, OpenMode::kReadOnly);
    checks.push_back(good(at, Text::tr("%1 can be opened", connection.location())));
    at = "schema";
    const SchemaState schema = checkSchema(connection, embeddedMigrations());
    if (schema.version < schema.known) {
      checks.push_back({at, CheckState::kWarning,
                        Text::tr("version %1 of %2: older than this program", schema.version, schema.known),
                        Text::tr("Open the record once in the window, so that it is brought up to date")});
      return checks;
    }
    checks.push_back(good(at, Text::tr("version %1", schema.version)));
    at = "trail_clock";
    checks.push_back(trailClockCheck(connection, of.now_us));
    at = "access";
    checks.push_back(accessCheck(connection, of.now_us));
    at = "fleet";
    checks.push_back(fleetCheck(connection, of.now_us));
    at = "copies";
    const std::vector<ListedCopy> copies = copiesOf(of.locator);
    checks.push_back(copiesCheck(copies, of.now_us));
    checks.push_back(backupCheck(of.locator, copies, of.now_us));
  } catch (const Error& error) {
    if (checks.empty() && error.code() == ErrorCode::kFileMissing && !of.named) {
      checks.push_back({at, CheckState::kWarning, Text::tr("there is no record yet: %1", of.locator),
                        Text::tr("Start Torsio once, or name the record: --database FILE")});
    } else {
      checks.push_back(failed(at, error));
    }
  }
  return checks;
}

}  // namespace torsio
