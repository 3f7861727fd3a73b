// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/measuring_ahead.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "app/services/recording/detorsion_rules.h"
#include "app/services/recording/kept_digests.h"
#include "sim/core/contracts.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr std::int64_t kMaxSamples = 1'500'000;  // decoded; about a hundred bytes each

std::vector<TrialDigest> measuredInTurn(const std::vector<RecordingToMeasure>& recordings,
                                        std::int64_t now_us) {
  std::vector<TrialDigest> digests;
  for (const auto& [trial, rules] : recordings) {
    const AttemptMeasures measures =
        measureAttempt(trial.header, decodeTrial(trial), recordedRules(rules, trial.header));
    digests.push_back(keptDigest(trial, measures, rules, now_us));
  }
  return digests;
}

}  // namespace

bool MeasuringAhead::hasRoomFor(std::int64_t samples) const {
  return underWay_.empty() || (underWay_.size() < std::max(1U, std::thread::hardware_concurrency()) &&
                               samples_ + samples <= kMaxSamples);
}

void MeasuringAhead::give(std::vector<RecordingToMeasure> recordings) {
  Batch batch;
  for (const RecordingToMeasure& recording : recordings) {
    batch.samples += recording.trial.summary.samples;
  }
  samples_ += batch.samples;
  batch.digests = std::async(std::launch::async, [recordings = std::move(recordings), now_us = now_us_] {
    return measuredInTurn(recordings, now_us);
  });
  underWay_.push_back(std::move(batch));
}

std::vector<TrialDigest> MeasuringAhead::take() {
  TORSIO_EXPECTS(!underWay_.empty());
  Batch batch = std::move(underWay_.front());
  underWay_.pop_front();
  samples_ -= batch.samples;
  return batch.digests.get();
}

}  // namespace torsio
