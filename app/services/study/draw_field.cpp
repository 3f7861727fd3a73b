// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/draw_field.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/services/scoring/stored_allocation.h"
#include "assessment/domain/ids.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

std::vector<std::string> DrawField::groupCodes() const {
  std::vector<std::string> codes;
  for (const StudyGroup& group : groups) {
    codes.push_back(group.code);
  }
  return codes;
}

std::vector<Enrolment> DrawField::waiting() const {
  std::vector<Enrolment> list;
  for (const Enrolment& enrolment : enrolments) {
    if (enrolment.groupId.empty()) {
      list.push_back(enrolment);
    }
  }
  std::sort(list.begin(), list.end(),
            [](const Enrolment& a, const Enrolment& b) { return a.traineeCode < b.traineeCode; });
  return list;
}

DrawField readDrawField(SessionContext& session, const CohortId& cohortId) {
  StudyRepository study(session.connection());
  DrawField field;
  field.cohort = study.cohort(cohortId);
  field.groups = study.groups(cohortId);
  field.enrolments = study.enrolments(cohortId);
  std::erase_if(field.enrolments, [](const Enrolment& e) { return e.state == EnrolmentState::kWithdrawn; });
  for (Trainee& trainee : PeopleRepository(session.connection()).trainees()) {
    field.trainees[trainee.person.id] = std::move(trainee);
  }
  return field;
}

AllocationFactor factorOf(const DrawField& field, const std::string& name) {
  std::set<std::string> levels;
  for (const Enrolment& enrolment : field.waiting()) {
    const std::string level = factorValue(field.trainees.at(enrolment.traineeId), name);
    if (!level.empty()) {
      levels.insert(level);
    }
  }
  return {name, {levels.begin(), levels.end()}};
}

AllocationDesign designOf(const DrawField& field, const AllocationPlan& plan) {
  AllocationDesign design;
  design.studyId = field.cohort.id;
  design.method = plan.method;
  design.arms = field.groupCodes();
  design.participants = plan.method == AllocationMethod::kCompletePermutation ? field.waiting().size() : 0;
  design.blockSizes = plan.blockSizes;
  design.bestArm_tenths = plan.bestArm_tenths;
  design.imbalance = plan.imbalance;
  for (const std::string& name : plan.factors) {
    design.factors.push_back(factorOf(field, name));
  }
  validateDesign(design);
  if (plan.method == AllocationMethod::kStratifiedBlocks && plan.everybodyEnrolled) {
    std::vector<AllocationPerson> persons;
    for (const Enrolment& enrolment : field.waiting()) {
      persons.push_back(personForDraw(design, field.trainees.at(enrolment.traineeId)));
    }
    // Any seed will do: only the strata are counted here.
    design.stratumTotals = allocate(design, 0, persons).design.stratumTotals;
  }
  return design;
}

std::uint64_t drawSeed(IdSource& ids) {
  // The hash of a UUID's 122 random bits, reduced to 64.
  Digest digest;
  digest.update(ids.newUuid());
  const Digest::Value value = digest.value();
  std::uint64_t seed = 0;
  for (std::size_t i = 0; i < sizeof(seed); ++i) {
    seed = seed << 8U | value[i];
  }
  return seed;
}

std::string drawSalt(IdSource& ids) {
  // Three UUIDs hold 366 random bits.
  Digest digest;
  for (int i = 0; i < 3; ++i) {
    digest.update(ids.newUuid());
  }
  return digest.hex();
}

}  // namespace torsio
