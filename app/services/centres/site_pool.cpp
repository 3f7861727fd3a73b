// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/centres/site_pool.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/id_source.h"
#include "db/repository/base/row_ledger.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/schema_tables.h"
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

void requireSound(Connection& connection, const Text& what) {
  const std::vector<AuditFinding> findings = verifyAuditTrail(connection);
  if (!findings.empty()) {
    const AuditFinding& first = findings.front();
    throw Error(ErrorCode::kVerifyFailed,
                Text::tr("%1: %2 {finding|findings}, the first one: %3", what, findings.size(),
                         first.objectKind + " " + first.objectId + " " + first.what),
                connection.location(), Text::tr("Run torsio audit verify on it; nothing was changed"));
  }
}

/// Names where a difference of the protocols lies.
void requireSameProtocol(Connection& connection, const SiteManifest& manifest,
                         const std::filesystem::path& file) {
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
  const std::vector<Text> differences = protocolDifferences(protocolOf(connection, scope), manifest.protocol);
  if (!differences.empty()) {
    refuse(Text::tr("follows another protocol. %1", differences.front()), file.string(),
           Text::tr("Pool only centres that follow one protocol; nothing was taken from it"));
  }
}

/// Takes rows in; knows which ids of plan rows stand here for those of the package.
class Intake {
 public:
  Intake(Connection& connection, const CheckedPackage& package, Site site, SiteDelivery& delivery)
      : connection_(connection), package_(package), site_(std::move(site)), delivery_(delivery) {
    for (SchemaTable& table : tablesInReferenceOrder(connection)) {
      if (siteTableOf(table.name) != nullptr) {
        tables_.emplace(table.name, std::move(table));
      }
    }
    known_ = SiteRepository(connection).rows();
    for (const auto& [key, row] : known_) {
      if (row.centreId == site_.centreId && key.starts_with("trial_end/")) {
        wholeTrials_.insert(key.substr(key.find('/') + 1));
      }
    }
  }

  void take(const SitePackageRow& row) {
    const SiteTable* table = siteTableOf(row.table);
    if (table == nullptr || row.values.size() != row.columns.size()) {
      breaksRules();
    }
    if (table_ != table) {
      beginTable(*table, row.columns);
    }
    for (Value& value : row.values) {
      adopt(value);
    }
    const std::string key = sealer_.keyOf(row.table, row.columns, row.values);
    if (table->sameBy.empty()) {
      takeRow(row, key);
    } else {
      takePlan(row);
    }
  }

  /// Stores which rows came with this delivery, and seals what is new.
  void finish() {
    Statement insert = connection_.prepare(
        "INSERT INTO site_row (delivery_id, table_name, row_key, site_seal) VALUES (?, ?, ?, ?)");
    for (const auto& [table, key, seal] : brought_) {
      insert.execute({delivery_.id, table, key, seal});
    }
  }

  std::int64_t added = 0;
  std::int64_t changed = 0;
  [[nodiscard]] std::vector<RowSeal> changedSeals() && { return std::move(changedSeals_); }

 private:
  struct Brought {
    std::string table;
    std::string key;
    std::string seal;
  };

  [[noreturn]] void breaksRules() const {
    refuse(Text::tr("rows of this package do not fit together"), site_.code,
           Text::tr("Ask the centre to export it again with torsio study export; nothing was taken from it"));
  }

  /// Replaces the id of a plan row by the one that it has here.
  void adopt(Value& value) const {
    const auto* text = std::get_if<std::string>(&value.storage());
    if (text == nullptr || ids_.empty()) {
      return;
    }
    if (const auto found = ids_.find(*text); found != ids_.end()) {
      value = found->second;
    }
  }

  void beginTable(const SiteTable& table, const std::vector<std::string>& columns) {
    const std::string name(table.table);
    const SchemaTable& schema = tables_.at(name);
    table_ = &table;
    boolean_.assign(columns.size(), 0);
    std::string marks;
    std::string list;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto found = std::find_if(schema.columns.begin(), schema.columns.end(),
                                      [&](const TableColumn& one) { return one.name == columns[i]; });
      if (found == schema.columns.end() || columns[i].starts_with("site_")) {
        throw Error(ErrorCode::kNewerSchema,
                    Text::tr("holds a column that this version does not know: %1 of the table %2",
                             plainLine(columns[i], 40), name),
                    site_.code, Text::tr("Update Torsio here first"));
      }
      boolean_[i] = found->boolean ? 1 : 0;
      list += (i == 0 ? "" : ", ") + columns[i];
      marks += i == 0 ? "?" : ", ?";
    }
    if (name == "person") {
      list += ", site_id, site_code";
      marks += ", ?, ?";
    }
    insert_.emplace(connection_.prepare("INSERT INTO " + name + " (" + list + ") VALUES (" + marks + ")"));
    find_.reset();
    place_.clear();
    if (!table.sameBy.empty()) {
      std::string condition;
      for (const std::string& column : columnsOf(table.sameBy)) {
        place_.push_back(positionOf(columns, column));
        condition += (condition.empty() ? "" : " AND ") + column + " = ?";
      }
      const bool hasId = std::find(columns.begin(), columns.end(), "id") != columns.end();
      find_.emplace(connection_.prepare("SELECT " + std::string(hasId ? "id" : "'1'") + " FROM " + name +
                                        " WHERE " + condition));
    } else if (name == "trial_chunk") {
      place_ = {positionOf(columns, "trial_id"), positionOf(columns, "chunk_index")};
      find_.emplace(
          connection_.prepare("SELECT digest FROM trial_chunk WHERE trial_id = ? AND chunk_index = ?"));
    }
  }

  [[nodiscard]] std::size_t positionOf(const std::vector<std::string>& columns,
                                       std::string_view column) const {
    const auto found = std::find(columns.begin(), columns.end(), column);
    if (found == columns.end()) {
      breaksRules();
    }
    return static_cast<std::size_t>(found - columns.begin());
  }

  static std::string textOf(const Value& value) {
    const auto* text = std::get_if<std::string>(&value.storage());
    return text == nullptr ? std::string() : *text;
  }

  std::optional<std::string> found(const SitePackageRow& row) {
    std::vector<Value> values;
    for (const std::size_t place : place_) {
      values.push_back(row.values[place]);
    }
    find_->execute(values);
    std::optional<std::string> id;
    if (find_->step()) {
      id = find_->text(0);
    }
    while (id && find_->step()) {
    }
    return id;
  }

  void insert(const SitePackageRow& row) {
    std::vector<Value> values = row.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto* number = std::get_if<std::int64_t>(&values[i].storage());
      if (boolean_[i] == 1 && number != nullptr) {
        values[i] = *number != 0;
      }
    }
    if (row.table == "person") {
      const std::size_t code = positionOf(row.columns, "code");
      const std::string own = textOf(values[code]);
      values[code] = qualifiedCode(site_.code, own);
      values.emplace_back(site_.centreId);
      values.emplace_back(own);
    } else if (row.table == "enrolment") {
      const std::size_t group = positionOf(row.columns, "group_id");
      const std::size_t number = positionOf(row.columns, "number_in_group");
      if (!textOf(values[group]).empty()) {
        values[number] = nextInGroup(textOf(values[group]));
      }
    }
    insert_->execute(values);
  }

  std::int64_t nextInGroup(const std::string& group) {
    const auto [last, first] = lastInGroup_.try_emplace(group, 0);
    if (first) {
      last->second =
          countOf(connection_, "SELECT max(number_in_group) FROM enrolment WHERE group_id = ?", {group});
    }
    return ++last->second;
  }

  void takePlan(const SitePackageRow& row) {
    const auto id = std::find(row.columns.begin(), row.columns.end(), "id");
    if (const std::optional<std::string> here = found(row)) {
      if (id != row.columns.end()) {
        ids_[textOf(row.values[static_cast<std::size_t>(id - row.columns.begin())])] = *here;
      }
      return;
    }
    insert(row);
    ++added;
  }

  void takeRow(const SitePackageRow& row, const std::string& key) {
    if (row.table == "trial_chunk") {
      takeChunk(row);
      return;
    }
    const SealRule* rule = sealRuleOf(row.table);
    if (rule == nullptr) {
      breaksRules();
    }
    if (rule->sealing == Sealing::kWithParent) {
      if (newParents_.contains(std::string(rule->parent) + "/" + key.substr(0, key.find('/')))) {
        insert(row);
        ++added;
      }
      return;
    }
    const std::string place = row.table + "/" + key;
    const auto known = known_.find(place);
    if (known == known_.end()) {
      insert(row);
      ++added;
      newParents_.insert(place);
      brought_.push_back({row.table, key, row.seal});
      return;
    }
    if (known->second.centreId != site_.centreId) {
      differs(row.table, key, Text::tr("belongs to another centre"));
    }
    if (known->second.seal == row.seal) {
      return;
    }
    if (rule->sealing == Sealing::kOnce) {
      differs(row.table, key, Text::tr("is not what the centre delivered before under this id"));
    }
    change(row, *rule, key);
  }

  [[noreturn]] void differs(const std::string& table, const std::string& key, const Phrase& how) const {
    throw Error(
        ErrorCode::kVerifyFailed,
        Text::tr("centre %1: the row %2 of the table %3 %4", site_.code, plainLine(key, 80), table, how),
        package_.manifest.centreName, Text::tr("Ask the centre; nothing was taken from the package"));
  }

  /// A chunk has its own digest; verification decodes all of them against the hash of their recording.
  void takeChunk(const SitePackageRow& row) {
    if (wholeTrials_.contains(textOf(row.values[place_.front()]))) {
      return;
    }
    const std::optional<std::string> here = found(row);
    if (!here) {
      insert(row);
      ++added;
    }
  }

  /// A state that went on: a person who left, an enrolment that ended.
  void change(const SitePackageRow& row, const SealRule& rule, const std::string& key) {
    const std::vector<std::string> keys = columnsOf(rule.key);
    std::string set;
    std::vector<Value> values;
    std::vector<Value> keyValues;
    for (std::size_t i = 0; i < row.columns.size(); ++i) {
      const std::string& column = row.columns[i];
      if (std::find(keys.begin(), keys.end(), column) != keys.end()) {
        keyValues.push_back(row.values[i]);
      } else if (column == "state" || column == "group_id" || column == "cancelled" ||
                 column == "class_code" || column == "handedness" || column == "sex" || column == "level") {
        set += (set.empty() ? "" : ", ") + column + " = ?";
        values.push_back(row.values[i]);
      }
    }
    std::string where;
    for (const std::string& column : keys) {
      where += (where.empty() ? "" : " AND ") + column + " = ?";
    }
    if (!set.empty()) {
      values.insert(values.end(), keyValues.begin(), keyValues.end());
      connection_.prepare("UPDATE " + row.table + " SET " + set + " WHERE " + where).execute(values);
    }
    Statement after = connection_.prepare("SELECT * FROM " + row.table + " WHERE " + where);
    after.execute(keyValues);
    if (!after.step()) {
      breaksRules();
    }
    const std::vector<Value> stored = valuesOf(after);
    const SealShape shape(rule, columnNamesOf(after));
    changedSeals_.push_back(sealedRow(shape, stored, sealOf(shape.kept(stored), {})));
    ++changed;
    brought_.push_back({row.table, key, row.seal});
  }

  Connection& connection_;
  const CheckedPackage& package_;
  Site site_;
  SiteDelivery& delivery_;
  SiteSealer sealer_;
  std::map<std::string, SchemaTable> tables_;
  std::unordered_map<std::string, SiteRepository::Row> known_;  // by "table/key"
  std::unordered_set<std::string> wholeTrials_;                 // ended when they came
  std::unordered_map<std::string, std::string> ids_;            // of plan rows, by the package's
  std::unordered_map<std::string, std::int64_t> lastInGroup_;
  std::unordered_set<std::string> newParents_;
  std::vector<Brought> brought_;
  std::vector<RowSeal> changedSeals_;
  const SiteTable* table_ = nullptr;
  std::vector<char> boolean_;
  std::vector<std::size_t> place_;
  std::optional<Statement> insert_;
  std::optional<Statement> find_;
};

std::string freeCode(const std::vector<Site>& sites, const SiteManifest& manifest) {
  const auto taken = [&](const std::string& code) {
    return std::any_of(sites.begin(), sites.end(), [&](const Site& one) { return one.code == code; });
  };
  std::string code = manifest.centreCode;
  for (std::size_t digits = 4; taken(code); digits += 4) {
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

PoolOutcome takeIn(SessionContext& session, const std::filesystem::path& file, const CheckedPackage& package,
                   const ProgressCallback& progress) {
  Connection& connection = session.connection();
  const SiteManifest& manifest = package.manifest;
  PoolOutcome outcome{.manifest = manifest};
  SiteRepository repository(connection);
  const std::vector<Site> sites = repository.sites();
  const auto known = std::find_if(sites.begin(), sites.end(),
                                  [&](const Site& one) { return one.centreId == manifest.centreId; });
  SiteDelivery delivery{
      .id = session.ids().newUuid(),
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
  Site site{manifest.centreId, {}, manifest.centreName, manifest.publicKey, session.now_us(),
            manifest.simulated};
  if (known == sites.end()) {
    site.code = freeCode(sites, manifest);
  } else {
    site = *known;
    outcome.siteCode = site.code;
    if (site.publicKey != manifest.publicKey) {
      throw Error(ErrorCode::kVerifyFailed,
                  Text::tr("is signed with another key than the earlier packages of centre %1", site.code),
                  file.string(), Text::tr("Ask the centre who made it; nothing was taken from it"));
    }
    for (const SiteDelivery& earlier : repository.deliveries()) {
      if (earlier.centreId != manifest.centreId) {
        continue;
      }
      delivery.sequence = earlier.sequence + 1;
      if (earlier.packageHash == package.hash) {
        outcome.kind = Pooled::kRepeated;
        outcome.earlierUtc_us = earlier.receivedUtc_us;
        return outcome;
      }
      if (earlier.trailLength > manifest.trailLength ||
          (earlier.trailLength == manifest.trailLength && earlier.trailHash != manifest.trailHash)) {
        outcome.kind = Pooled::kOlder;
        outcome.earlierUtc_us = earlier.madeUtc_us;
      }
    }
    if (outcome.kind == Pooled::kOlder) {
      return outcome;
    }
  }
  outcome.siteCode = site.code;
  if (!sites.empty()) {
    requireSameProtocol(connection, manifest, file);
  }
  ensurePool(session, manifest);
  if (known == sites.end()) {
    repository.add(site);
  }
  Intake intake(connection, package, site, delivery);
  std::int64_t all = 0;
  for (const auto& [table, rows] : manifest.rows) {
    all += rows;
  }
  std::int64_t done = 0;
  readSitePackage(file, package, [&](const SitePackageRow& row) {
    intake.take(row);
    if (++done % kTakenPerProgress == 0) {
      tellProgress(progress, Text::tr("Taking in the rows of %1", site.code),
                   0.1 + 0.7 * static_cast<double>(done) / static_cast<double>(all));
    }
  });
  outcome.rowsAdded = intake.added;
  outcome.rowsChanged = intake.changed;
  if (intake.added == 0 && intake.changed == 0) {
    outcome.kind = Pooled::kNothingNew;
    return outcome;
  }
  delivery.rowsAdded = intake.added;
  repository.add(delivery);
  intake.finish();
  const std::string reason = "package of centre " + site.code;
  session.note(AuditAction::kTrialImport, AuditObject::kCentre, site.centreId,
               {{"site", site.code},
                {"package", package.hash},
                {"trail", manifest.trailHash},
                {"rows", intake.added},
                {"changed", intake.changed},
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
    if (outcome.kind == Pooled::kAdded) {
      tellProgress(progress, Text::tr("Checking the pooled record"), 0.85);
      requireSound(connection, Text::tr("with this package the record does not verify"));
      transaction.commit();
    }
    return outcome;
  } catch (const DbError&) {
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
    state.site = std::move(site);
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace torsio
