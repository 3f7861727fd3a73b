// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/centres/site_export.h"

#include <algorithm>
#include <optional>
#include <ostream>
#include <unordered_map>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/base/build_info.h"
#include "app/services/centres/sound_record.h"
#include "app/services/maintenance/signing_key.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/connection/row_reader.h"
#include "db/migrations/file_in_the_making.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/demonstration_data.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

constexpr std::size_t kPooledColumns = 2;
/// Stands where a name of an account was: no more is said outside than that the centre did it.
constexpr const char* kWithheld = "centre";

SiteScope scopeOf(Connection& connection, const SiteRequest& request) {
  const Cohort cohort = StudyRepository(connection).cohort(request.cohortId);
  if (cohort.curriculumVersionId.empty()) {
    refuse(Text::tr("this cohort follows no curriculum"), cohort.name,
           Text::tr("Assign the curriculum of the protocol first"));
  }
  return {cohort.id, request.campaignId, cohort.curriculumVersionId};
}

std::filesystem::path keyFile(const SessionContext& session, const SiteRequest& request) {
  if (!request.key.empty()) {
    return request.key;
  }
  const Locator place = parseLocator(session.key().locator);
  if (place.engine != Engine::kSqlite) {
    throw Error(ErrorCode::kUsage, Text::tr("a record on a server has no place for the centre's key"),
                place.shown(), Text::tr("Name the file of the key with --key FILE"));
  }
  return withSuffix(place.file, ".site-key");
}

/// Newest seals of the tables that are given, by "table/key".
std::unordered_map<std::string, std::string> sealsOf(Connection& connection) {
  std::unordered_map<std::string, std::string> seals;
  forEachSeal(connection, [&](std::int64_t, std::int64_t, const RowSeal& seal) {
    if (siteTableOf(seal.table) != nullptr) {
      seals[seal.table + "/" + seal.key] = seal.rowHash;
    }
  });
  return seals;
}

/// Reads the rows of one table as they leave the centre.
class GivenRows {
 public:
  GivenRows(Connection& connection, const SiteScope& scope, const SiteTable& table)
      : connection_(connection),
        table_(table.table),
        select_(scope.select(table, "*")),
        withheld_(columnsOf(table.withheld)) {}

  template <typename Take>
  void forEach(const Take& take) {
    std::vector<std::string> columns;
    std::vector<int> hidden;
    forEachSelected(connection_, select_, [&](const Statement& row) {
      if (columns.empty()) {
        columns = columnNamesOf(row);
        if (table_ == "person") {  // the last two say where somebody was pooled from
          TORSIO_EXPECTS(columns.size() > kPooledColumns && columns.back() == "site_code");
          columns.resize(columns.size() - kPooledColumns);
        }
        for (const std::string& column : columns) {
          hidden.push_back(std::find(withheld_.begin(), withheld_.end(), column) != withheld_.end() ? 1 : 0);
        }
      }
      std::vector<Value> values = valuesOf(row);
      values.resize(columns.size());
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (hidden[i] == 1) {
          values[i] = isNull(values[i]) || mayBeNull(columns[i]) ? Value() : Value(kWithheld);
        }
      }
      take(columns, values);
    });
  }

 private:
  static bool isNull(const Value& value) { return std::holds_alternative<std::monostate>(value.storage()); }
  [[nodiscard]] bool mayBeNull(const std::string& column) const {
    return column == "experience" || column == "import_id" || column == "comment" ||
           (column == "description" && table_ == "deviation") || column == "trial_id" ||
           (column == "reason" && table_ == "run_excuse");
  }

  Connection& connection_;
  std::string_view table_;
  std::string select_;
  std::vector<std::string> withheld_;
};

bool isSealedApart(const SiteTable& table) {
  return table.table != "trial_chunk";
}

void writeRows(Connection& connection, const SiteScope& scope, SitePackageWriter& writer,
               SiteManifest& manifest, const ProgressCallback& progress) {
  SiteSealer sealer;
  for (const SiteTable& table : siteTables()) {
    if (isSealedApart(table)) {
      GivenRows(connection, scope, table).forEach([&](const auto& columns, const auto& row) {
        sealer.add(std::string(table.table), columns, row);
        manifest.simulated =
            manifest.simulated || (table.sameBy.empty() && isSimulated(columns, row) == true);
      });
    }
  }
  const std::unordered_map<std::string, std::string> own = sealsOf(connection);
  std::size_t done = 0;
  for (const SiteTable& table : siteTables()) {
    const std::string name(table.table);
    tellProgress(progress, Text::tr("Writing the package"),
                 static_cast<double>(done++) / static_cast<double>(siteTables().size()));
    const auto seals = sealer.seals(name);
    bool begun = false;
    GivenRows(connection, scope, table).forEach([&](const auto& columns, const auto& row) {
      if (!begun) {
        writer.beginTable(name, columns);
        begun = true;
      }
      const std::string key = sealer.keyOf(name, columns, row);
      const auto seal = seals.find(key);
      if (seal == seals.end()) {
        writer.add({}, row);
        return;
      }
      const auto original = own.find(name + "/" + key);
      const bool same = original != own.end() && original->second == seal->second;
      ++(same ? manifest.sealedRows : manifest.otherRows);
      writer.add(seal->second, row);
    });
  }
}

}  // namespace

SitePackage exportSite(SessionContext& session, const SiteRequest& request,
                       const ProgressCallback& progress) {
  session.require(Operation::kReportExportCoded);
  Connection& connection = session.connection();
  const bool simulated = holdsOnlySimulated(connection);
  if (request.simulatedOnly && !simulated) {
    throw Error(ErrorCode::kPermission, Text::tr("this record has people who are not simulated"),
                connection.location(),
                Text::tr("Sign in with --login NAME, or give --as-system as the owner of the record"));
  }
  const std::optional<Centre> centre = StudyRepository(connection).centre();
  if (!centre) {
    refuse(Text::tr("the centre of this record has no name"), connection.location(),
           Text::tr("Set the centre up in the window first"));
  }
  const SiteScope scope = scopeOf(connection, request);
  requireNoDatabase(request.out);
  SitePackage made;
  made.key = keyFile(session, request);
  if (!std::filesystem::exists(made.key)) {
    writeKey(made.key, drawKey(), {});
    made.keyMade = true;
  }
  const SecretKey key = readKey(made.key);

  Transaction transaction(connection);
  tellProgress(progress, Text::tr("Checking the record"), 0.0);
  requireSound(connection, Text::tr("its audit trail does not verify"));
  SiteManifest& manifest = made.manifest;
  const SiteConsent consent = siteConsent(connection, scope);
  session.note(AuditAction::kTrialExportCoded, AuditObject::kCohort, scope.cohortId,
               {{"format", "site package"}, {"trainees", consent.given}, {"left_out", consent.leftOut}});
  const TrailHead head = AuditRepository(connection).head();
  manifest.centreId = centre->id;
  manifest.centreCode = centreCode(connection);
  manifest.centreName = centre->name;
  manifest.publicKey = publicOf(key);
  manifest.software = softwareVersion();
  manifest.madeUtc_us = session.now_us();
  manifest.trailLength = head.length;
  manifest.trailHash = head.hash;
  manifest.cohort = StudyRepository(connection).cohort(scope.cohortId).name;
  manifest.simulated = simulated;
  manifest.trainees = consent.given;
  manifest.leftOut = consent.leftOut;
  manifest.protocol = protocolOf(connection, scope);
  if (!scope.campaignId.empty()) {
    manifest.campaign = selectFirst(connection, "SELECT name FROM evaluation_campaign WHERE id = ?",
                                    {scope.campaignId}, readText)
                            .value_or("");
  }
  writeFileAtomically(request.out, [&](std::ostream& out) {
    SitePackageWriter writer(out);
    writeRows(connection, scope, writer, manifest, progress);
    manifest =
        writer.finish(std::move(manifest), [&](const std::string& text) { return signedWith(key, text); });
  });
  transaction.commit();
  made.bytes = std::filesystem::file_size(request.out);
  return made;
}

}  // namespace torsio
