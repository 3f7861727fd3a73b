// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/tracker/tracked_recording.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/base/build_info.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

constexpr std::int64_t kSecond_us = 1'000'000;
constexpr std::int64_t kMinInChunk = 10;

TrialHeader headerOf(const TrackerView& view, const RecordingSpec& spec) {
  TrialHeader header;
  header.trialId = spec.trialId;
  header.traineeCode = spec.traineeCode;
  header.phaseLabel = spec.phaseLabel;
  header.startedUtc_us = spec.startedUtc_us;
  header.demonstration = spec.demonstration;
  header.sceneId = std::string(kForeignScene);
  header.patternId = kRealArmPattern;
  header.parametersJson =
      nlohmann::ordered_json{
          {kForeignParameters,
           {{"source", "tracker on the real arm"},
            {"layout", "OpenIGTLink"},
            {"instrument", view.instrument},
            {"frame", "of the tracker, as it says it"},
            {"unit", "mm"},
            {"rotation", "matrix columns"},
            {"grip", false},
            {"time", view.stamped ? "of the tracker, on the clock of the station" : "of the arrival"}}}}
          .dump();
  Digest digest;
  digest.update(header.parametersJson);
  header.parameterHash = digest.hex();
  header.deviceModel = "OpenIGTLink, " + view.instrument;
  header.deviceLimits = {.maxForce_N = 0.0, .continuousForce_N = 0.0, .maxStiffness_N_per_m = 0.0};
  header.softwareVersion = softwareVersion();
  header.forceScale = 0.0;
  header.tickPeriod_us = view.period_us.value();
  return header;
}

/// One chunk per second.
RecorderOptions optionsFor(const TrackerView& view) {
  TORSIO_EXPECTS(view.period_us.has_value());
  RecorderOptions options;
  options.samplesPerChunk = std::clamp(kSecond_us / *view.period_us, kMinInChunk, kSamplesPerChunk);
  return options;
}

}  // namespace

TrackedRecording::TrackedRecording(TrackerLink& link, const TrackerView& view, const RecordingSpec& spec,
                                   std::unique_ptr<TrialSink> sink)
    : link_(link),
      samples_(std::make_shared<SpscRing<Sample>>(kRecordingRing)),
      sink_(std::move(sink)),
      recorder_(*samples_, *sink_, headerOf(view, spec), optionsFor(view)) {
  recorder_.start();
  link_.record(samples_);
}

TrackedRecording::~TrackedRecording() {
  link_.record(nullptr);
}

RecordingResult TrackedRecording::finish(TrialOutcome outcome) {
  const std::int64_t late = link_.lateRecorded();
  link_.record(nullptr);
  return recorder_.finish(outcome, late);
}

}  // namespace torsio
