// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/db/large_record.h"

#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/study/study_repository.h"

namespace torsio {

namespace {

constexpr int kTraineesPerCohort = 50;
constexpr std::int64_t kVersions = 5;

std::vector<SubmittedMark> marksFor(SampleRecord& sample, const std::vector<Enrolment>& enrolments) {
  std::vector<SubmittedMark> marks;
  for (const Enrolment& enrolment : enrolments) {
    for (const Rater& chief : sample.chiefs) {
      for (std::int64_t version = 1; version <= kVersions; ++version) {
        SubmittedMark mark;
        mark.id = sample.ids.newUuid();
        mark.enrolmentId = enrolment.id;
        mark.raterId = chief.person.id;
        mark.occasionCode = "pre";
        mark.version = version;
        mark.amendReason = version == 1 ? "" : "again";
        mark.score_steps = 50;
        marks.push_back(mark);
      }
    }
  }
  return marks;
}

}  // namespace

std::string fillLargeRecord(Connection& connection, SampleRecord& sample) {
  StudyRepository study(connection);
  CohortId cohortId;
  for (int first = 0; first < kManyTrainees; first += kTraineesPerCohort) {
    Transaction transaction(connection);
    cohortId = sample.ids.newUuid();
    study.addCohort({cohortId, "cohort " + std::to_string(first), "", kSampleTime_us, true}, {});
    std::vector<Trainee> trainees;
    std::vector<Enrolment> enrolments;
    for (int i = 0; i < kTraineesPerCohort; ++i) {
      Trainee trainee;
      trainee.person.id = sample.ids.newUuid();
      trainee.person.code = "S-" + std::to_string(first + i);
      trainees.push_back(trainee);
      enrolments.push_back(
          {.id = sample.ids.newUuid(), .cohortId = cohortId, .traineeId = trainee.person.id});
    }
    PeopleRepository(connection).addTrainees(trainees);
    study.enrol(enrolments);
    RatingRepository(connection).submit(marksFor(sample, enrolments));
    transaction.commit();
  }
  return cohortId;
}

}  // namespace torsio
