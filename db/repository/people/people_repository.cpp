// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/people_repository.h"

#include <cstdint>

#include "assessment/domain/ids.h"
#include "db/repository/base/row_columns.h"

namespace torsio {

namespace {

constexpr auto kPerson = rowColumns<Person>(
    "person", "id, code, sex, level, experience, age_years, state, created_utc_us, demonstration",
    &Person::id, &Person::code, OrNull{&Person::sex}, OrNull{&Person::level}, OrNull{&Person::experience},
    &Person::age_years, &Person::state, &Person::createdUtc_us, &Person::demonstration);
const std::string kTrainees =
    kPerson.select("p") + ", t.handedness FROM trainee t JOIN person p ON p.id = t.person_id";
const std::string kRaters = kPerson.select("p") +
                            ", r.class_code FROM rater r JOIN person p ON p.id = r.person_id"
                            " JOIN rater_class c ON c.code = r.class_code";
const std::string kIdentities = "SELECT person_id, full_name, email, external_id FROM person_identity";
const std::string kConsents =
    "SELECT c.person_id, c.purpose, c.granted, c.text_version, c.decided_utc_us, c.recorded_by,"
    " c.demonstration, c.form, c.signed_utc_us FROM consent c";

Trainee traineeOf(RowReader& row) {
  return {.person = kPerson(row), .handedness = row.text()};
}

Rater raterOf(RowReader& row) {
  return {.person = kPerson(row), .classCode = row.text()};
}

Identity identityOf(RowReader& row) {
  return {.personId = row.text(), .fullName = row.text(), .email = row.text(), .externalId = row.text()};
}

ConsentDecision consentOf(RowReader& row) {
  return {.personId = row.text(),
          .purpose = row.text(),
          .granted = row.boolean(),
          .textVersion = row.text(),
          .decidedUtc_us = row.int64(),
          .recordedBy = row.text(),
          .demonstration = row.boolean(),
          .form = readTerm<ConsentForm>(row),
          .signedUtc_us = row.maybeInt64().value_or(0)};
}

}  // namespace

void PeopleRepository::addRaterClasses(std::span<const SeniorityClass> classes) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(insertInto("rater_class", "code, label, position"));
  for (const SeniorityClass& raterClass : classes) {
    insert.execute({raterClass.code, raterClass.label, raterClass.position});
  }
  transaction.commit();
}

std::vector<SeniorityClass> PeopleRepository::raterClasses() const {
  return selectAll(connection_, "SELECT code, label, position FROM rater_class ORDER BY position, code", {},
                   [](RowReader& row) {
                     return SeniorityClass{row.text(), row.text(), row.int64()};
                   });
}

void PeopleRepository::addTrainees(std::span<const Trainee> trainees) {
  Transaction transaction(connection_);
  Statement person = connection_.prepare(kPerson.insert());
  Statement part = connection_.prepare(insertInto("trainee", "person_id, handedness"));
  for (const Trainee& trainee : trainees) {
    person.execute(kPerson.values(trainee.person));
    part.execute({trainee.person.id, textOrNull(trainee.handedness)});
  }
  transaction.commit();
}

void PeopleRepository::addRaters(std::span<const Rater> raters) {
  Transaction transaction(connection_);
  Statement person = connection_.prepare(kPerson.insert());
  for (const Rater& rater : raters) {
    person.execute(kPerson.values(rater.person));
    makeRater(rater.person.id, rater.classCode);
  }
  transaction.commit();
}

void PeopleRepository::makeRater(const PersonId& personId, const std::string& classCode) {
  connection_.execute(insertInto("rater", "person_id, class_code"), {personId, classCode});
}

void PeopleRepository::makeTrainee(const PersonId& personId, const std::string& handedness) {
  connection_.execute(insertInto("trainee", "person_id, handedness"), {personId, textOrNull(handedness)});
}

void PeopleRepository::updatePerson(const Person& person) {
  connection_.execute(
      "UPDATE person SET sex = ?, level = ?, experience = ?, age_years = ?, state = ? WHERE id = ?",
      {textOrNull(person.sex), textOrNull(person.level), textOrNull(person.experience), person.age_years,
       storedText(person.state), person.id});
}

void PeopleRepository::setHandedness(const PersonId& personId, const std::string& handedness) {
  connection_.execute("UPDATE trainee SET handedness = ? WHERE person_id = ?",
                      {textOrNull(handedness), personId});
}

void PeopleRepository::setRaterClass(const PersonId& personId, const std::string& classCode) {
  connection_.execute("UPDATE rater SET class_code = ? WHERE person_id = ?", {classCode, personId});
}

std::optional<Person> PeopleRepository::find(const PersonId& personId) const {
  return selectFirst(connection_, kPerson.select("p") + " FROM person p WHERE p.id = ?", {personId}, kPerson);
}

std::vector<std::string> PeopleRepository::codes() const {
  return selectAll(connection_, "SELECT code FROM person", {}, readText);
}

std::vector<Trainee> PeopleRepository::trainees() const {
  return selectAll(connection_, kTrainees + " ORDER BY p.code", {}, traineeOf);
}

std::vector<Rater> PeopleRepository::raters() const {
  return selectAll(connection_, kRaters + " ORDER BY c.position, p.code", {}, raterOf);
}

std::optional<Trainee> PeopleRepository::findTrainee(const std::string& code) const {
  return selectFirst(connection_, kTrainees + " WHERE p.code = ?", {code}, traineeOf);
}

std::optional<Rater> PeopleRepository::findRater(const std::string& code) const {
  return selectFirst(connection_, kRaters + " WHERE p.code = ?", {code}, raterOf);
}

std::optional<Identity> PeopleRepository::identity(const PersonId& personId) const {
  return selectFirst(connection_, kIdentities + " WHERE person_id = ?", {personId}, identityOf);
}

void PeopleRepository::setIdentity(const Identity& identity) {
  connection_.execute(
      insertInto("person_identity", "person_id, full_name, email, external_id") +
          " ON CONFLICT (person_id) DO UPDATE SET full_name = excluded.full_name, email ="
          " excluded.email, external_id = excluded.external_id",
      {identity.personId, identity.fullName, textOrNull(identity.email), textOrNull(identity.externalId)});
}

std::optional<Identity> PeopleRepository::identityByExternalId(const std::string& externalId) const {
  return selectFirst(connection_, kIdentities + " WHERE external_id = ?", {externalId}, identityOf);
}

std::vector<Identity> PeopleRepository::identities() const {
  return selectAll(connection_, kIdentities, {}, identityOf);
}

void PeopleRepository::recordConsent(const ConsentDecision& consent) {
  connection_.execute(
      "INSERT INTO consent (person_id, purpose, sequence, granted, text_version, decided_utc_us, recorded_by,"
      " demonstration, form, signed_utc_us) VALUES (?, ?, (SELECT COALESCE(MAX(c.sequence), 0) + 1"
      " FROM consent c WHERE c.person_id = ? AND c.purpose = ?), ?, ?, ?, ?, ?, ?, ?)",
      {consent.personId, consent.purpose, consent.personId, consent.purpose, consent.granted,
       consent.textVersion, consent.decidedUtc_us, consent.recordedBy, consent.demonstration,
       storedText(consent.form),
       consent.form == ConsentForm::kPaper ? Value(consent.signedUtc_us) : Value()});
}

std::vector<ConsentDecision> PeopleRepository::consents(const PersonId& personId) const {
  return selectAll(connection_,
                   kConsents + " WHERE c.person_id = ? ORDER BY c.decided_utc_us, c.purpose, c.sequence",
                   {personId}, consentOf);
}

std::vector<ConsentDecision> PeopleRepository::newestConsents() const {
  return selectAll(connection_,
                   kConsents +
                       " WHERE c.sequence = (SELECT MAX(n.sequence) FROM consent n"
                       " WHERE n.person_id = c.person_id AND n.purpose = c.purpose)"
                       " ORDER BY c.person_id, c.purpose",
                   {}, consentOf);
}

bool PeopleRepository::hasConsent(const PersonId& personId, const std::string& purpose) const {
  return selectFirst(
             connection_,
             "SELECT granted FROM consent WHERE person_id = ? AND purpose = ? ORDER BY sequence DESC LIMIT 1",
             {personId, purpose}, readBoolean)
      .value_or(false);
}

namespace {

std::vector<ConsentWords> wordsOf(Connection& connection, const std::string& versionId) {
  Statement statement = connection.prepare(
      "SELECT language, purpose, title, words FROM consent_text WHERE version_id = ?"
      " ORDER BY language, position");
  statement.execute({versionId});
  std::vector<ConsentWords> languages;
  while (statement.step()) {
    RowReader row(statement);
    const std::string language = row.text();
    if (languages.empty() || languages.back().language != language) {
      languages.push_back({language, {}});
    }
    languages.back().texts.push_back({row.text(), row.text(), row.text()});
  }
  return languages;
}

}  // namespace

std::vector<std::string> ConsentRepository::purposes() const {
  return selectAll(connection_, "SELECT code FROM consent_purpose ORDER BY position, code", {}, readText);
}

void ConsentRepository::addPurpose(const std::string& code) {
  connection_.execute(
      "INSERT INTO consent_purpose (code, position)"
      " VALUES (?, (SELECT COALESCE(MAX(p.position), 0) + 1 FROM consent_purpose p))",
      {code});
}

std::vector<ConsentVersion> ConsentRepository::versions() const {
  return selectAll(
      connection_,
      "SELECT id, number, note, published_by, published_utc_us FROM consent_version ORDER BY number", {},
      [this](RowReader& row) {
        ConsentVersion version;
        version.id = row.text();
        version.number = row.int64();
        version.note = row.text();
        version.publishedBy = row.text();
        version.publishedUtc_us = row.int64();
        version.languages = wordsOf(connection_, version.id);
        return version;
      });
}

void ConsentRepository::add(const ConsentVersion& version) {
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("consent_version", "id, number, note, published_by, published_utc_us"),
      {version.id, version.number, version.note, version.publishedBy, version.publishedUtc_us});
  Statement insert = connection_.prepare(
      insertInto("consent_text", "version_id, language, purpose, position, title, words"));
  for (const ConsentWords& words : version.languages) {
    std::int64_t position = 0;
    for (const ConsentText& text : words.texts) {
      insert.execute({version.id, words.language, text.purpose, ++position, text.title, text.text});
    }
  }
  transaction.commit();
}

}  // namespace torsio
