// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/people_service.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/audit_service.h"
#include "app/services/base/csv_table.h"
#include "app/services/base/identifiers.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/consent.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/plausible.h"

namespace torsio {

namespace {

std::map<std::string, PersonRow> rowsById(PeopleRepository& repository) {
  std::map<std::string, PersonRow> rows;
  for (Trainee& trainee : repository.trainees()) {
    PersonRow& row = rows[trainee.person.id];
    row.trainee = true;
    row.handedness = trainee.handedness;
    row.person = std::move(trainee.person);
  }
  for (Rater& rater : repository.raters()) {
    PersonRow& row = rows[rater.person.id];
    row.rater = true;
    row.raterClass = rater.classCode;
    row.person = std::move(rater.person);
  }
  std::erase_if(rows, [](const auto& entry) { return entry.second.person.state == PersonState::kErased; });
  for (const ConsentDecision& consent : repository.newestConsents()) {
    const auto row = rows.find(consent.personId);
    if (row != rows.end() && consent.granted) {
      row->second.consents.push_back(consent.purpose);
    }
  }
  return rows;
}

std::vector<PersonRow> byCode(std::map<std::string, PersonRow> rows) {
  std::vector<PersonRow> list;
  for (auto& [id, row] : rows) {
    list.push_back(std::move(row));
  }
  std::sort(list.begin(), list.end(),
            [](const PersonRow& a, const PersonRow& b) { return a.person.code < b.person.code; });
  return list;
}

PersonRow rowOf(PeopleRepository& repository, const PersonId& personId) {
  const std::optional<Person> person = repository.find(personId);
  if (!person || person->state == PersonState::kErased) {
    refuse(Text::tr("there is no such person"), personId, Text::tr("Choose one from the list"));
  }
  PersonRow row;
  row.person = *person;
  if (const auto trainee = repository.findTrainee(person->code)) {
    row.trainee = true;
    row.handedness = trainee->handedness;
  }
  if (const auto rater = repository.findRater(person->code)) {
    row.rater = true;
    row.raterClass = rater->classCode;
  }
  return row;
}

/// Throws unless the texts can be read, compared and printed.
void checkTexts(const PersonEntry& entry) {
  const std::initializer_list<std::tuple<const std::string*, Text, std::size_t>> texts{
      {&entry.fullName, Text::tr("name"), kLongestField},
      {&entry.externalId, Text::tr("staff or student number"), kLongestNumber},
      {&entry.email, Text::tr("e-mail"), kLongestField},
      {&entry.level, Text::tr("level"), kLongestField},
      {&entry.experience, Text::tr("experience"), kLongestField}};
  for (const auto& [text, field, longest] : texts) {
    if (const Text flaw = flawOf(*text, longest); !flaw.empty()) {
      refuse(Text::tr("this text %1", flaw), field, Text::tr("Type it again"));
    }
  }
}

/// Throws if somebody else's number looks like this new one.
void requireNoLikeness(PeopleRepository& repository, const std::string& number, const PersonId& personId) {
  const std::string likeness = likenessOf(number);
  for (const Identity& other : repository.identities()) {
    if (other.personId != personId && !other.externalId.empty() && likenessOf(other.externalId) == likeness) {
      const auto person = repository.find(other.personId);
      refuse(Text::tr("the number %1 looks like that of %2, but is another", number,
                      person ? person->code : other.externalId),
             Text::tr("staff or student number"),
             Text::tr("Write it as in the record, or change one of the two"));
    }
  }
}

void checkEntry(PeopleRepository& repository, const PersonEntry& entry, const PersonId& personId) {
  checkTexts(entry);
  if (entry.fullName.empty()) {
    refuse(Text::tr("the name is missing"), Text::tr("name"), Text::tr("Enter the full name"));
  }
  if (!entry.trainee && entry.raterClass.empty()) {
    refuse(Text::tr("neither a trainee nor a rater"), Text::tr("role"),
           Text::tr("Choose at least one of the two"));
  }
  if (entry.age_years && !isPlausible(Stated::kAge, static_cast<double>(*entry.age_years))) {
    refuse(Text::tr("an age of %1 {year|years} is not likely", *entry.age_years), Text::tr("age"),
           Text::tr("Enter the age in years (%1), or leave it empty", plausibleRange(Stated::kAge)));
  }
  if (!entry.sex.empty() && !fromStoredText<Sex>(entry.sex)) {
    refuse(Text::tr("the sex is not known to the record"), Text::tr("sex"),
           Text::tr("Choose female, male, other or nothing"));
  }
  if (!entry.handedness.empty() && !fromStoredText<Handedness>(entry.handedness)) {
    refuse(Text::tr("the handedness is not known to the record"), Text::tr("handedness"),
           Text::tr("Choose left, right or nothing"));
  }
  const std::vector<SeniorityClass> classes = repository.raterClasses();
  if (!entry.raterClass.empty() &&
      std::none_of(classes.begin(), classes.end(),
                   [&](const SeniorityClass& known) { return known.code == entry.raterClass; })) {
    refuse(Text::tr("there is no such class of raters"), entry.raterClass,
           Text::tr("Choose one from the list"));
  }
  if (entry.externalId.empty()) {
    return;
  }
  const auto owner = repository.identityByExternalId(entry.externalId);
  if (owner && owner->personId != personId) {
    refuse(Text::tr("somebody else has this staff or student number"), entry.externalId,
           Text::tr("Open that person, or correct the number"));
  }
  if (!owner) {
    requireNoLikeness(repository, entry.externalId, personId);
  }
}

Person personFrom(const PersonEntry& entry, Person person) {
  person.sex = entry.sex;
  person.level = entry.level;
  person.experience = entry.experience;
  person.age_years = entry.age_years;
  return person;
}

/// Returns what the audit trail may know of a person: codes and allocation factors.
nlohmann::json codedJson(const Person& person, const std::string& handedness, const std::string& raterClass) {
  nlohmann::json json{{"code", person.code},      {"sex", person.sex},
                      {"level", person.level},    {"experience", person.experience},
                      {"handedness", handedness}, {"rater_class", raterClass}};
  if (person.age_years) {
    json["age_years"] = *person.age_years;
  }
  return json;
}

/// Returns the names of identity fields that differ, never their contents.
nlohmann::json changedIdentity(const Identity& before, const PersonEntry& after) {
  nlohmann::json fields = nlohmann::json::array();
  if (before.fullName != after.fullName) {
    fields.push_back("full_name");
  }
  if (before.email != after.email) {
    fields.push_back("email");
  }
  if (before.externalId != after.externalId) {
    fields.push_back("external_id");
  }
  return fields;
}

std::vector<std::string> codedCells(const PersonRow& row) {
  const Person& person = row.person;
  return {person.code,
          row.trainee ? "yes" : "no",
          row.raterClass,
          person.sex,
          person.level,
          person.experience,
          person.age_years ? std::to_string(*person.age_years) : "",
          row.handedness,
          std::string(storedText(person.state))};
}

}  // namespace

std::vector<PersonRow> people(SessionContext& session) {
  session.require(Operation::kPersonViewCoded);
  PeopleRepository repository(session.connection());
  return byCode(rowsById(repository));
}

std::vector<NamedPersonRow> namedPeople(SessionContext& session) {
  session.require(Operation::kPersonViewIdentity);
  PeopleRepository repository(session.connection());
  std::map<std::string, Identity> identities;
  for (Identity& identity : repository.identities()) {
    identities[identity.personId] = std::move(identity);
  }
  std::vector<NamedPersonRow> list;
  for (PersonRow& row : byCode(rowsById(repository))) {
    NamedPersonRow named;
    named.identity = identities[row.person.id];
    named.row = std::move(row);
    list.push_back(std::move(named));
  }
  return list;
}

PersonId addPerson(SessionContext& session, const PersonEntry& entry) {
  session.require(Operation::kPersonEdit);
  Transaction transaction(session.connection());
  PeopleRepository repository(session.connection());
  if (!entry.raterClass.empty()) {
    ensureRaterClasses(session);
  }
  checkEntry(repository, entry, "");
  const std::vector<std::string> codes = repository.codes();
  PersonCodes next({codes.begin(), codes.end()});
  Person person = personFrom(entry, {});
  person.id = session.ids().newUuid();
  person.code = next.next(entry.trainee ? kTraineePrefix : kRaterPrefix);
  person.createdUtc_us = session.now_us();
  if (entry.trainee) {
    repository.addTrainees(std::vector<Trainee>{{person, entry.handedness}});
    if (!entry.raterClass.empty()) {
      repository.makeRater(person.id, entry.raterClass);
    }
  } else {
    repository.addRaters(std::vector<Rater>{{person, entry.raterClass}});
  }
  repository.setIdentity({person.id, entry.fullName, entry.email, entry.externalId});
  session.note(AuditAction::kPersonAdd, AuditObject::kPerson, person.id,
               codedJson(person, entry.handedness, entry.raterClass));
  transaction.commit();
  return person.id;
}

PersonEntry entryOf(const NamedPersonRow& named) {
  const auto& [row, identity] = named;
  return {.fullName = identity.fullName,
          .externalId = identity.externalId,
          .email = identity.email,
          .sex = row.person.sex,
          .level = row.person.level,
          .experience = row.person.experience,
          .age_years = row.person.age_years,
          .trainee = row.trainee,
          .handedness = row.handedness,
          .raterClass = row.raterClass};
}

PersonEntry personEntry(SessionContext& session, const PersonId& personId) {
  session.require(Operation::kPersonEdit);
  session.require(Operation::kPersonViewIdentity);
  PeopleRepository repository(session.connection());
  return entryOf({rowOf(repository, personId), repository.identity(personId).value_or(Identity{})});
}

void changePerson(SessionContext& session, const PersonId& personId, const PersonEntry& entry,
                  const std::string& reason) {
  session.require(Operation::kPersonEdit);
  Transaction transaction(session.connection());
  PeopleRepository repository(session.connection());
  const PersonRow before = rowOf(repository, personId);
  if (!entry.raterClass.empty()) {
    ensureRaterClasses(session);
  }
  checkEntry(repository, entry, personId);
  if ((before.trainee && !entry.trainee) || (before.rater && entry.raterClass.empty())) {
    refuse(Text::tr("a person's role cannot be removed while records depend on it"), before.person.code,
           Text::tr("Set the person to \"left\" instead"));
  }
  const Person after = personFrom(entry, before.person);
  repository.updatePerson(after);
  if (before.trainee) {
    repository.setHandedness(personId, entry.handedness);
  }
  if (!before.trainee && entry.trainee) {
    repository.makeTrainee(personId, entry.handedness);
  }
  if (before.rater) {
    repository.setRaterClass(personId, entry.raterClass);
  }
  if (!before.rater && !entry.raterClass.empty()) {
    repository.makeRater(personId, entry.raterClass);
  }
  const Identity old = repository.identity(personId).value_or(Identity{});
  repository.setIdentity({personId, entry.fullName, entry.email, entry.externalId});
  nlohmann::json now = codedJson(after, entry.handedness, entry.raterClass);
  now["identity_changed"] = changedIdentity(old, entry);
  session.noteChange(AuditAction::kPersonChange, AuditObject::kPerson, personId,
                     codedJson(before.person, before.handedness, before.raterClass), now, reason);
  transaction.commit();
}

void setPersonState(SessionContext& session, const PersonId& personId, PersonState state,
                    const std::string& reason) {
  session.require(Operation::kPersonEdit);
  if (state == PersonState::kErased) {
    refuse(Text::tr("an identity is erased with its retention, not by hand"), personId,
           Text::tr("Choose active or left"));
  }
  Transaction transaction(session.connection());
  PeopleRepository repository(session.connection());
  Person person = rowOf(repository, personId).person;
  const PersonState before = std::exchange(person.state, state);
  repository.updatePerson(person);
  session.noteChange(AuditAction::kPersonSetState, AuditObject::kPerson, personId,
                     {{"state", storedText(before)}}, {{"state", storedText(state)}}, reason);
  transaction.commit();
}

std::vector<SeniorityClass> paperRaterClasses() {
  std::vector<SeniorityClass> classes;
  for (const Term<Seniority>& term : kSeniorities) {
    classes.push_back({std::string(term.stored), std::string(term.label.english()), std::ssize(classes) + 1});
  }
  return classes;
}

std::vector<SeniorityClass> ensureRaterClasses(SessionContext& session) {
  session.require(Operation::kPersonEdit);
  PeopleRepository repository(session.connection());
  std::vector<SeniorityClass> classes = repository.raterClasses();
  if (!classes.empty()) {
    return classes;
  }
  classes = paperRaterClasses();
  Transaction transaction(session.connection());
  repository.addRaterClasses(classes);
  session.note(AuditAction::kRaterClassAdd, AuditObject::kRaterClass, "intern deputy_chief chief");
  transaction.commit();
  return classes;
}

std::size_t exportPeople(SessionContext& session, const std::filesystem::path& file, bool withNames,
                         const CsvStyle& look) {
  session.require(withNames ? Operation::kReportExportNamed : Operation::kReportExportCoded);
  std::string text(kByteOrderMark);
  std::vector<std::string> header{"code",       "trainee",   "rater_class", "sex",  "level",
                                  "experience", "age_years", "handedness",  "state"};
  const std::string head = plainHead(session.connection(), session.now_us());
  const auto add = [&text](std::vector<std::string> cells, const std::string& last) {
    cells.push_back(last);
    text += csvLine(cells);
  };
  std::size_t count = 0;
  if (withNames) {
    header.insert(header.end(), {"full_name", "external_id", "email"});
    add(header, "trail_head");
    for (const NamedPersonRow& named : namedPeople(session)) {
      std::vector<std::string> cells = codedCells(named.row);
      cells.insert(cells.end(), {named.identity.fullName, named.identity.externalId, named.identity.email});
      add(std::move(cells), head);
      ++count;
    }
  } else {
    add(header, "trail_head");
    for (const PersonRow& row : people(session)) {
      add(codedCells(row), head);
      ++count;
    }
  }
  text = csvInStyle(text, look);
  Digest digest;
  digest.update(text);
  // Audit first, then write: exported names without an entry would be worse than an entry for a file that
  // could not be written.
  session.note(withNames ? AuditAction::kPeopleExportNamed : AuditAction::kPeopleExportCoded,
               AuditObject::kPerson, {}, {{"people", count}, {"blake2b", digest.hex()}});
  writeFileAtomically(file, text);
  return count;
}

std::string PersonCodes::next(const std::string& prefix) {
  const std::string head = prefix + "-";
  std::int64_t highest = 0;
  for (const std::string& code : used_) {
    if (!code.starts_with(head)) {
      continue;
    }
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(code.data() + head.size(), code.data() + code.size(), number);
    if (error == std::errc() && end == code.data() + code.size()) {
      highest = std::max(highest, number);
    }
  }
  std::string digits = std::to_string(highest + 1);
  if (digits.size() < 2) {
    digits.insert(0, 1, '0');
  }
  return *used_.insert(head + digits).first;
}

}  // namespace torsio
