// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/roster_rows.h"

#include <charconv>
#include <optional>

#include "app/services/base/identifiers.h"
#include "app/services/people/people_service.h"
#include "db/repository/people/people_repository.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/plausible.h"

namespace torsio {

namespace {

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return text;
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

void understandChoice(RosterRow& row, RosterField field, const std::map<std::string, std::string>& meanings,
                      const Text& choices) {
  std::string& value = row.values[rosterIndex(field)];
  if (value.empty()) {
    return;
  }
  const auto meaning = meanings.find(lower(value));
  if (meaning != meanings.end()) {
    value = meaning->second;
    return;
  }
  refuseRow(row, Text::tr("\"%1\" is not understood as %2", value, rosterFieldLabel(field)),
            Text::tr("Write %1, or leave the cell empty", choices));
}

void understandAge(RosterRow& row) {
  const std::string& value = row.values[rosterIndex(RosterField::kAge)];
  if (value.empty()) {
    return;
  }
  std::int64_t years = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), years);
  const bool whole = error == std::errc() && end == value.data() + value.size();
  const StatedValue age{Stated::kAge, static_cast<double>(years)};
  if (whole && isPlausible(age.quantity, age.value)) {
    row.values[rosterIndex(RosterField::kAge)] = std::to_string(years);
    return;
  }
  const auto likely = whole ? unitThatFits({&age, 1}, plausible(age.quantity).shown.si) : std::nullopt;
  refuseRow(
      row,
      likely ? Text::tr("\"%1\" is not a plausible age in years, but would be one in %2", value, likely->name)
             : Text::tr("\"%1\" is not a plausible age in years", value),
      Text::tr("Write a whole number (%1), or leave the cell empty", plausibleRange(age.quantity)));
}

void understandClass(RosterRow& row, const std::vector<SeniorityClass>& classes) {
  std::map<std::string, std::string> meanings{{"实习医生", "intern"},
                                              {"副主任医师", "deputy_chief"},
                                              {"主任医师", "chief"},
                                              {"deputy chief", "deputy_chief"}};
  std::string choices;
  for (const SeniorityClass& known : classes) {
    meanings[lower(known.code)] = known.code;
    meanings[lower(known.label)] = known.code;
    choices += (choices.empty() ? "" : ", ") + known.code;
  }
  understandChoice(row, RosterField::kRaterClass, meanings, choices);
}

}  // namespace

KnownPeople readKnown(SessionContext& session) {
  KnownPeople known;
  known.classes = PeopleRepository(session.connection()).raterClasses();
  if (known.classes.empty()) {
    known.classes = paperRaterClasses();
  }
  for (NamedPersonRow& named : namedPeople(session)) {
    if (!named.identity.email.empty()) {
      known.codeByEmail[likenessOf(named.identity.email)] = named.row.person.code;
      known.numberByEmail[likenessOf(named.identity.email)] = named.identity.externalId;
    }
    if (named.identity.externalId.empty()) {
      continue;
    }
    known.codeByLikeness[likenessOf(named.identity.externalId)] = named.row.person.code;
    KnownPeople::Known& person = known.byNumber[named.identity.externalId];
    person.id = named.row.person.id;
    person.code = named.row.person.code;
    person.left = named.row.person.state == PersonState::kLeft;
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

void setValue(PersonEntry& entry, RosterField field, const std::string& value) {
  if (field != RosterField::kAge) {
    textOf(entry, field) = value;
    return;
  }
  std::int64_t years = 0;
  (void)std::from_chars(value.data(), value.data() + value.size(), years);
  entry.age_years = years;
}

void refuseRow(RosterRow& row, const Text& problem, const Text& remedy) {
  if (!row.problem.empty()) {
    return;
  }
  row.status = RosterStatus::kError;
  row.problem = problem;
  row.remedy = remedy;
}

void addHint(RosterRow& row, const Text& hint) {
  row.hint = row.hint.empty() ? hint : Text::verbatim("%1; %2", row.hint, hint);
}

void understand(RosterRow& row, RosterKind kind, const KnownPeople& known) {
  for (const RosterField field : rosterFields(kind)) {
    std::string& value = row.values[rosterIndex(field)];
    const Text flaw = flawOf(value, field == RosterField::kExternalId ? kLongestNumber : kLongestField);
    if (!flaw.empty()) {
      refuseRow(row, Text::verbatim("%1 %2", rosterFieldLabel(field), flaw), Text::tr("Type the cell again"));
      value.clear();  // a value that cannot be shown is not shown anywhere
    }
  }
  for (const RosterField field : rosterFields(kind)) {
    if (!isRequired(field, kind) || !row.values[rosterIndex(field)].empty()) {
      continue;
    }
    refuseRow(row, Text::tr("%1 is missing", rosterFieldLabel(field)), Text::tr("Fill in the cell"));
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
                   Text::tr("female, male or other"));
  understandChoice(row, RosterField::kHandedness,
                   {{"left", "left"},
                    {"l", "left"},
                    {"左", "left"},
                    {"左手", "left"},
                    {"right", "right"},
                    {"r", "right"},
                    {"右", "right"},
                    {"右手", "right"}},
                   Text::tr("left or right"));
  understandAge(row);
  understandClass(row, known.classes);
}

void compareWithKnown(RosterRow& row, RosterKind kind, const KnownPeople& known) {
  const std::string& email = row.values[rosterIndex(RosterField::kEmail)];
  const std::string& number = row.values[rosterIndex(RosterField::kExternalId)];
  if (const auto other = known.numberByEmail.find(likenessOf(email));
      !email.empty() && other != known.numberByEmail.end() && other->second != number) {
    addHint(row, Text::tr("the e-mail address belongs to %1 already, under another number",
                          known.codeByEmail.at(likenessOf(email))));
  }
  const auto found = known.byNumber.find(number);
  if (found == known.byNumber.end()) {
    if (const auto alike = known.codeByLikeness.find(likenessOf(number));
        alike != known.codeByLikeness.end()) {
      refuseRow(row, Text::tr("the number %1 looks like that of %2, but is another", number, alike->second),
                Text::tr("Write it as in the record, or change one of the two"));
      return;
    }
    row.status = RosterStatus::kNew;
    return;
  }
  row.personId = found->second.id;
  row.code = found->second.code;
  if (found->second.left) {
    addHint(row, Text::tr("this person has left; the import does not bring them back"));
  }
  for (const RosterField field : rosterFields(kind)) {
    const std::string& value = row.values[rosterIndex(field)];
    const std::string present = shownValue(found->second.entry, field);
    if (!value.empty() && value != present) {
      row.changes.push_back({field, present, value});
    }
  }
  const bool addsTrainee = kind == RosterKind::kTrainees && !found->second.entry.trainee;
  if (addsTrainee) {
    addHint(row, Text::tr("known as a rater; becomes a trainee too"));
  }
  if (kind == RosterKind::kRaters && found->second.entry.raterClass.empty()) {
    addHint(row, Text::tr("known as a trainee; becomes a rater too"));
  }
  row.status = row.changes.empty() && !addsTrainee ? RosterStatus::kSame : RosterStatus::kChanges;
}

void checkColumns(const RosterFile& file, RosterKind kind, const RosterColumns& columns) {
  std::map<std::size_t, RosterField> used;
  for (const RosterField field : rosterFields(kind)) {
    const std::optional<std::size_t> column = columns[rosterIndex(field)];
    const Phrase label = rosterFieldLabel(field);
    if (!column && isRequired(field, kind)) {
      refuseParameter(Text::tr("no column is chosen for %1", label), file.name, Text::tr("Choose one"));
    }
    if (!column) {
      continue;
    }
    if (*column >= file.header.size()) {
      refuseParameter(Text::tr("the column for %1 does not exist", label), file.name,
                      Text::tr("Choose one of the file"));
    }
    if (!used.emplace(*column, field).second) {
      refuseParameter(Text::tr("\"%1\" is chosen for two fields", file.header[*column]), file.name,
                      Text::tr("Choose one column a field"));
    }
  }
}

}  // namespace torsio
