// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/centres/site_pool.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/centres/site_intake.h"
#include "app/services/centres/sound_record.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/id_source.h"
#include "db/repository/base/row_ledger.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "db/repository/system/site_repository.h"
#include "sim/core/error.h"
#include "sim/core/plain_text.h"

namespace torsio {

namespace {

constexpr const char* kPoolCode = "POOL";
constexpr std::int64_t kTakenPerProgress = 2000;

std::int64_t countOf(Connection& connection, const std::string& sql,
                     std::initializer_list<Value> values = {}) {
  return selectFirst(connection, sql, values, readInt64).value_or(0);
}

/// Names where a difference of the protocols lies. `planOnly`: without what depends on the people given.
void requireSameProtocol(Connection& connection, const SiteManifest& manifest,
                         const std::filesystem::path& file, bool planOnly) {
  const std::optional<std::string> cohort =
      selectFirst(connection, "SELECT id FROM cohort WHERE name = ?", {manifest.cohort}, readText);
  if (!cohort) {
    const std::string pooled =
        selectFirst(connection, "SELECT name FROM cohort ORDER BY created_utc_us, id LIMIT 1", {}, readText)
            .value_or("");
    refuse(
        Text::tr("holds the cohort '%1', while '%2' is pooled here", plainLine(manifest.cohort, 80), pooled),
        file.string(), Text::tr("Pool it into a record of its own"));
  }
  const SiteScope scope{
      *cohort,
      selectFirst(connection, "SELECT id FROM evaluation_campaign WHERE name = ?", {manifest.campaign},
                  readText)
          .value_or(""),
      selectFirst(connection, "SELECT curriculum_version_id FROM cohort WHERE id = ?", {*cohort}, readText)
          .value_or("")};
  TrialProtocol here = protocolOf(connection, scope);
  TrialProtocol there = manifest.protocol;
  if (planOnly) {
    for (const char* part : {"rubrics", "organs"}) {
      here.parts.erase(part);
      there.parts.erase(part);
    }
  }
  const std::vector<Text> differences = protocolDifferences(here, there);
  if (!differences.empty()) {
    refuse(Text::tr("follows another protocol. %1", differences.front()), file.string(),
           Text::tr("Pool only centres that follow one protocol; nothing was taken from it"));
  }
}

std::string freeCode(const std::vector<Site>& sites, const SiteManifest& manifest) {
  const auto taken = [&](const std::string& code) {
    return std::any_of(sites.begin(), sites.end(), [&](const Site& one) { return one.code == code; });
  };
  std::string code = manifest.centreCode;
  for (std::size_t digits = 4; taken(code); digits += 4) {  // ends: the id is a UUID that no other site has
    code = manifest.centreCode + "-" + manifest.centreId.text().substr(0, digits);
  }
  return code;
}

/// Throws unless the package may join what is there.
void requireRoom(Connection& connection, const SiteManifest& manifest, const std::filesystem::path& file) {
  if (!takesPackages(connection)) {
    refuse(Text::tr("this record has people of its own"), connection.location(),
           Text::tr("Pool into a new file"));
  }
  const std::optional<Centre> centre = StudyRepository(connection).centre();
  if (centre && centre->demonstration != manifest.simulated) {
    refuse(manifest.simulated ? Text::tr("holds simulated people, while real ones are pooled here")
                              : Text::tr("holds real people, while simulated ones are pooled here"),
           file.string(), Text::tr("Pool it into a record of its own"));
  }
}

void ensurePool(SessionContext& session, const SiteManifest& manifest) {
  StudyRepository studies(session.connection());
  if (studies.centre()) {
    return;
  }
  studies.setCentre({session.ids().newUuid(),
                     manifest.simulated ? "Pooled centres (simulated)" : "Pooled centres", session.now_us(),
                     manifest.simulated});
  SettingRepository(session.connection()).set(kCentreCode.name, kPoolCode, session.now_us());
}

/// Returns whether an error lies in the rows, not in disk, lock or server.
bool isOfRows(DbFault fault) {
  return fault == DbFault::kUnique || fault == DbFault::kForeignKey || fault == DbFault::kCheck ||
         fault == DbFault::kNotNull;
}

SiteDelivery deliveryOf(SessionContext& session, const CheckedPackage& package) {
  const SiteManifest& manifest = package.manifest;
  return {.id = session.ids().newUuid(),
          .centreId = manifest.centreId,
          .sequence = 1,
          .packageHash = package.hash,
          .madeUtc_us = manifest.madeUtc_us,
          .trailLength = manifest.trailLength,
          .trailHash = manifest.trailHash,
          .protocolHash = manifest.protocol.hash(),
          .leftOut = manifest.leftOut,
          .receivedBy = session.actor().systemAccount.empty() ? session.actor().userId.text() : "torsio",
          .receivedUtc_us = session.now_us(),
          .demonstration = manifest.simulated};
}

/// Compares with what the centre delivered before: numbers the delivery, and says in `outcome` if it repeats
/// an earlier package or is older than one.
void compareWithEarlier(const std::vector<SiteDelivery>& deliveries, SiteDelivery& delivery,
                        PoolOutcome& outcome) {
  for (const SiteDelivery& earlier : deliveries) {
    if (earlier.centreId != delivery.centreId) {
      continue;
    }
    delivery.sequence = std::max(delivery.sequence, earlier.sequence + 1);
    if (earlier.packageHash == delivery.packageHash) {
      outcome.kind = Pooled::kRepeated;
      outcome.earlierUtc_us = earlier.receivedUtc_us;
      return;
    }
    if (earlier.trailLength > delivery.trailLength ||
        (earlier.trailLength == delivery.trailLength && earlier.trailHash != delivery.trailHash)) {
      outcome.kind = Pooled::kOlder;
      outcome.earlierUtc_us = earlier.madeUtc_us;
    }
  }
}

void takeRows(const std::filesystem::path& file, const CheckedPackage& package, const std::string& siteCode,
              SiteIntake& intake, const ProgressCallback& progress) {
  std::int64_t all = 0;
  for (const auto& [table, rows] : package.manifest.rows) {
    all += rows;
  }
  std::int64_t done = 0;
  readSitePackage(file, package, [&](const SitePackageRow& row) {
    intake.take(row);
    if (++done % kTakenPerProgress == 0) {
      tellProgress(progress, Text::tr("Taking in the rows of %1", siteCode),
                   0.1 + 0.7 * static_cast<double>(done) / static_cast<double>(all));
    }
  });
}

PoolOutcome takeIn(SessionContext& session, const std::filesystem::path& file, const CheckedPackage& package,
                   const ProgressCallback& progress) {
  Connection& connection = session.connection();
  const SiteManifest& manifest = package.manifest;
  PoolOutcome outcome{.manifest = manifest};
  SiteRepository repository(connection);
  const std::vector<Site> sites = repository.sites();
  const auto known = std::find_if(sites.begin(), sites.end(),
                                  [&](const Site& one) { return one.centreId == manifest.centreId; });
  SiteDelivery delivery = deliveryOf(session, package);
  Site site{manifest.centreId, {}, manifest.centreName, manifest.publicKey, session.now_us(),
            manifest.simulated};
  if (known == sites.end()) {
    site.code = freeCode(sites, manifest);
  } else {
    site = *known;
    if (site.publicKey != manifest.publicKey) {
      throw Error(ErrorCode::kVerifyFailed,
                  Text::tr("is signed with another key than the earlier packages of centre %1", site.code),
                  file.string(), Text::tr("Ask the centre who made it; nothing was taken from it"));
    }
  }
  outcome.siteCode = site.code;
  compareWithEarlier(repository.deliveries(), delivery, outcome);
  if (outcome.kind == Pooled::kRepeated || outcome.kind == Pooled::kOlder) {
    return outcome;
  }
  if (!sites.empty()) {
    requireSameProtocol(connection, manifest, file, false);
  }
  ensurePool(session, manifest);
  if (known == sites.end()) {
    repository.add(site);
  }
  SiteIntake intake(connection, manifest, site, delivery.id);
  takeRows(file, package, site.code, intake, progress);
  requireSameProtocol(connection, manifest, file, true);  // its rows say what its manifest says
  outcome.rowsAdded = intake.added();
  outcome.rowsChanged = intake.changed();
  outcome.withdrawn = withdrawnPeople(connection, site.centreId);
  if (outcome.rowsAdded == 0 && outcome.rowsChanged == 0) {
    outcome.kind = Pooled::kNothingNew;  // the delivery is recorded all the same: the centre is up to date
  }
  delivery.rowsAdded = outcome.rowsAdded;
  repository.add(delivery);
  intake.finish();
  const std::string reason = "package of centre " + site.code;
  session.note(AuditAction::kTrialImport, AuditObject::kCentre, site.centreId,
               {{"site", site.code},
                {"package", package.hash},
                {"trail", manifest.trailHash},
                {"rows", outcome.rowsAdded},
                {"changed", outcome.rowsChanged},
                {"left_out", manifest.leftOut}});
  const std::vector<RowSeal> seals = std::move(intake).changedSeals();
  if (!seals.empty()) {
    writeSeals(connection, seals, {.atUtc_us = session.now_us(), .actor = "torsio", .reason = reason});
  }
  sealUnsealed(connection, reason, session.now_us());
  return outcome;
}

}  // namespace

bool takesPackages(Connection& connection) {
  return countOf(connection, "SELECT count(*) FROM person WHERE site_id IS NULL") == 0 &&
         countOf(connection,
                 "SELECT count(*) FROM trial t LEFT JOIN person p ON p.id = t.trainee_id"
                 " WHERE p.site_id IS NULL") == 0;
}

PoolOutcome poolSite(SessionContext& session, const std::filesystem::path& file,
                     const CheckedPackage& package, const ProgressCallback& progress) {
  session.require(Operation::kDatabaseRestore);
  Connection& connection = session.connection();
  requireRoom(connection, package.manifest, file);
  const UnsealedCopy sealedAtTheEnd(connection);
  Transaction transaction(connection);
  requireSound(connection, Text::tr("the pooled record does not verify"));
  try {
    PoolOutcome outcome = takeIn(session, file, package, progress);
    if (outcome.kind == Pooled::kAdded || outcome.kind == Pooled::kNothingNew) {
      tellProgress(progress, Text::tr("Checking the pooled record"), 0.85);
      requireSound(connection, Text::tr("with this package the record does not verify"));
      transaction.commit();
    }
    return outcome;
  } catch (const DbError& error) {
    if (!isOfRows(error.fault())) {
      throw;
    }
    refuse(Text::tr("rows of this package do not fit together, or not with what is pooled here"),
           file.string(), Text::tr("Ask the centre to export it again; nothing was taken from it"));
  }
}

std::vector<SiteState> siteStates(SessionContext& session) {
  session.require(Operation::kReportExportCoded);
  Connection& connection = session.connection();
  SiteRepository repository(connection);
  const std::vector<SiteDelivery> deliveries = repository.deliveries();
  std::vector<SiteState> states;
  for (Site& site : repository.sites()) {
    SiteState state;
    for (const SiteDelivery& delivery : deliveries) {
      if (delivery.centreId == site.centreId) {
        state.deliveries.push_back(delivery);
      }
    }
    state.trainees = countOf(connection,
                             "SELECT count(*) FROM trainee t JOIN person p ON p.id = t.person_id"
                             " WHERE p.site_id = ?",
                             {site.centreId});
    state.recordings = countOf(connection,
                               "SELECT count(*) FROM trial t JOIN person p ON p.id = t.trainee_id"
                               " WHERE p.site_id = ?",
                               {site.centreId});
    state.marks = countOf(connection,
                          "SELECT count(*) FROM training_mark m JOIN enrolment e ON e.id = m.enrolment_id"
                          " JOIN person p ON p.id = e.trainee_id WHERE p.site_id = ?",
                          {site.centreId});
    state.withdrawn = withdrawnPeople(connection, site.centreId);
    state.site = std::move(site);
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace torsio
