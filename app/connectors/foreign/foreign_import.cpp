// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/foreign_import.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/connectors/foreign/foreign_motion.h"
#include "app/outputs/dataset/dataset_study.h"
#include "app/services/base/build_info.h"
#include "assessment/results/number_format.h"
#include "sim/core/device_sample.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/plausible.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

/// How far an instrument moved.
class Movement {
 public:
  void take(const ForeignPose& pose) {
    const Vec3 at = pose.pose.position_m;
    if (!first_) {
      first_ = last_ = at;
    }
    path_m_ += norm(at - *last_);
    reach_m_ = std::max(reach_m_, norm(at - *first_));
    last_ = at;
    seconds_ = 1e-6 * static_cast<double>(pose.time_us);
  }
  [[nodiscard]] double path_m() const noexcept { return path_m_; }
  [[nodiscard]] double reach_m() const noexcept { return reach_m_; }
  [[nodiscard]] double seconds() const noexcept { return seconds_; }
  /// What the unit of positions says of the hand; nothing of one that stands still.
  [[nodiscard]] std::vector<StatedValue> stated() const {
    if (reach_m_ == 0.0) {
      return {};
    }
    return {{Stated::kHandReach, reach_m_}, {Stated::kHandSpeed, path_m_ / seconds_}};
  }

 private:
  std::optional<Vec3> first_;
  std::optional<Vec3> last_;
  double path_m_ = 0.0;
  double reach_m_ = 0.0;
  double seconds_ = 0.0;
};

/// Packs poses into the chunks of a recording.
class PoseRecorder {
 public:
  void take(const ForeignPose& pose, const std::string& file, std::size_t line) {
    Sample sample;
    sample.tick = pose.place;
    sample.device = quantize({.time_us = pose.time_us, .pose = pose.pose, .grip = pose.grip}, {});
    if (sample.device.status != kDeviceOk) {
      refuse(Text::tr("the place is more than 200 m away"), file + ", line " + std::to_string(line),
             Text::tr("Check the unit that the map states"));
    }
    samples_.push_back(sample);
    if (std::ssize(samples_) == kSamplesPerChunk) {
      pack();
    }
    movement_.take(pose);
  }
  [[nodiscard]] const Movement& movement() const noexcept { return movement_; }
  std::vector<TrialChunk> finish() {
    pack();
    return std::move(chunks_);
  }

 private:
  void pack() {
    if (!samples_.empty()) {
      chunks_.push_back(encodeChunk(std::ssize(chunks_), samples_));
      samples_.clear();
    }
  }

  std::vector<Sample> samples_;
  std::vector<TrialChunk> chunks_;
  Movement movement_;
};

/// Refuses movements that no hand makes if another unit of length would make them a hand's.
void requirePlausibleUnit(const ForeignMap& map, const std::string& file, const Movement& moved) {
  const std::vector<StatedValue> stated = moved.stated();
  const Text fitting = unitsThatFit(stated, map.metresPerUnit);
  if (map.unitConfirmed || fitting.empty() ||
      std::all_of(stated.begin(), stated.end(),
                  [](const StatedValue& one) { return isPlausible(one.quantity, one.value); })) {
    return;
  }
  refuse(
      Text::tr("the instrument would have moved %1 m in %2 s, and reached %3 m: no hand does that",
               formatFixed(moved.path_m(), 3), formatFixed(moved.seconds(), 1),
               formatFixed(moved.reach_m(), 4)),
      file,
      Text::tr("Write the right \"unit\" into the map (%1 would fit), or \"unit_confirmed\": true if %2 is "
               "right",
               fitting, map.unit));
}

/// Refuses times between poses that no tracker has if another unit of time would make them one's.
void requirePlausibleTime(const ForeignMap& map, const std::string& file, std::int64_t period_us) {
  constexpr double kMicrosecond_s = 1e-6;
  const StatedValue period{Stated::kPosePeriod, kMicrosecond_s * static_cast<double>(period_us)};
  if (map.timeConfirmed || map.rate_Hz || isPlausible(period.quantity, period.value)) {
    return;
  }
  const Text fitting = unitsThatFit({&period, 1}, map.timeUnit_s);
  if (!fitting.empty()) {
    refuse(
        Text::tr("the poses would be %1 apart: %2 is plausible",
                 inPlausibleUnit(period.quantity, period.value), plausibleRange(period.quantity)),
        file,
        Text::tr("Write the right \"unit\" of the time into the map (%1 would fit), or \"time_confirmed\": "
                 "true if it is right",
                 fitting));
  }
}

std::string layoutTitle(ForeignLayout layout) {
  switch (layout) {
    case ForeignLayout::kJigsaws:
      return "JIGSAWS";
    case ForeignLayout::kRosma:
      return "ROSMA";
    case ForeignLayout::kPerkTutor:
      return "Perk Tutor";
    case ForeignLayout::kParquet:
      return "Parquet";
    case ForeignLayout::kCsv:
      break;
  }
  return "CSV";
}

std::string parametersOf(const ForeignMap& map, ForeignLayout layout, const ForeignRecording& recording,
                         const ForeignFile& file) {
  nlohmann::ordered_json json{{"source", map.source},
                              {"layout", layoutTitle(layout)},
                              {"instrument", map.instrument},
                              {"frame", map.frame},
                              {"unit", map.unit},
                              {"rotation", rotationName(map.rotation)},
                              {"grip", map.grip.has_value()},
                              {"subject", recording.person},
                              {"task", recording.task},
                              {"file", recording.name},
                              {"file_blake2b", file.contentHash},
                              {"start_known", recording.startedUtc_us.has_value()}};
  for (const auto& [key, confirmed] : {std::pair(kUnitConfirmed, map.unitConfirmed),
                                       {kTimeConfirmed, map.timeConfirmed},
                                       {kScaleConfirmed, map.scaleConfirmed}}) {
    if (confirmed) {
      json[key] = true;
    }
  }
  if (map.rate_Hz) {
    json["stated_rate_Hz"] = *map.rate_Hz;
  }
  return nlohmann::ordered_json{{kForeignParameters, std::move(json)}}.dump();
}

std::string digestOfText(const std::string& text) {
  Digest digest;
  digest.update(text);
  return digest.hex();
}

Trial trialOf(const ForeignMap& map, ForeignLayout layout, const ForeignRecording& recording,
              std::int64_t startedUtc_us, std::string& fileHash) {
  PoseRecorder recorder;
  const ForeignFile file = readForeignMotion(
      map, layout, recording,
      [&](const ForeignPose& pose, std::size_t line) { recorder.take(pose, recording.name, line); });
  requirePlausibleTime(map, recording.name, file.period_us);
  requirePlausibleUnit(map, recording.name, recorder.movement());
  fileHash = file.contentHash;
  Trial trial;
  TrialHeader& header = trial.header;
  header.sceneId = std::string(kForeignScene);
  header.patternId = recording.task;
  header.parametersJson = parametersOf(map, layout, recording, file);
  header.parameterHash = digestOfText(header.parametersJson);
  header.deviceModel = layoutTitle(layout) + (map.instrument.empty() ? "" : ", " + map.instrument);
  header.deviceLimits = {.maxForce_N = 0.0, .continuousForce_N = 0.0, .maxStiffness_N_per_m = 0.0};
  header.softwareVersion = softwareVersion();
  header.phaseLabel = recording.phase;
  header.forceScale = 0.0;
  header.tickPeriod_us = file.period_us;
  header.startedUtc_us = startedUtc_us;
  trial.chunks = recorder.finish();
  trial.summary.samples = file.lines;
  return trial;
}

LandedStudy studyOf(const ForeignMap& map) {
  LandedStudy study;
  study.cohort.name = map.cohort;
  study.cohort.description = map.description.empty() ? map.source : map.description;
  for (const ForeignGroup& group : map.groups) {
    study.cohort.groups.push_back({group.code, group.label});
  }
  for (const ForeignPerson& person : map.people) {
    study.people.push_back({.name = person.name, .group = person.group, .level = person.level});
  }
  for (const ForeignRater& rater : map.raters) {
    study.raters.push_back({.name = rater.name, .classCode = rater.classCode});
  }
  for (const ForeignRecording& recording : map.recordings) {
    const auto& known = study.occasions;
    const bool isNew = std::find(known.begin(), known.end(), recording.occasion) == known.end();
    if (!recording.occasion.empty() && isNew) {
      study.occasions.push_back(recording.occasion);
    }
  }
  study.scale = map.scale;
  for (const ForeignMark& mark : map.marks) {
    const auto recording = std::find_if(map.recordings.begin(), map.recordings.end(),
                                        [&](const auto& one) { return one.name == mark.recording; });
    study.marks.push_back({.person = recording->person,
                           .rater = mark.rater,
                           .occasion = recording->occasion,
                           .steps = mark.steps,
                           .trial = static_cast<std::size_t>(recording - map.recordings.begin())});
  }
  study.markComment = map.source;
  return study;
}

}  // namespace

ForeignOutcome importForeign(SessionContext& session, ForeignLayout layout, const std::filesystem::path& file,
                             const std::string& reason, const ProgressCallback& progress) {
  constexpr double kReading = 0.7;  // share of the total progress
  requireLanding(session);
  const ForeignMap map = readForeignMap(file, layout);
  LandedStudy study = studyOf(map);
  ForeignOutcome outcome;
  Digest all;
  all.update(map.contentHash);
  for (std::size_t i = 0; i < map.recordings.size(); ++i) {
    const ForeignRecording& recording = map.recordings[i];
    tellProgress(progress, Text::tr("Reading %1", recording.name),
                 kReading * static_cast<double>(i) / static_cast<double>(map.recordings.size()));
    const std::int64_t began_us =
        recording.startedUtc_us.value_or(session.now_us() + static_cast<std::int64_t>(i));
    std::string fileHash;
    study.trials.push_back({trialOf(map, layout, recording, began_us, fileHash), recording.person});
    outcome.samples += study.trials.back().trial.summary.samples;
    all.update(fileHash);
  }
  outcome.trials = study.trials.size();
  outcome.marks = study.marks.size();
  outcome.contentHash = all.hex();
  study.origin = {.layout = layoutTitle(layout), .source = map.source, .contentHash = outcome.contentHash};
  const nlohmann::ordered_json what{{"layout", layoutTitle(layout)}, {"source", map.source},
                                    {"people", map.people.size()},   {"raters", map.raters.size()},
                                    {"recordings", outcome.trials},  {"samples", outcome.samples},
                                    {"marks", outcome.marks},        {"hash", outcome.contentHash}};
  outcome.landed =
      landStudy(session, std::move(study), {what.dump(), reason}, partOf(progress, kReading, 1.0));
  return outcome;
}

DatasetOutcome importDataset(SessionContext& session, const std::filesystem::path& folder,
                             const std::filesystem::path& assets, const std::string& reason,
                             const ProgressCallback& progress) {
  constexpr double kReadingDataset = 0.3;  // share of the total progress
  requireLanding(session);
  tellProgress(progress, Text::tr("Reading %1", folder.filename().string()), 0.0);
  LandedStudy study = readDatasetStudy(folder);
  study.assets = assets;
  study.markComment = folder.filename().string();
  DatasetOutcome outcome;
  outcome.trials = study.trials.size();
  outcome.marks = study.marks.size();
  Digest digest;
  digest.update(readFile(folder / kDatasetStudyFile));
  for (const LandedTrial& landed : study.trials) {
    digest.update(landed.trial.summary.contentHash);
  }
  outcome.contentHash = digest.hex();
  study.origin.layout = "Torsio";
  study.origin.source = study.markComment;
  study.origin.contentHash = outcome.contentHash;
  const nlohmann::ordered_json what{{"layout", "Torsio"},
                                    {"source", study.markComment},
                                    {"simulated", study.cohort.demonstration},
                                    {"people", study.people.size()},
                                    {"raters", study.raters.size()},
                                    {"recordings", outcome.trials},
                                    {"marks", outcome.marks},
                                    {"hash", outcome.contentHash}};
  outcome.landed =
      landStudy(session, std::move(study), {what.dump(), reason}, partOf(progress, kReadingDataset, 1.0));
  return outcome;
}

}  // namespace torsio
