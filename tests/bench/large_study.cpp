// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/large_study.h"

#include <string>
#include <vector>

#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/sample_codec.h"

namespace torsio::bench {

namespace {

constexpr int kTrainees = 3'333;
constexpr int kRaters = 10;
constexpr int kTrialsEach = 3;

std::vector<Sample> twist() {
  std::vector<Sample> samples(200);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Sample& sample = samples[i];
    sample.tick = static_cast<std::int64_t>(i);
    sample.phase = i < 50 || i > 150 ? ExercisePhase::kContact : ExercisePhase::kTwisting;
    sample.response.angle_rad =
        sample.phase == ExercisePhase::kTwisting ? 0.01 * static_cast<double>(i - 50) : 0.0;
  }
  return samples;
}

}  // namespace

CohortId fillLargeStudy(testing::StudyCentre& centre) {
  Connection& connection = centre.connection();
  IdSource& ids = centre.session().ids();
  std::vector<Trainee> trainees;
  for (int i = 0; i < kTrainees; ++i) {
    Trainee trainee;
    trainee.person.id = ids.newUuid();
    trainee.person.code = "T-" + std::to_string(10'000 + i);
    trainee.person.sex = i % 2 == 0 ? "female" : "male";
    trainee.person.createdUtc_us = testing::kStudyTime_us;
    trainees.push_back(trainee);
  }
  const std::vector<RaterId> raters = centre.addChiefs(kRaters);
  Transaction transaction(connection);
  PeopleRepository(connection).addTrainees(trainees);
  StudyRepository study(connection);
  Cohort cohort{.id = ids.newUuid(), .name = "Large", .createdUtc_us = testing::kStudyTime_us};
  std::vector<StudyGroup> groups;
  for (int g = 1; g <= 3; ++g) {
    groups.push_back({.id = ids.newUuid(),
                      .cohortId = cohort.id,
                      .number = g,
                      .code = "G" + std::to_string(g),
                      .label = "arm"});
  }
  study.addCohort(cohort, groups);
  std::vector<Enrolment> enrolments;
  for (int i = 0; i < kTrainees; ++i) {
    enrolments.push_back({.id = ids.newUuid(),
                          .cohortId = cohort.id,
                          .traineeId = trainees[static_cast<std::size_t>(i)].person.id,
                          .groupId = groups[static_cast<std::size_t>(i % 3)].id,
                          .numberInGroup = 1 + i / 3,
                          .enrolledUtc_us = testing::kStudyTime_us});
  }
  study.enrol(enrolments);
  std::vector<SubmittedMark> marks;
  for (const Enrolment& enrolment : enrolments) {
    for (std::size_t r = 0; r < raters.size(); ++r) {
      for (const char* point : {"pre", "mid", "post"}) {
        SubmittedMark mark;
        mark.id = ids.newUuid();
        mark.enrolmentId = enrolment.id;
        mark.raterId = raters[r];
        mark.occasionCode = point;
        mark.score_steps = 10 * static_cast<std::int64_t>(1 + (marks.size() * 7 + r) % 10);
        mark.submittedUtc_us = testing::kStudyTime_us;
        marks.push_back(std::move(mark));
      }
    }
  }
  RatingRepository(connection).submit(marks);
  const TrialChunk chunk = encodeChunk(0, twist());
  for (std::size_t i = 0; i < enrolments.size() * kTrialsEach; ++i) {
    TrialHeader header;
    header.trialId = ids.newUuid();
    header.traineeCode = trainees[i / kTrialsEach].person.code;
    header.sceneId = "forearm";
    header.patternId = "pronation";
    header.parametersJson = "{}";
    header.targetAngle_rad = 1.0;
    header.startedUtc_us = testing::kStudyTime_us;
    TrialRepository trials(connection, {.station = "bench", .enrolmentId = enrolments[i / kTrialsEach].id});
    trials.begin(header);
    trials.append(chunk);
    TrialSummary summary;
    summary.samples = chunk.samples;
    summary.contentHash = header.trialId;  // all recordings are equal; reading is measured
    trials.finish(summary);
  }
  transaction.commit();
  return cohort.id;
}

}  // namespace torsio::bench
