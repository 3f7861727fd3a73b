// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/received_training.h"

#include <algorithm>
#include <map>

#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr double kForeignMinutes = 1.0;  ///< on equipment that is not planned: less is a look at it

Received comparedWithPlan(const CohortGroup& group, double virtual_min, double real_min) {
  const double plannedVirtual = group.plannedVirtual_min.value_or(0.0);
  const double plannedReal = group.plannedReal_min.value_or(0.0);
  const double ofPlan = (plannedVirtual > 0.0 ? virtual_min : 0.0) + (plannedReal > 0.0 ? real_min : 0.0);
  if ((plannedVirtual == 0.0 && virtual_min > kForeignMinutes) ||
      (plannedReal == 0.0 && real_min > kForeignMinutes)) {
    return Received::kOtherGroup;
  }
  if (plannedVirtual + plannedReal > 0.0 && ofPlan == 0.0) {
    return Received::kNothing;
  }
  if (virtual_min < kLeastShare * plannedVirtual || real_min < kLeastShare * plannedReal) {
    const bool elsewhere = virtual_min + real_min >= kLeastShare * (plannedVirtual + plannedReal);
    return elsewhere ? Received::kOtherGroup : Received::kTooLittle;
  }
  if ((plannedVirtual > 0.0 && virtual_min > kMaxShare * plannedVirtual) ||
      (plannedReal > 0.0 && real_min > kMaxShare * plannedReal)) {
    return Received::kTooMuch;
  }
  return Received::kAsPlanned;
}

}  // namespace

std::string_view wordOf(Received received) noexcept {
  switch (received) {
    case Received::kAsPlanned:
      return "as_planned";
    case Received::kNothing:
      return "nothing";
    case Received::kTooLittle:
      return "too_little";
    case Received::kTooMuch:
      return "too_much";
    case Received::kOtherGroup:
      return "other_group";
  }
  return "";
}

Text labelOf(Received received) {
  switch (received) {
    case Received::kAsPlanned:
      return Text::tr("as planned");
    case Received::kNothing:
      return Text::tr("no training");
    case Received::kTooLittle:
      return Text::tr("too little training");
    case Received::kTooMuch:
      return Text::tr("too much training");
    case Received::kOtherGroup:
      return Text::tr("training that was not planned for the group");
  }
  return {};
}

bool knowsPlanAndTimes(const CohortInputs& in) {
  return !in.doses.empty() && std::all_of(in.groups.begin(), in.groups.end(), [](const CohortGroup& group) {
    return group.plannedVirtual_min && group.plannedReal_min;
  });
}

std::vector<ReceivedTraining> receivedTraining(const CohortInputs& in) {
  if (!knowsPlanAndTimes(in)) {
    return {};
  }
  std::map<std::string, const CohortDose*> doses;
  for (const CohortDose& dose : in.doses) {
    doses[dose.trainee] = &dose;
  }
  std::vector<ReceivedTraining> out;
  for (const CohortTrainee& trainee : in.trainees) {
    ReceivedTraining one{.trainee = trainee.code, .group = trainee.group};
    if (const auto dose = doses.find(trainee.code); dose != doses.end()) {
      one.virtual_min = dose->second->virtual_min;
      one.real_min = dose->second->real_min;
    }
    one.received = comparedWithPlan(in.groups[trainee.group], one.virtual_min, one.real_min);
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace torsio
