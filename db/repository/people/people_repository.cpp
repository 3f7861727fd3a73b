// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/people_repository.h"

namespace torsio {

namespace {

constexpr const char* kInsertPerson =
    "INSERT INTO person (id, code, sex, level, experience, age_years, state, created_utc_us, demonstration)"
    " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)";
constexpr const char* kTrainees =
    "SELECT p.id, p.code, p.sex, p.level, p.experience, p.age_years, p.state, p.created_utc_us,"
    " p.demonstration, t.handedness FROM trainee t JOIN person p ON p.id = t.person_id";
constexpr const char* kRaters =
    "SELECT p.id, p.code, p.sex, p.level, p.experience, p.age_years, p.state, p.created_utc_us,"
    " p.demonstration, r.class_code FROM rater r JOIN person p ON p.id = r.person_id"
    " JOIN rater_class c ON c.code = r.class_code";
constexpr int kPersonColumns = 9;

void insertPerson(Statement& insert, const StoredPerson& person) {
  insert.execute({person.id, person.code, textOrNull(person.sex), textOrNull(person.level),
                  textOrNull(person.experience), person.age_years, person.state, person.createdUtc_us,
                  person.demonstration});
}

StoredPerson personOf(const Statement& row) {
  return {.id = row.text(0),
          .code = row.text(1),
          .sex = row.text(2),
          .level = row.text(3),
          .experience = row.text(4),
          .age_years = row.maybeInt64(5),
          .state = row.text(6),
          .createdUtc_us = row.int64(7),
          .demonstration = row.boolean(8)};
}

}  // namespace

void PeopleRepository::addRaterClasses(std::span<const StoredRaterClass> classes) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare("INSERT INTO rater_class (code, label, position) VALUES (?, ?, ?)");
  for (const StoredRaterClass& raterClass : classes) {
    insert.execute({raterClass.code, raterClass.label, raterClass.position});
  }
  transaction.commit();
}

std::vector<StoredRaterClass> PeopleRepository::raterClasses() {
  std::vector<StoredRaterClass> classes;
  Statement row =
      connection_.prepare("SELECT code, label, position FROM rater_class ORDER BY position, code");
  row.execute();
  while (row.step()) classes.push_back({row.text(0), row.text(1), row.int64(2)});
  return classes;
}

void PeopleRepository::addTrainees(std::span<const StoredTrainee> trainees) {
  Transaction transaction(connection_);
  Statement person = connection_.prepare(kInsertPerson);
  Statement part = connection_.prepare("INSERT INTO trainee (person_id, handedness) VALUES (?, ?)");
  for (const StoredTrainee& trainee : trainees) {
    insertPerson(person, trainee.person);
    part.execute({trainee.person.id, textOrNull(trainee.handedness)});
  }
  transaction.commit();
}

void PeopleRepository::addRaters(std::span<const StoredRater> raters) {
  Transaction transaction(connection_);
  Statement person = connection_.prepare(kInsertPerson);
  for (const StoredRater& rater : raters) {
    insertPerson(person, rater.person);
    makeRater(rater.person.id, rater.classCode);
  }
  transaction.commit();
}

void PeopleRepository::makeRater(const std::string& personId, const std::string& classCode) {
  connection_.execute("INSERT INTO rater (person_id, class_code) VALUES (?, ?)", {personId, classCode});
}

void PeopleRepository::makeTrainee(const std::string& personId, const std::string& handedness) {
  connection_.execute("INSERT INTO trainee (person_id, handedness) VALUES (?, ?)",
                      {personId, textOrNull(handedness)});
}

void PeopleRepository::updatePerson(const StoredPerson& person) {
  connection_.execute(
      "UPDATE person SET sex = ?, level = ?, experience = ?, age_years = ?, state = ? WHERE id = ?",
      {textOrNull(person.sex), textOrNull(person.level), textOrNull(person.experience), person.age_years,
       person.state, person.id});
}

void PeopleRepository::setHandedness(const std::string& personId, const std::string& handedness) {
  connection_.execute("UPDATE trainee SET handedness = ? WHERE person_id = ?",
                      {textOrNull(handedness), personId});
}

void PeopleRepository::setRaterClass(const std::string& personId, const std::string& classCode) {
  connection_.execute("UPDATE rater SET class_code = ? WHERE person_id = ?", {classCode, personId});
}

std::optional<StoredPerson> PeopleRepository::find(const std::string& personId) {
  Statement row = connection_.prepare(
      "SELECT id, code, sex, level, experience, age_years, state, created_utc_us, demonstration FROM person"
      " WHERE id = ?");
  row.execute({personId});
  if (!row.step()) return std::nullopt;
  return personOf(row);
}

std::vector<std::string> PeopleRepository::codes() {
  std::vector<std::string> codes;
  Statement row = connection_.prepare("SELECT code FROM person");
  row.execute();
  while (row.step()) codes.push_back(row.text(0));
  return codes;
}

std::vector<StoredTrainee> PeopleRepository::trainees() {
  std::vector<StoredTrainee> trainees;
  Statement row = connection_.prepare(std::string(kTrainees) + " ORDER BY p.code");
  row.execute();
  while (row.step()) trainees.push_back({personOf(row), row.text(kPersonColumns)});
  return trainees;
}

std::vector<StoredRater> PeopleRepository::raters() {
  std::vector<StoredRater> raters;
  Statement row = connection_.prepare(std::string(kRaters) + " ORDER BY c.position, p.code");
  row.execute();
  while (row.step()) raters.push_back({personOf(row), row.text(kPersonColumns)});
  return raters;
}

std::optional<StoredTrainee> PeopleRepository::findTrainee(const std::string& code) {
  Statement row = connection_.prepare(std::string(kTrainees) + " WHERE p.code = ?");
  row.execute({code});
  if (!row.step()) return std::nullopt;
  return StoredTrainee{personOf(row), row.text(kPersonColumns)};
}

std::optional<StoredRater> PeopleRepository::findRater(const std::string& code) {
  Statement row = connection_.prepare(std::string(kRaters) + " WHERE p.code = ?");
  row.execute({code});
  if (!row.step()) return std::nullopt;
  return StoredRater{personOf(row), row.text(kPersonColumns)};
}

void PeopleRepository::addIdentities(std::span<const StoredIdentity> identities) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(
      "INSERT INTO person_identity (person_id, full_name, email, external_id) VALUES (?, ?, ?, ?)");
  for (const StoredIdentity& identity : identities) {
    insert.execute(
        {identity.personId, identity.fullName, textOrNull(identity.email), textOrNull(identity.externalId)});
  }
  transaction.commit();
}

std::optional<StoredIdentity> PeopleRepository::identity(const std::string& personId) {
  Statement row = connection_.prepare(
      "SELECT person_id, full_name, email, external_id FROM person_identity WHERE person_id = ?");
  row.execute({personId});
  if (!row.step()) return std::nullopt;
  return StoredIdentity{row.text(0), row.text(1), row.text(2), row.text(3)};
}

void PeopleRepository::setIdentity(const StoredIdentity& identity) {
  connection_.execute(
      "INSERT INTO person_identity (person_id, full_name, email, external_id) VALUES (?, ?, ?, ?)"
      " ON CONFLICT (person_id) DO UPDATE SET full_name = excluded.full_name, email = excluded.email,"
      " external_id = excluded.external_id",
      {identity.personId, identity.fullName, textOrNull(identity.email), textOrNull(identity.externalId)});
}

std::optional<StoredIdentity> PeopleRepository::identityByExternalId(const std::string& externalId) {
  Statement row = connection_.prepare(
      "SELECT person_id, full_name, email, external_id FROM person_identity WHERE external_id = ?");
  row.execute({externalId});
  if (!row.step()) return std::nullopt;
  return StoredIdentity{row.text(0), row.text(1), row.text(2), row.text(3)};
}

std::vector<StoredIdentity> PeopleRepository::identities() {
  std::vector<StoredIdentity> identities;
  Statement row = connection_.prepare("SELECT person_id, full_name, email, external_id FROM person_identity");
  row.execute();
  while (row.step()) identities.push_back({row.text(0), row.text(1), row.text(2), row.text(3)});
  return identities;
}

void PeopleRepository::recordConsent(const StoredConsent& consent) {
  connection_.execute(
      "INSERT INTO consent (person_id, purpose, sequence, granted, text_version, decided_utc_us, recorded_by,"
      " demonstration) VALUES (?, ?, (SELECT COALESCE(MAX(c.sequence), 0) + 1 FROM consent c"
      " WHERE c.person_id = ? AND c.purpose = ?), ?, ?, ?, ?, ?)",
      {consent.personId, consent.purpose, consent.personId, consent.purpose, consent.granted,
       consent.textVersion, consent.decidedUtc_us, consent.recordedBy, consent.demonstration});
}

std::vector<StoredConsent> PeopleRepository::consents(const std::string& personId) {
  std::vector<StoredConsent> consents;
  Statement row = connection_.prepare(
      "SELECT person_id, purpose, granted, text_version, decided_utc_us, recorded_by, demonstration"
      " FROM consent WHERE person_id = ? ORDER BY decided_utc_us, purpose, sequence");
  row.execute({personId});
  while (row.step()) {
    consents.push_back(
        {row.text(0), row.text(1), row.boolean(2), row.text(3), row.int64(4), row.text(5), row.boolean(6)});
  }
  return consents;
}

std::vector<StoredConsent> PeopleRepository::newestConsents() {
  std::vector<StoredConsent> consents;
  Statement row = connection_.prepare(
      "SELECT c.person_id, c.purpose, c.granted, c.text_version, c.decided_utc_us, c.recorded_by,"
      " c.demonstration FROM consent c WHERE c.sequence = (SELECT MAX(n.sequence) FROM consent n"
      " WHERE n.person_id = c.person_id AND n.purpose = c.purpose) ORDER BY c.person_id, c.purpose");
  row.execute();
  while (row.step()) {
    consents.push_back(
        {row.text(0), row.text(1), row.boolean(2), row.text(3), row.int64(4), row.text(5), row.boolean(6)});
  }
  return consents;
}

bool PeopleRepository::hasConsent(const std::string& personId, const std::string& purpose) {
  Statement row = connection_.prepare(
      "SELECT granted FROM consent WHERE person_id = ? AND purpose = ? ORDER BY sequence DESC LIMIT 1");
  row.execute({personId, purpose});
  return row.step() && row.boolean(0);
}

}  // namespace torsio
