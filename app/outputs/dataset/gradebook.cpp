// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/dataset/gradebook.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "app/services/base/csv_table.h"
#include "assessment/results/number_format.h"
#include "sim/core/error.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr std::array kForms{std::pair("moodle", GradebookForm::kMoodle),
                            std::pair("canvas", GradebookForm::kCanvas),
                            std::pair("ilias", GradebookForm::kIlias)};

const std::string& numberOf(const GradedPerson& person) {
  return person.number.empty() ? person.code : person.number;
}

std::vector<std::string> columnsOf(std::vector<std::string> people, const Grades& grades) {
  for (const std::string& occasion : grades.occasions) {
    people.push_back(grades.title + ": " + occasion);
  }
  return people;
}

std::string lineOf(std::vector<std::string> person, const std::vector<std::string>& scores) {
  person.insert(person.end(), scores.begin(), scores.end());
  return csvLine(person);
}

/// People by each login that they may have in another system; null: several people could have it.
std::map<std::string, const GradedPerson*> byLogin(const Grades& grades) {
  std::map<std::string, const GradedPerson*> found;
  for (const GradedPerson& person : grades.people) {
    const std::string account = person.email.substr(0, person.email.find('@'));
    for (const std::string& login : {person.number, person.email, account, person.code}) {
      if (login.empty()) {
        continue;
      }
      const auto [at, fresh] = found.emplace(login, &person);
      if (!fresh && at->second != &person) {
        at->second = nullptr;
      }
    }
  }
  return found;
}

}  // namespace

GradebookForm gradebookForm(const std::string& name) {
  const auto found =
      std::find_if(kForms.begin(), kForms.end(), [&](const auto& form) { return name == form.first; });
  if (found == kForms.end()) {
    throw Error(ErrorCode::kBadParameter, Text::tr("is not a learning system that Torsio writes for"), name,
                Text::tr("Use moodle, canvas or ilias"));
  }
  return found->second;
}

const char* nameOf(GradebookForm form) {
  return kForms.at(static_cast<std::size_t>(form)).first;
}

std::string moodleGrades(const Grades& grades) {
  std::string text = csvLine(columnsOf({"ID number", "Email address"}, grades));
  for (const GradedPerson& person : grades.people) {
    text += lineOf({numberOf(person), person.email}, person.scores);
  }
  return text;
}

std::string canvasGrades(const Grades& grades) {
  std::string text = csvLine(columnsOf({"Student", "ID", "SIS User ID", "SIS Login ID", "Section"}, grades));
  const std::string highest = resultText(pointsFromSteps(grades.scale.hi, grades.scale));
  text += lineOf({"    Points Possible", "", "", "", ""},
                 std::vector<std::string>(grades.occasions.size(), highest));
  for (const GradedPerson& person : grades.people) {
    const std::string& name = person.name.empty() ? person.code : person.name;
    text += lineOf({name, "", numberOf(person), person.email, ""}, person.scores);
  }
  return text;
}

IliasGrades iliasGrades(const Grades& grades, std::size_t occasion, const std::string& status,
                        const std::string& name) {
  std::vector<CsvRecord> records = csvRecords(status, name, guessSeparator(status));
  constexpr std::array<std::string_view, 4> kNeeded{"update", "usr_id", "login", "mark"};
  std::array<std::size_t, kNeeded.size()> at{};
  for (std::size_t i = 0; i < kNeeded.size(); ++i) {
    const auto begin =
        records.empty() ? std::vector<std::string>::iterator() : records.front().values.begin();
    const auto end = records.empty() ? begin : records.front().values.end();
    const auto found = std::find(begin, end, kNeeded[i]);
    if (found == end) {
      throw Error(ErrorCode::kBadData,
                  Text::tr("is not the status file of an ILIAS exercise: the column %1 is missing",
                           std::string(kNeeded[i])),
                  name, Text::tr("Download the status file of the exercise as CSV, and give that"));
    }
    at[i] = static_cast<std::size_t>(found - begin);
  }
  const std::size_t columns = records.front().values.size();
  const std::map<std::string, const GradedPerson*> people = byLogin(grades);
  IliasGrades filled{.text = csvLine(records.front().values)};
  std::set<const GradedPerson*> present;
  for (auto record = records.begin() + 1; record != records.end(); ++record) {
    record->values.resize(columns);
    const std::string& login = record->values[at[2]];
    const auto found = people.find(login);
    if (found == people.end()) {
      filled.strangers.push_back(login);
    } else {
      if (found->second == nullptr) {
        throw Error(ErrorCode::kBadData, Text::tr("several trainees could have the login %1", login),
                    name + ", line " + std::to_string(record->line),
                    Text::tr("Correct staff numbers and mail addresses in the roster"));
      }
      const std::string& score = found->second->scores.at(occasion);
      if (!score.empty()) {
        record->values[at[0]] = "1";
        record->values[at[3]] = score;
        present.insert(found->second);
      }
    }
    filled.text += csvLine(record->values);
  }
  if (present.empty()) {
    throw Error(ErrorCode::kBadData, Text::tr("no login of the file belongs to somebody with a score"), name,
                Text::tr("Enter the logins of ILIAS as staff numbers in the roster"));
  }
  for (const GradedPerson& person : grades.people) {
    if (!person.scores.at(occasion).empty() && !present.contains(&person)) {
      filled.absent.push_back(person.code);
    }
  }
  return filled;
}

}  // namespace torsio
