// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/db/sample_record.h"

#include "assessment/domain/ids.h"
#include "sim/core/random.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

/// Formats "T-07"; up to three digits.
std::string numbered(std::string prefix, int number) {
  if (number < 10) {
    prefix += "0";
  }
  prefix += std::to_string(number);
  return prefix;
}

}  // namespace

SampleRecord::SampleRecord(Connection& connection, int traineeCount) {
  PeopleRepository people(connection);
  people.addRaterClasses(std::vector<SeniorityClass>{{"intern", "interns", 1},
                                                     {"deputy_chief", "deputy chief physicians", 2},
                                                     {"chief", "chief physicians", 3}});
  for (int i = 1; i <= traineeCount; ++i) {
    Trainee trainee;
    trainee.person = {.id = ids.newUuid(),
                      .code = numbered("T-", i),
                      .sex = i % 2 == 0 ? "male" : "female",
                      .level = "graduate",
                      .experience = "",
                      .age_years = 24,
                      .state = PersonState::kActive,
                      .createdUtc_us = kSampleTime_us,
                      .demonstration = true};
    trainee.handedness = "right";
    trainees.push_back(trainee);
  }
  for (int i = 1; i <= 2; ++i) {
    Rater chief;
    chief.person.id = ids.newUuid();
    chief.person.code = numbered("C-", i);
    chief.person.createdUtc_us = kSampleTime_us;
    chief.person.demonstration = true;
    chief.classCode = "chief";
    chiefs.push_back(chief);
  }
  people.addTrainees(trainees);
  people.addRaters(chiefs);

  cohort = {ids.newUuid(), "Autumn", "two arms", kSampleTime_us, true};
  groups = {{ids.newUuid(), cohort.id, 1, "G1", "40 min virtual"},
            {ids.newUuid(), cohort.id, 2, "G2", "20 min virtual, 20 min real"}};
  StudyRepository study(connection);
  study.addCohort(cohort, groups);
  for (const Trainee& trainee : trainees) {
    Enrolment enrolment;
    enrolment.id = ids.newUuid();
    enrolment.cohortId = cohort.id;
    enrolment.traineeId = trainee.person.id;
    enrolment.enrolledUtc_us = kSampleTime_us;
    enrolment.demonstration = true;
    enrolments.push_back(enrolment);
  }
  study.enrol(enrolments);
}

TrialHeader sampleHeader(const TrialId& trialId, const std::string& traineeCode) {
  TrialHeader header;
  header.trialId = trialId;
  header.traineeCode = traineeCode;
  header.sceneId = "forearm";
  header.patternId = "pronation";
  header.organHash = "0a1b";
  header.parameterHash = "2c3d";
  header.parametersJson = R"({"ridges":36})";
  header.deviceModel = "Phantom Omni";
  header.deviceLimits = {3.0, 0.8, 400.0, {-0.1, -0.2, -0.3}, {0.1, 0.2, 1.0 / 3.0}};
  header.softwareVersion = "0.1.0";
  header.phaseLabel = "virtual 0-20 min";
  header.drive = TwistDrive::kRoll;
  header.targetAngle_rad = 1.0 / 3.0;
  header.forceScale = 0.7;
  header.tickPeriod_us = 1001;
  header.startedUtc_us = kSampleTime_us;
  header.demonstration = true;
  return header;
}

TrialChunk sampleChunk(std::int64_t index, std::size_t size) {
  TrialChunk chunk;
  chunk.index = index;
  chunk.firstTick = 1000 * index;
  chunk.samples = 1000;
  chunk.digest = std::string("d").append(std::to_string(index));
  chunk.outputDigest = std::string("o").append(std::to_string(index));
  Random random = Random::forStream(7, static_cast<std::uint64_t>(index));
  for (std::size_t i = 0; i < size; ++i) {
    chunk.bytes.push_back(static_cast<std::byte>(random.bounded(256)));
  }
  return chunk;
}

Trial sampleTrial() {
  Trial trial;
  trial.header = sampleHeader("11111111-1111-4111-8111-111111111111", "T-01");
  TrialChunk chunk = sampleChunk(0, 300);
  chunk.digest = chunkDigest(chunk);
  trial.chunks.push_back(chunk);
  trial.summary.samples = chunk.samples;
  trial.summary.contentHash = contentHash(trial);
  return trial;
}

}  // namespace torsio
