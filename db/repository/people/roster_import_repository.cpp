// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/roster_import_repository.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "db/connection/row_reader.h"
#include "db/repository/people/person_data.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Tables filled by the roster itself, or by an unused account.
constexpr std::array<std::string_view, 11> kOfTheRoster{
    "person",   "person_identity", "trainee",    "rater",       "roster_import_person", "user_role",
    "app_user", "kiosk_code",      "invitation", "audit_entry", "station_state"};
/// Tables that refer to a person as a trainee.
constexpr std::array<std::string_view, 3> kOnTrainee{"enrolment", "self_score", "trial"};
constexpr std::array<std::string_view, 4> kOnRater{"assignment", "evaluation_rater", "rater_warmup",
                                                   "trial_question"};

}  // namespace

void RosterImportRepository::add(const StoredRosterImport& import,
                                 const std::vector<StoredRosterPerson>& people) {
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("roster_import", "id, kind, imported_by, imported_utc_us, added, changed"),
      {import.id, import.kind, import.importedBy, import.importedUtc_us, import.added, import.changed});
  for (const StoredRosterPerson& person : people) {
    connection_.execute(insertInto("roster_import_person", "person_id, import_id, before_json, after_json"),
                        {person.personId, import.id, person.beforeJson ? Value(*person.beforeJson) : Value(),
                         person.afterJson});
  }
  transaction.commit();
}

std::vector<StoredRosterImport> RosterImportRepository::all() const {
  return selectAll(connection_,
                   "SELECT id, kind, imported_by, imported_utc_us, added, changed, taken_back_utc_us"
                   " FROM roster_import ORDER BY imported_utc_us DESC, id",
                   {}, [](RowReader& row) {
                     return StoredRosterImport{row.text(),  row.text(),  row.text(),      row.int64(),
                                               row.int64(), row.int64(), row.maybeInt64()};
                   });
}

std::vector<StoredRosterPerson> RosterImportRepository::people(const std::string& importId) const {
  return selectAll(connection_,
                   "SELECT i.person_id, i.before_json, i.after_json FROM roster_import_person i"
                   " JOIN person p ON p.id = i.person_id WHERE i.import_id = ? ORDER BY p.code",
                   {importId}, [](RowReader& row) {
                     StoredRosterPerson person{.personId = row.text()};
                     if (std::string before = row.text(); !before.empty()) {
                       person.beforeJson = std::move(before);
                     }
                     person.afterJson = row.text();
                     return person;
                   });
}

void RosterImportRepository::takeBack(const std::string& importId, std::int64_t utc_us) {
  const std::int64_t changed = connection_.execute(
      "UPDATE roster_import SET taken_back_utc_us = ? WHERE id = ? AND taken_back_utc_us IS NULL",
      {utc_us, importId});
  if (changed != 1) {
    refuse(Text::tr("this import has already been undone, or does not exist"), importId,
           Text::tr("Read the list again"));
  }
}

void RosterImportRepository::removePart(PersonPart part, const PersonId& personId) {
  const char* table = part == PersonPart::kTrainee ? "trainee" : "rater";
  connection_.execute(std::string("DELETE FROM ") + table + " WHERE person_id = ?", {personId});
}

std::optional<HangingRow> RosterImportRepository::firstHanging(const std::string& importId) const {
  const auto first = [&](const std::string& table, std::string condition) {
    for (std::size_t at = condition.find('?'); at != std::string::npos; at = condition.find('?', at)) {
      condition.replace(at, 1, "i.person_id");
    }
    return selectFirst(connection_,
                       "SELECT p.code FROM roster_import_person i JOIN person p ON p.id = i.person_id"
                       " WHERE i.import_id = ? AND i.before_json IS NULL AND EXISTS (SELECT 1 FROM " +
                           table + " WHERE " + condition + ") ORDER BY p.code LIMIT 1",
                       {importId}, [&table](RowReader& row) {
                         return HangingRow{row.text(), table};
                       });
  };
  if (auto used = first("app_user", "person_id = ? AND must_change_password = FALSE")) {
    return used;
  }
  for (const PersonRule& rule : kPersonRules) {
    if (rule.condition.empty() ||
        std::find(kOfTheRoster.begin(), kOfTheRoster.end(), rule.table) != kOfTheRoster.end()) {
      continue;
    }
    if (auto found = first(std::string(rule.table), std::string(rule.condition))) {
      return found;
    }
  }
  return std::nullopt;
}

std::string RosterImportRepository::tableNaming(PersonPart part, const PersonId& personId) const {
  const bool trainee = part == PersonPart::kTrainee;
  const std::span<const std::string_view> tables =
      trainee ? std::span<const std::string_view>(kOnTrainee) : kOnRater;
  for (const std::string_view table : tables) {
    const std::string count = "SELECT count(*) FROM " + std::string(table) + " WHERE " +
                              (trainee ? "trainee_id = ?" : "rater_id = ?");
    if (selectFirst(connection_, count, {personId}, readInt64).value_or(0) > 0) {
      return std::string(table);
    }
  }
  return {};
}

}  // namespace torsio
