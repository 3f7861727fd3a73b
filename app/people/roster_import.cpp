// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/people/roster_import.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/people/people_service.h"
#include "app/people/person_codes.h"
#include "db/repository/people/people_repository.h"
#include "sim/base/contracts.h"
#include "sim/base/digest.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

using Values = std::array<std::string, kRosterFields>;

constexpr std::int64_t kYoungest_years = 14;
constexpr std::int64_t kOldest_years = 100;
constexpr std::size_t kLinesBetweenSigns = 200;

/// Says now and then how many of the lines are done.
class LineCount {
 public:
  LineCount(const ProgressCallback& progress, Text step, std::size_t total, double from, double to)
      : progress_(progress),
        step_(std::move(step)),
        total_(std::max<std::size_t>(1, total)),
        from_(from),
        to_(to) {
    say();
  }
  void next() {
    if (++done_ % kLinesBetweenSigns == 0) {
      say();
    }
  }

 private:
  void say() const {
    const double share = static_cast<double>(done_) / static_cast<double>(total_);
    if (progress_) {
      progress_({step_, from_ + (to_ - from_) * share, -1.0});
    }
  }
  const ProgressCallback& progress_;
  Text step_;
  std::size_t total_;
  double from_;
  double to_;
  std::size_t done_ = 0;
};

std::size_t at(RosterField field) {
  return static_cast<std::size_t>(field);
}

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return text;
}

/// What is known already, found by number.
struct KnownPeople {
  struct Known {
    PersonEntry entry;
    std::string id;
    std::string code;
    bool left = false;
  };
  std::map<std::string, Known> byNumber;
  std::map<std::string, std::string> codeByEmail;  ///< lower-case address
  std::map<std::string, std::string> numberByEmail;
  std::vector<StoredRaterClass> classes;
};

KnownPeople readKnown(SessionContext& session) {
  KnownPeople known;
  known.classes = PeopleRepository(session.connection()).raterClasses();
  if (known.classes.empty()) {
    known.classes = paperRaterClasses();
  }
  for (NamedPersonRow& named : namedPeople(session)) {
    if (!named.identity.email.empty()) {
      known.codeByEmail[lower(named.identity.email)] = named.row.person.code;
      known.numberByEmail[lower(named.identity.email)] = named.identity.externalId;
    }
    if (named.identity.externalId.empty()) {
      continue;
    }
    KnownPeople::Known& person = known.byNumber[named.identity.externalId];
    person.id = named.row.person.id;
    person.code = named.row.person.code;
    person.left = named.row.person.state == "left";
    person.entry = {.fullName = named.identity.fullName,
                    .externalId = named.identity.externalId,
                    .email = named.identity.email,
                    .sex = named.row.person.sex,
                    .level = named.row.person.level,
                    .experience = named.row.person.experience,
                    .age_years = named.row.person.age_years,
                    .trainee = named.row.trainee,
                    .handedness = named.row.handedness,
                    .raterClass = named.row.raterClass};
  }
  return known;
}

std::string& textOf(PersonEntry& entry, RosterField field) {
  switch (field) {
    case RosterField::kExternalId:
      return entry.externalId;
    case RosterField::kFullName:
      return entry.fullName;
    case RosterField::kEmail:
      return entry.email;
    case RosterField::kSex:
      return entry.sex;
    case RosterField::kLevel:
      return entry.level;
    case RosterField::kExperience:
      return entry.experience;
    case RosterField::kHandedness:
      return entry.handedness;
    case RosterField::kRaterClass:
      return entry.raterClass;
    case RosterField::kAge:
      break;
  }
  throw ContractError("age is no text");
}

std::string shownValue(const PersonEntry& entry, RosterField field) {
  if (field == RosterField::kAge) {
    return entry.age_years ? std::to_string(*entry.age_years) : "";
  }
  PersonEntry copy = entry;
  return textOf(copy, field);
}

void setValue(PersonEntry& entry, RosterField field, const std::string& value) {
  if (field != RosterField::kAge) {
    textOf(entry, field) = value;
    return;
  }
  std::int64_t years = 0;
  (void)std::from_chars(value.data(), value.data() + value.size(), years);
  entry.age_years = years;
}

/// Says why a row cannot be taken; the first reason counts.
void fail(RosterRow& row, const Text& problem, const Text& remedy) {
  if (!row.problem.empty()) {
    return;
  }
  row.status = RosterStatus::kError;
  row.problem = problem;
  row.remedy = remedy;
}

void understandChoice(RosterRow& row, RosterField field, const std::map<std::string, std::string>& meanings,
                      const Text& choices) {
  std::string& value = row.values[at(field)];
  if (value.empty()) {
    return;
  }
  const auto meaning = meanings.find(lower(value));
  if (meaning != meanings.end()) {
    value = meaning->second;
    return;
  }
  fail(row, Text("\"%1\" is not understood as %2", value, std::string(rosterFieldCode(field))),
       Text("Write %1, or leave the cell empty", choices));
}

void understandAge(RosterRow& row) {
  const std::string& value = row.values[at(RosterField::kAge)];
  if (value.empty()) {
    return;
  }
  std::int64_t years = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), years);
  if (error == std::errc() && end == value.data() + value.size() && years >= kYoungest_years &&
      years <= kOldest_years) {
    row.values[at(RosterField::kAge)] = std::to_string(years);
    return;
  }
  fail(row, Text("\"%1\" is no likely age in years", value),
       Text("Write a whole number from %1 to %2, or leave the cell empty", kYoungest_years, kOldest_years));
}

void understandClass(RosterRow& row, const std::vector<StoredRaterClass>& classes) {
  std::map<std::string, std::string> meanings{{"实习医生", "intern"},
                                              {"副主任医师", "deputy_chief"},
                                              {"主任医师", "chief"},
                                              {"deputy chief", "deputy_chief"}};
  std::string choices;
  for (const StoredRaterClass& known : classes) {
    meanings[lower(known.code)] = known.code;
    meanings[lower(known.label)] = known.code;
    choices += (choices.empty() ? "" : ", ") + known.code;
  }
  understandChoice(row, RosterField::kRaterClass, meanings, choices);
}

/// Values as the record writes them, or an error.
void understand(RosterRow& row, RosterKind kind, const KnownPeople& known) {
  for (const RosterField field : rosterFields(kind)) {
    if (!isRequired(field, kind) || !row.values[at(field)].empty()) {
      continue;
    }
    fail(row, Text("the %1 is missing", std::string(rosterFieldCode(field))), "Fill in the cell");
  }
  understandChoice(row, RosterField::kSex,
                   {{"female", "female"},
                    {"f", "female"},
                    {"woman", "female"},
                    {"w", "female"},
                    {"女", "female"},
                    {"male", "male"},
                    {"m", "male"},
                    {"man", "male"},
                    {"男", "male"},
                    {"other", "other"},
                    {"diverse", "other"},
                    {"x", "other"},
                    {"其他", "other"}},
                   "female, male or other");
  understandChoice(row, RosterField::kHandedness,
                   {{"left", "left"},
                    {"l", "left"},
                    {"左", "left"},
                    {"左手", "left"},
                    {"right", "right"},
                    {"r", "right"},
                    {"右", "right"},
                    {"右手", "right"}},
                   "left or right");
  understandAge(row);
  understandClass(row, known.classes);
}

/// Compares with what is known: by number, and by number alone.
void compareWithKnown(RosterRow& row, RosterKind kind, const KnownPeople& known) {
  const std::string& email = row.values[at(RosterField::kEmail)];
  const std::string& number = row.values[at(RosterField::kExternalId)];
  if (const auto other = known.numberByEmail.find(lower(email));
      !email.empty() && other != known.numberByEmail.end() && other->second != number) {
    row.hint = Text("the e-mail address belongs to %1 already, under another number",
                    known.codeByEmail.at(lower(email)));
  }
  const auto found = known.byNumber.find(number);
  if (found == known.byNumber.end()) {
    row.status = RosterStatus::kNew;
    return;
  }
  row.personId = found->second.id;
  row.code = found->second.code;
  if (found->second.left) {
    row.hint = Text("this person has left; the import does not bring them back");
  }
  for (const RosterField field : rosterFields(kind)) {
    const std::string& value = row.values[at(field)];
    const std::string present = shownValue(found->second.entry, field);
    if (!value.empty() && value != present) {
      row.changes.push_back({field, present, value});
    }
  }
  const bool addsTrainee = kind == RosterKind::kTrainees && !found->second.entry.trainee;
  if (addsTrainee) {
    row.hint = Text("known as a rater; becomes a trainee too");
  }
  if (kind == RosterKind::kRaters && found->second.entry.raterClass.empty()) {
    row.hint = Text("known as a trainee; becomes a rater too");
  }
  row.status = row.changes.empty() && !addsTrainee ? RosterStatus::kSame : RosterStatus::kChanges;
}

void checkColumns(const RosterFile& file, RosterKind kind, const RosterColumns& columns) {
  std::map<std::size_t, RosterField> used;
  for (const RosterField field : rosterFields(kind)) {
    const std::optional<std::size_t> column = columns[at(field)];
    const std::string code(rosterFieldCode(field));
    if (!column && isRequired(field, kind)) {
      throw Error(ErrorCode::kBadParameter, Text("no column is chosen for %1", code), file.name,
                  "Choose one");
    }
    if (!column) {
      continue;
    }
    if (*column >= file.header.size()) {
      throw Error(ErrorCode::kBadParameter, Text("the column for %1 does not exist", code), file.name,
                  "Choose one of the file");
    }
    if (!used.emplace(*column, field).second) {
      throw Error(ErrorCode::kBadParameter, Text("\"%1\" is chosen for two fields", file.header[*column]),
                  file.name, "Choose one column a field");
    }
  }
}

std::string fingerprintOf(const RosterPreview& preview) {
  Digest digest;
  const auto add = [&](const std::string& text) {
    digest.update(static_cast<std::int64_t>(text.size()));
    digest.update(text);
  };
  for (const RosterRow& row : preview.rows) {
    digest.update(static_cast<std::int64_t>(row.line));
    digest.update(static_cast<std::int64_t>(row.status));
    for (const std::string& value : row.values) {
      add(value);
    }
    add(row.personId);
    for (const RosterChange& change : row.changes) {
      digest.update(static_cast<std::int64_t>(change.field));
      add(change.from);
    }
  }
  return digest.hex();
}

RosterPreview preview(SessionContext& session, const RosterFile& file, RosterKind kind,
                      const RosterColumns& columns, const ProgressCallback& progress, double share) {
  checkColumns(file, kind, columns);
  const KnownPeople known = readKnown(session);
  RosterPreview preview;
  preview.kind = kind;
  std::map<std::string, std::size_t> lineOf;
  LineCount count(progress, Text("Comparing with the record"), file.rows.size(), 0.0, share);
  for (const CsvRecord& record : file.rows) {
    count.next();
    RosterRow row;
    row.line = record.line;
    if (record.values.size() != file.header.size()) {
      fail(row, Text("the line has %1 values, the header %2", record.values.size(), file.header.size()),
           "Give one value a column; put a value that holds the separator in quotes");
    } else {
      for (const RosterField field : rosterFields(kind)) {
        if (columns[at(field)]) {
          row.values[at(field)] = record.values[*columns[at(field)]];
        }
      }
      understand(row, kind, known);
      const std::string& number = row.values[at(RosterField::kExternalId)];
      const auto [first, fresh] = lineOf.emplace(number, row.line);
      if (!number.empty() && !fresh) {
        fail(row, Text("the number %1 stands on line %2 already", number, first->second),
             "Remove one of the two lines, or correct the number");
      }
      if (row.problem.empty()) {
        compareWithKnown(row, kind, known);
      }
    }
    preview.added += row.status == RosterStatus::kNew ? 1 : 0;
    preview.same += row.status == RosterStatus::kSame ? 1 : 0;
    preview.changed += row.status == RosterStatus::kChanges ? 1 : 0;
    preview.errors += row.status == RosterStatus::kError ? 1 : 0;
    preview.rows.push_back(std::move(row));
  }
  preview.fingerprint = fingerprintOf(preview);
  return preview;
}

void requireRosterRights(const SessionContext& session) {
  session.require(Operation::kPersonEdit);
  session.require(Operation::kPersonViewIdentity);
}

nlohmann::json addedJson(const StoredPerson& person, const std::string& part) {
  return {{"code", person.code},
          {"part", part},
          {"sex", person.sex},
          {"level", person.level},
          {"experience", person.experience}};
}

/// Adds the new people; ids are random, so giving codes in their order hides the order of the roster.
std::vector<std::string> addNew(SessionContext& session, const RosterPreview& preview, LineCount& count) {
  PeopleRepository repository(session.connection());
  const std::vector<std::string> used = repository.codes();
  PersonCodes codes({used.begin(), used.end()});
  std::map<std::string, const RosterRow*> byId;
  for (const RosterRow& row : preview.rows) {
    if (row.status == RosterStatus::kNew) {
      byId[session.ids().newUuid()] = &row;
    }
  }
  const bool trainees = preview.kind == RosterKind::kTrainees;
  std::vector<std::string> newCodes;
  for (const auto& [id, row] : byId) {
    count.next();
    PersonEntry entry;
    for (const RosterField field : rosterFields(preview.kind)) {
      if (!row->values[at(field)].empty()) {
        setValue(entry, field, row->values[at(field)]);
      }
    }
    StoredPerson person{.id = id,
                        .code = codes.next(trainees ? kTraineePrefix : kRaterPrefix),
                        .sex = entry.sex,
                        .level = entry.level,
                        .experience = entry.experience,
                        .age_years = entry.age_years,
                        .createdUtc_us = session.now_us()};
    if (trainees) {
      repository.addTrainees(std::vector<StoredTrainee>{{person, entry.handedness}});
    }
    if (!trainees) {
      repository.addRaters(std::vector<StoredRater>{{person, entry.raterClass}});
    }
    repository.setIdentity({id, entry.fullName, entry.email, entry.externalId});
    session.note({.action = AuditAction::kPersonAdd,
                  .objectKind = AuditObject::kPerson,
                  .objectId = id,
                  .newJson = addedJson(person, trainees ? "trainee" : entry.raterClass).dump()});
    newCodes.push_back(person.code);
  }
  return newCodes;
}

void applyChanges(SessionContext& session, const RosterPreview& preview, LineCount& count) {
  for (const RosterRow& row : preview.rows) {
    if (row.status != RosterStatus::kChanges) {
      continue;
    }
    count.next();
    PersonEntry entry = personEntry(session, row.personId);
    for (const RosterChange& change : row.changes) {
      setValue(entry, change.field, change.to);
    }
    if (preview.kind == RosterKind::kTrainees) {
      entry.trainee = true;
    }
    changePerson(session, row.personId, entry, "roster import");
  }
}

}  // namespace

RosterPreview previewRoster(SessionContext& session, const RosterFile& file, RosterKind kind,
                            const RosterColumns& columns, const ProgressCallback& progress) {
  requireRosterRights(session);
  return preview(session, file, kind, columns, progress, 1.0);
}

RosterOutcome importRoster(SessionContext& session, const RosterFile& file, RosterKind kind,
                           const RosterColumns& columns, const std::string& fingerprint, RosterMode mode,
                           const ProgressCallback& progress) {
  constexpr double kComparing = 0.2;  // of the whole work
  requireRosterRights(session);
  Transaction transaction(session.connection());
  const RosterPreview now = preview(session, file, kind, columns, progress, kComparing);
  for (const RosterRow& row : now.rows) {
    if (row.status != RosterStatus::kError) {
      continue;
    }
    throw Error(ErrorCode::kBadData, row.problem, Text("%1, line %2", file.name, row.line), row.remedy);
  }
  if (now.fingerprint != fingerprint) {
    throw Error(ErrorCode::kBadData, "the record has changed since the preview", file.name,
                "Look at the preview again");
  }
  if (kind == RosterKind::kRaters) {
    ensureRaterClasses(session);
  }
  RosterOutcome outcome;
  LineCount count(progress, mode == RosterMode::kDryRun ? Text("Trying it out") : Text("Importing"),
                  now.added + now.changed, kComparing, 1.0);
  outcome.newCodes = addNew(session, now, count);
  applyChanges(session, now, count);
  outcome.added = now.added;
  outcome.changed = now.changed;
  session.note({.action = AuditAction::kRosterImport,
                .objectKind = AuditObject::kPerson,
                .newJson = nlohmann::json{{"added", now.added},
                                          {"changed", now.changed},
                                          {"same", now.same},
                                          {"blake2b", file.contentHash}}
                               .dump()});
  if (mode == RosterMode::kCommit) {
    transaction.commit();
  }
  return outcome;
}

}  // namespace torsio
