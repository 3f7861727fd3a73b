// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/outputs/report/report_data.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/sample_codec.h"
#include "tests/app/support/small_study.h"
#include "tests/app/support/study_centre.h"

namespace torsio::testing {

/// A small study with a report request.
using SmallStudy = SmallStudyFor<ReportRequest>;

/// Records one twist that was released after `ticks` hundredths of a radian.
inline void record(SmallStudy& study, const TrialId& trialId, std::size_t ticks,
                   const std::string& parameters = "{}", bool readable = true) {
  std::vector<Sample> samples(300);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].tick = static_cast<std::int64_t>(i);
    const bool twisting = i >= 50 && i < 50 + ticks;
    samples[i].phase = twisting ? ExercisePhase::kTwisting : ExercisePhase::kContact;
    samples[i].response.angle_rad = twisting ? 0.01 * static_cast<double>(i - 50) : 0.0;
    samples[i].response.torque_Nm = twisting ? 0.3 : 0.0;
  }
  const Enrolment enrolment =
      StudyRepository(study.centre.connection()).enrolments(study.request.cohortId).at(0);
  TrialHeader header;
  header.trialId = trialId;
  header.traineeCode = enrolment.traineeCode;
  header.sceneId = "forearm";
  header.patternId = "pronation";
  header.phaseLabel = "virtual";
  header.parametersJson = parameters;
  header.targetAngle_rad = 1.0;
  header.startedUtc_us = kStudyTime_us;
  TrialRepository trials(study.centre.connection(), {.station = "room 1", .enrolmentId = enrolment.id});
  trials.begin(header);
  TrialChunk chunk = encodeChunk(0, samples);
  if (!readable) {
    chunk.bytes.resize(chunk.bytes.size() / 2);
  }
  trials.append(chunk);
  TrialSummary summary;
  summary.samples = chunk.samples;
  summary.lateTicks = 3;
  summary.contentHash = "hash of " + trialId;
  trials.finish(summary);
}

}  // namespace torsio::testing
