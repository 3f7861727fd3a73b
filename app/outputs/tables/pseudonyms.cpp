// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/tables/pseudonyms.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "db/repository/base/id_source.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::size_t kShortestKey = 32;
constexpr std::size_t kDigits = 10;
constexpr std::int64_t kHalfYear_days = 182;

Digest::Value keyedHash(const std::string& key, std::string_view kind, std::string_view code) {
  Digest digest;
  digest.update(static_cast<std::int64_t>(key.size()));
  digest.update(key);
  digest.update(static_cast<std::int64_t>(kind.size()));
  digest.update(kind);
  digest.update(code);
  return digest.value();
}

using Cell = std::tuple<std::size_t, std::string, std::string>;

std::map<Cell, std::int64_t> peopleOfCells(const std::vector<CohortTrainee>& trainees) {
  std::map<Cell, std::int64_t> count;
  for (const CohortTrainee& one : trainees) {
    ++count[{one.group, one.sex, one.level}];
  }
  return count;
}

std::int64_t smallestOf(const std::vector<CohortTrainee>& trainees) {
  std::int64_t smallest = 0;
  for (const auto& [cell, people] : peopleOfCells(trainees)) {
    smallest = smallest == 0 ? people : std::min(smallest, people);
  }
  return smallest;
}

/// Hides one property for everybody in groups where fewer than kSmallestCell people share a combination of
/// sex and level, so that the gaps identify nobody. Returns the number of hidden values.
std::int64_t hide(std::vector<CohortTrainee>& trainees, std::string CohortTrainee::*property) {
  std::vector<std::size_t> groups;
  for (const auto& [cell, people] : peopleOfCells(trainees)) {
    if (people < kSmallestCell) {
      groups.push_back(std::get<0>(cell));
    }
  }
  std::int64_t hidden = 0;
  for (CohortTrainee& one : trainees) {
    if (std::find(groups.begin(), groups.end(), one.group) != groups.end() && !(one.*property).empty()) {
      (one.*property).clear();
      ++hidden;
    }
  }
  return hidden;
}

template <typename Item, typename Key>
void sortBy(std::vector<Item>& items, const Key& key) {
  std::stable_sort(items.begin(), items.end(), [&](const Item& a, const Item& b) { return key(a) < key(b); });
}

/// Removes the person from deviations of people who could be identified by how many they have, and shifts
/// those dates separately. Returns the number of deviations.
std::int64_t unlinkRareDeviations(std::vector<CohortDeviation>& deviations, const Pseudonyms& names) {
  std::map<std::string, std::int64_t> ofPerson;
  for (const CohortDeviation& one : deviations) {
    ++ofPerson[one.trainee];
  }
  ofPerson.erase("");
  std::map<std::int64_t, std::int64_t> people;  // by number of deviations
  for (const auto& [person, count] : ofPerson) {
    ++people[count];
  }
  std::int64_t unlinked = 0;
  for (CohortDeviation& one : deviations) {
    const bool rare = !one.trainee.empty() && people[ofPerson[one.trainee]] < kSmallestCell;
    one.happenedUtc_us += names.shift_us(rare ? "deviations of " + one.trainee : one.trainee);
    one.trainee = rare || one.trainee.empty() ? std::string() : names.of("P", one.trainee);
    unlinked += rare ? 1 : 0;
  }
  return unlinked;
}

/// Gives trials opaque ids, removes content hashes, and shifts each start by its person's days.
void renameTrials(std::vector<TrialSummaryRow>& trials, std::map<TrialId, std::int64_t>& startedUtc_us,
                  const Pseudonyms& names) {
  std::map<TrialId, std::int64_t> moved;
  for (TrialSummaryRow& one : trials) {
    const TrialId opaque(names.of("T", one.trialId.text()));
    if (const auto began = startedUtc_us.find(one.trialId); began != startedUtc_us.end()) {
      moved[opaque] = began->second + names.shift_us(one.trainee);
    }
    one.trainee = one.trainee.empty() ? one.trainee : names.of("P", one.trainee);
    one.trialId = opaque;
    one.contentHash.clear();
  }
  startedUtc_us = std::move(moved);
}

/// Sorts by code: the record's order would identify people.
void sortByCode(CohortInputs& in) {
  sortBy(in.trainees, [](const CohortTrainee& one) { return one.code; });
  sortBy(in.scores, [](const TraineeScore& one) { return std::pair(one.trainee, one.occasion); });
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> counted;  // by group and occasion
  for (TraineeScore& one : in.scores) {
    one.number = ++counted[{one.group, one.occasion}];
  }
  sortBy(in.trainingMarks,
         [](const TrainingMark& one) { return std::tuple(one.trainee, one.occasion, one.rater); });
  sortBy(in.criterionMarks, [](const CriterionMark& one) {
    return std::tuple(one.trainee, one.occasion, one.rater, one.criterion);
  });
  sortBy(in.trials, [](const TrialSummaryRow& one) { return one.trainee; });
  sortBy(in.competence, [](const CohortCompetence& one) { return one.trainee; });
  sortBy(in.deviations,
         [](const CohortDeviation& one) { return std::pair(one.trainee, one.happenedUtc_us); });
}

/// Replaces who froze or imported the data.
void renameAdministrators(CohortInputs& in, const Pseudonyms& names) {
  if (in.freeze) {
    in.freeze->frozenBy = names.of("A", in.freeze->frozenBy);
    if (!in.freeze->askedBy.empty()) {
      in.freeze->askedBy = names.of("A", in.freeze->askedBy);
    }
  }
  if (in.imported) {
    in.imported->importedBy = names.of("A", in.imported->importedBy);
  }
}

}  // namespace

Pseudonyms::Pseudonyms(std::string key) : key_(std::move(key)) {
  if (key_.size() < kShortestKey) {
    refuseParameter(Text::tr("the key of the pseudonyms is too short"), std::to_string(key_.size()),
                    Text::tr("Use at least 32 characters, or none for a new key"));
  }
}

std::string Pseudonyms::freshKey() {
  SystemIdSource ids;
  return ids.newUuid() + ids.newUuid();
}

std::string Pseudonyms::of(std::string_view kind, std::string_view code) const {
  return std::string(kind) + "-" + toHex(keyedHash(key_, kind, code)).substr(0, kDigits);
}

std::int64_t Pseudonyms::shift_us(std::string_view code) const {
  const Digest::Value hash = keyedHash(key_, "days", code);
  const std::int64_t day = (hash[0] | hash[1] << 8 | hash[2] << 16) % (2 * kHalfYear_days);
  return (day < kHalfYear_days ? day - kHalfYear_days : day - kHalfYear_days + 1) * kDay_us;
}

CohortInputs pseudonymised(CohortInputs in, std::map<TrialId, std::int64_t>& startedUtc_us,
                           const Pseudonyms& names, bool withFreeText, PseudonymReport& report) {
  report = {};
  report.people = std::ssize(in.trainees);
  report.smallestBefore = smallestOf(in.trainees);
  report.levelsHidden = hide(in.trainees, &CohortTrainee::level);
  report.sexesHidden = hide(in.trainees, &CohortTrainee::sex);
  report.smallestAfter = smallestOf(in.trainees);

  const auto person = [&names](std::string& code) { code = code.empty() ? code : names.of("P", code); };
  const auto rater = [&names](std::string& code) { code = code.empty() ? code : names.of("R", code); };
  report.deviationsUnlinked = unlinkRareDeviations(in.deviations, names);
  for (CohortDeviation& one : in.deviations) {
    if (!withFreeText && !one.description.empty()) {
      one.description.clear();
      ++report.textsLeftOut;
    }
  }
  for (CohortTrainee& one : in.trainees) {
    one.enrolledUtc_us += one.enrolledUtc_us > 0 ? names.shift_us(one.code) : 0;
    person(one.code);
  }
  for (TraineeScore& one : in.scores) {
    person(one.trainee);
  }
  for (TrainingMark& one : in.trainingMarks) {
    one.submittedUtc_us += one.submittedUtc_us > 0 ? names.shift_us(one.trainee) : 0;
    person(one.trainee);
    rater(one.rater);
  }
  for (CriterionMark& one : in.criterionMarks) {
    person(one.trainee);
    rater(one.rater);
  }
  for (CohortDose& one : in.doses) {
    person(one.trainee);
  }
  for (CohortCompetence& one : in.competence) {
    person(one.trainee);
  }
  renameTrials(in.trials, startedUtc_us, names);
  for (ModelRatings& model : in.ratings) {
    for (RaterSheet& sheet : model.sheets) {
      rater(sheet.rater);
    }
  }
  for (ModelEvaluation& model : in.evaluations) {
    for (RaterComposite& composite : model.composites) {
      rater(composite.rater);
    }
  }
  in.centre.clear();
  renameAdministrators(in, names);
  if (!withFreeText) {  // names of cohorts, groups, data sets and scoring sheets, and descriptions
    in.title = CohortInputs().title;
    in.facts.clear();
    in.statements.clear();
    if (in.freeze) {
      in.freeze->name = names.of("F", in.freeze->name);
    }
    for (ReportedSheet& sheet : in.sheets) {
      sheet.name = names.of("S", sheet.name);
    }
    for (CohortGroup& group : in.groups) {  // a label or code may name a ward or a teacher
      group.protocol = Text();
      group.code.clear();
      group.arm.clear();
    }
  }
  in.allocation.seed = 0;
  in.allocation.sealed = true;
  in.allocation.commitment.clear();
  in.provenance.clear();

  sortByCode(in);
  return in;
}

}  // namespace torsio
