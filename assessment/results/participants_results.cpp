// SPDX-License-Identifier: GPL-3.0-or-later
// Results about who takes part, and the times noted and recorded for them.
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/received_training.h"
#include "assessment/results/result_writer.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using enum ResultSection;

/// Adds who was allocated, withdrew, trained and was scored; `all`: including marks that are not shown.
void addParticipants(const CohortInputs& in, const CohortInputs& all, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kParticipants}, commonFlags(in));
  const ResultPart enrolments = RecordRef{RecordKind::kEnrolments};
  const std::int64_t everybody = std::ssize(in.trainees);
  rows.madeOf = partsOf({enrolments});
  rows.addCount("trainees", everybody, everybody);
  rows.addCount("groups", std::ssize(in.groups), everybody);
  rows.addCount("withdrew",
                std::count_if(in.trainees.begin(), in.trainees.end(),
                              [](const CohortTrainee& trainee) { return trainee.withdrew; }),
                everybody);
  rows.addCount("deviations", std::ssize(in.deviations), everybody);
  if (!in.deviations.empty()) {
    std::map<std::string, std::int64_t> kinds;
    for (const CohortDeviation& deviation : in.deviations) {
      ++kinds[deviation.kind];
    }
    rows.put("deviations_by_kind", countsText({kinds.begin(), kinds.end()}, in.identity), everybody);
  }
  if (!in.allocation.sealed && !in.allocation.method.empty()) {
    rows.put("seed", Text(std::to_string(in.allocation.seed)), everybody);
  }
  rows.addCount("not_allocated", in.notAllocated, everybody);
  rows.addCount("moved_by_hand", in.allocation.movedByHand, everybody);
  rows.addCount("allocated_before_commitment", in.allocation.allocatedBeforeLock, everybody);
  rows.addCount("enrolled_before_commitment", in.allocation.enrolledBeforeLock, everybody);
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::map<std::string, std::int64_t> sexes;
    std::map<std::string, std::int64_t> levels;
    std::int64_t allocated = 0;
    std::int64_t withdrew = 0;
    for (const CohortTrainee& trainee : in.trainees) {
      if (trainee.group == g) {
        ++allocated;
        withdrew += trainee.withdrew ? 1 : 0;
        ++sexes[trainee.sex];
        ++levels[trainee.level];
      }
    }
    rows.place.group = rows.group(g);
    rows.madeOf = partsOf({enrolments});
    rows.addCount("allocated", allocated, allocated);
    rows.addCount("withdrew", withdrew, allocated);
    if (allocated > 0) {
      rows.put("by_sex", countsText({sexes.begin(), sexes.end()}, in.identity), allocated);
      rows.put("by_level", countsText({levels.begin(), levels.end()}, in.identity), allocated);
    }
    rows.madeOf = partsOf({enrolments, runsOf("minutes", rows.place.group)});
    const auto runs = [&](bool interrupted) {
      return std::count_if(in.trials.begin(), in.trials.end(), [&](const TrialSummaryRow& trial) {
        return trial.group == g && (trial.interrupted || !interrupted);
      });
    };
    rows.addCount("runs", runs(false), allocated);
    rows.addCount("runs_interrupted", runs(true), allocated);
    rows.madeOf = partsOf({enrolments, RecordRef{RecordKind::kSheetRequests}});
    for (std::size_t t = 0; t < in.occasions.size(); ++t) {
      rows.place.occasion = rows.occasion(t);
      rows.addCount(
          "scored",
          std::count_if(all.scores.begin(), all.scores.end(),
                        [&](const TraineeScore& score) { return score.group == g && score.occasion == t; }),
          allocated);
    }
    rows.place.occasion.clear();
    rows.madeOf = partsOf({RecordRef{RecordKind::kCohortPlan}});
    for (const auto& [name, planned] : {std::pair("planned_virtual_min", in.groups[g].plannedVirtual_min),
                                        {"planned_real_min", in.groups[g].plannedReal_min}}) {
      if (planned) {
        rows.add(name, planned, allocated);
      }
    }
  }
}

/// Adds who withdrew, and the times noted for each trainee.
void addTrainees(const CohortInputs& in, Ledger& ledger) {
  std::map<std::string, const CohortDose*> doses;
  for (const CohortDose& dose : in.doses) {
    doses[dose.trainee] = &dose;
  }
  for (const CohortTrainee& trainee : in.trainees) {
    ResultWriter rows(ledger, traineeKey(ledger, trainee), commonFlags(in));
    rows.madeOf = partsOf({RecordRef{RecordKind::kEnrolments}});
    rows.put("withdrew", trainee.withdrew, 1);
    if (const auto dose = doses.find(trainee.code); dose != doses.end()) {
      rows.madeOf = partsOf({RecordRef{RecordKind::kTrainingTimes}});
      rows.add("noted_virtual_min", dose->second->virtual_min, 1);
      rows.add("noted_real_min", dose->second->real_min, 1);
      rows.add("noted_rest_min", dose->second->rest_min, 1);
    }
  }
}

/// Adds the times noted and recorded of the groups.
void addTimes(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kPractice}, commonFlags(in));
  std::map<std::string, std::size_t> groupOf;
  for (const CohortTrainee& trainee : in.trainees) {
    groupOf[trainee.code] = trainee.group;
  }
  const auto within = [&](const std::string& trainee, std::size_t group) {
    const auto found = groupOf.find(trainee);
    return found != groupOf.end() && found->second == group;
  };
  std::int64_t withTimes = 0;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::int64_t trainees = 0;
    std::int64_t rested = 0;
    CohortDose sum;
    for (const CohortDose& dose : in.doses) {
      if (within(dose.trainee, g)) {
        ++trainees;
        sum.virtual_min += dose.virtual_min;
        sum.real_min += dose.real_min;
        sum.rest_min += dose.rest_min;
        rested += dose.rest_min > 0.0 ? 1 : 0;
      }
    }
    if (trainees == 0) {
      continue;
    }
    double recorded_min = 0.0;
    for (const TrialSummaryRow& trial : in.trials) {
      // An untwisting does not belong to a phase of the study's arms.
      recorded_min += within(trial.trainee, g) && trial.detorsion.empty() ? trial.minutes : 0.0;
    }
    const auto count = static_cast<double>(trainees);
    rows.place.group = rows.group(g);
    const auto noted = [&](const char* statistic) {
      return partsOf({ResultPattern{
          .section = kParticipants, .statistic = statistic, .of = kEach, .group = ledger.group(g)}});
    };
    rows.madeOf = noted("noted_virtual_min");
    rows.add("mean_noted_virtual_min", sum.virtual_min / count, trainees);
    rows.madeOf = noted("noted_real_min");
    rows.add("mean_noted_real_min", sum.real_min / count, trainees);
    rows.madeOf = noted("noted_rest_min");
    rows.addCount("trainees_who_rested", rested, trainees);
    rows.add("rest_min", sum.rest_min, trainees);
    rows.madeOf = partsOf({RecordRef{RecordKind::kTrainingTimes}, runsOf("minutes", rows.place.group)});
    rows.add("mean_recorded_virtual_min", recorded_min / count, trainees);
    withTimes += trainees;
  }
  if (withTimes > 0) {
    rows.place = {.section = kPractice};
    rows.madeOf =
        partsOf({ResultPattern{.section = kParticipants, .statistic = "noted_rest_min", .of = kEach}});
    rows.addCount("trainees_with_times", withTimes, withTimes);
  }
}

/// Adds who was trained as planned.
void addReceived(const CohortInputs& in, Ledger& ledger) {
  std::map<std::size_t, std::map<Received, std::int64_t>> counts;
  std::map<std::size_t, std::int64_t> trainees;
  for (const ReceivedTraining& one : receivedTraining(in)) {
    ResultWriter rows(ledger, {.section = kParticipants, .of = one.trainee, .group = ledger.group(one.group)},
                      commonFlags(in));
    rows.madeOf = partsOf({RecordRef{RecordKind::kCohortPlan}, RecordRef{RecordKind::kTrainingTimes}});
    rows.put("received", Text(std::string(wordOf(one.received))), 1);
    ++counts[one.group][one.received];
    ++trainees[one.group];
  }
  for (auto& [group, of] : counts) {
    ResultWriter rows(ledger, {.section = kParticipants, .group = ledger.group(group)}, commonFlags(in));
    rows.madeOf = partsOf({ResultPattern{
        .section = kParticipants, .statistic = "received", .of = kEach, .group = ledger.group(group)}});
    for (const Received received : kEveryReceived) {
      rows.addCount(receivedStatistic(received), of[received], trainees[group]);
    }
  }
}

}  // namespace

ResultKey traineeKey(const Ledger& ledger, const CohortTrainee& trainee) {
  return {.section = kParticipants, .of = trainee.code, .group = ledger.group(trainee.group)};
}

void addParticipantsResults(const CohortInputs& in, const CohortInputs& all, Ledger& ledger) {
  if (!in.trainees.empty()) {
    addParticipants(in, all, ledger);
    addTrainees(in, ledger);
    addReceived(in, ledger);
  }
  addTimes(in, ledger);
}

}  // namespace torsio
