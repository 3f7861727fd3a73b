// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/roster_undo.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/people/people_service.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/person.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/people/roster_import_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

PersonEntry entryFrom(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text);
  PersonEntry entry{.fullName = json.at("full_name"),
                    .externalId = json.at("external_id"),
                    .email = json.at("email"),
                    .sex = json.at("sex"),
                    .level = json.at("level"),
                    .experience = json.at("experience"),
                    .trainee = json.at("trainee"),
                    .handedness = json.at("handedness"),
                    .raterClass = json.at("rater_class")};
  if (json.contains("age_years")) {
    entry.age_years = json.at("age_years").get<std::int64_t>();
  }
  return entry;
}

/// Names the kind of data that depend on a person.
Text dependentDataName(const std::string& table) {
  static const std::map<std::string, Phrase> kWords{
      {"app_user", Text::tr("has signed in")},
      {"enrolment", Text::tr("is enrolled in a cohort")},
      {"consent", Text::tr("has decided about a consent")},
      {"assignment", Text::tr("has been assigned sheets")},
      {"evaluation_rater", Text::tr("has been asked to evaluate models")},
      {"person_request", Text::tr("has a request about the record")}};
  const auto known = kWords.find(table);
  return known != kWords.end() ? Text(known->second) : Text::tr("already has entries in the record");
}

using EntriesById = std::map<PersonId, std::pair<std::string, PersonEntry>>;

/// Returns the current roster data of everybody, with codes.
EntriesById entriesNow(SessionContext& session) {
  EntriesById entries;
  for (const NamedPersonRow& named : namedPeople(session)) {
    entries[named.row.person.id] = {named.row.person.code, entryOf(named)};
  }
  return entries;
}

/// Returns why an import cannot be undone; empty if it can.
Text hindranceOf(SessionContext& session, const std::string& importId,
                 const std::vector<StoredRosterPerson>& people, const EntriesById& entries) {
  const RosterImportRepository repository(session.connection());
  if (const std::optional<HangingRow> hanging = repository.firstHanging(importId)) {
    return Text::tr("%1 %2", hanging->personCode, dependentDataName(hanging->table));
  }
  for (const StoredRosterPerson& imported : people) {
    const auto known = entries.find(imported.personId);
    if (known == entries.end()) {
      continue;  // erased since then: nothing to restore
    }
    const auto& [code, now] = known->second;
    if (rosterJson(now) != imported.afterJson) {
      return Text::tr("%1 was changed since", code);
    }
    if (!imported.beforeJson) {
      continue;
    }
    const PersonEntry before = entryFrom(*imported.beforeJson);
    std::string table;
    if (now.trainee && !before.trainee) {
      table = repository.tableNaming(PersonPart::kTrainee, imported.personId);
    }
    if (table.empty() && !now.raterClass.empty() && before.raterClass.empty()) {
      table = repository.tableNaming(PersonPart::kRater, imported.personId);
    }
    if (!table.empty()) {
      return Text::tr("%1 %2", code, dependentDataName(table));
    }
  }
  return people.empty() ? Text::tr("none of these people are left") : Text();
}

void undoPerson(SessionContext& session, const StoredRosterPerson& imported, const std::string& reason) {
  RosterImportRepository repository(session.connection());
  if (!imported.beforeJson) {
    erasePerson(session.connection(), imported.personId, session.actor().userId, reason, session.now_us());
    return;
  }
  const PersonEntry now = personEntry(session, imported.personId);
  const PersonEntry before = entryFrom(*imported.beforeJson);
  if (now.trainee && !before.trainee) {
    repository.removePart(PersonPart::kTrainee, imported.personId);
  }
  if (!now.raterClass.empty() && before.raterClass.empty()) {
    repository.removePart(PersonPart::kRater, imported.personId);
  }
  changePerson(session, imported.personId, before, reason);
}

void takeBack(SessionContext& session, const std::string& importId, const std::string& reason) {
  RosterImportRepository repository(session.connection());
  const std::vector<StoredRosterPerson> people = repository.people(importId);
  if (const Text hindrance = hindranceOf(session, importId, people, entriesNow(session));
      !hindrance.empty()) {
    refuse(
        hindrance, importId,
        Text::tr(
            "Nothing was undone. Mark those who should not be here as \"left\", or erase them one by one"));
  }
  repository.takeBack(importId, session.now_us());
  std::size_t restored = 0;
  for (const StoredRosterPerson& person : people) {
    restored += person.beforeJson ? 1 : 0;
    undoPerson(session, person, reason);
  }
  session.note(
      {.action = AuditAction::kRosterImport,
       .objectKind = AuditObject::kPerson,
       .objectId = importId,
       .newJson =
           nlohmann::json{{"taken_back", true}, {"erased", people.size() - restored}, {"restored", restored}}
               .dump(),
       .reason = reason});
}

}  // namespace

std::string rosterJson(const PersonEntry& entry) {
  nlohmann::json json{{"full_name", entry.fullName},    {"external_id", entry.externalId},
                      {"email", entry.email},           {"sex", entry.sex},
                      {"level", entry.level},           {"experience", entry.experience},
                      {"trainee", entry.trainee},       {"handedness", entry.handedness},
                      {"rater_class", entry.raterClass}};
  if (entry.age_years) {
    json["age_years"] = *entry.age_years;
  }
  return json.dump();
}

void keepImport(SessionContext& session, RosterKind kind, const std::vector<StoredRosterPerson>& people) {
  const std::int64_t changed =
      std::count_if(people.begin(), people.end(),
                    [](const StoredRosterPerson& person) { return person.beforeJson.has_value(); });
  RosterImportRepository(session.connection())
      .add({.id = session.ids().newUuid(),
            .kind = kind == RosterKind::kTrainees ? "trainees" : "raters",
            .importedBy = session.actor().userId,
            .importedUtc_us = session.now_us(),
            .added = static_cast<std::int64_t>(people.size()) - changed,
            .changed = changed},
           people);
}

std::vector<ImportedRoster> importedRosters(SessionContext& session) {
  session.require(Operation::kPersonEdit);
  session.require(Operation::kPersonViewIdentity);
  RosterImportRepository repository(session.connection());
  const EntriesById entries = entriesNow(session);
  std::map<std::string, std::string> logins;
  for (const UserAccount& user : AccessRepository(session.connection()).users()) {
    logins[user.id] = user.login;
  }
  std::vector<ImportedRoster> all;
  for (const StoredRosterImport& stored : repository.all()) {
    ImportedRoster one{.id = stored.id,
                       .kind = stored.kind == "raters" ? RosterKind::kRaters : RosterKind::kTrainees,
                       .importedBy = logins[stored.importedBy],
                       .importedUtc_us = stored.importedUtc_us,
                       .added = stored.added,
                       .changed = stored.changed,
                       .takenBack = stored.takenBackUtc_us.has_value()};
    const std::vector<StoredRosterPerson> people = repository.people(stored.id);
    for (const StoredRosterPerson& person : people) {
      if (const auto known = entries.find(person.personId); known != entries.end()) {
        one.codes.push_back(known->second.first);
      }
    }
    if (!one.takenBack) {
      one.hindrance = hindranceOf(session, stored.id, people, entries);
    }
    all.push_back(std::move(one));
  }
  return all;
}

void takeBackRosters(SessionContext& session, std::span<const std::string> importIds,
                     const std::string& reason) {
  session.require(Operation::kPersonEdit);
  session.require(Operation::kPersonViewIdentity);
  session.require(Operation::kPersonErase);
  if (reason.empty()) {
    refuse(Text::tr("the reason is missing"), Text::tr("import"), Text::tr("Say in a few words why"));
  }
  Transaction transaction(session.connection());
  std::vector<std::string> newestFirst;
  for (const StoredRosterImport& known : RosterImportRepository(session.connection()).all()) {
    if (std::find(importIds.begin(), importIds.end(), known.id) != importIds.end()) {
      newestFirst.push_back(known.id);
    }
  }
  for (const std::string& asked : importIds) {
    if (std::find(newestFirst.begin(), newestFirst.end(), asked) == newestFirst.end()) {
      refuse(Text::tr("there is no such import"), asked, Text::tr("Read the list again"));
    }
  }
  for (const std::string& importId : newestFirst) {
    takeBack(session, importId, reason);
  }
  transaction.commit();
}

}  // namespace torsio
