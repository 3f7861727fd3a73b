// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/trial_playback.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "app/services/recording/kept_digests.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/live_types.h"
#include "sim/record/sample_codec.h"
#include "sim/scene/scene.h"

namespace torsio {

namespace {

constexpr std::size_t kKeptDecoded = 4;  // stepping back and forth across a chunk border decodes nothing
                                         // again

double targetAfter(double target_rad, const Sample& sample) noexcept {
  return sample.command.kind == ServoCommand::Kind::kSetTarget ? sample.command.value : target_rad;
}

}  // namespace

TrialPlayback::TrialPlayback(Trial trial, const Reader& reader)
    : header_(std::move(trial.header)), chunks_(std::move(trial.chunks)) {
  double target_rad = header_.targetAngle_rad;
  std::int64_t lastTick = -1;
  std::int64_t end_us = 0;
  places_.reserve(chunks_.size());
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    if (chunks_[i].index != static_cast<std::int64_t>(i)) {
      refuse(Text::tr("a part of the recording is missing"), Text::tr("run %1", header_.trialId),
             Text::tr("Choose another recording"));
    }
    const std::vector<Sample> samples = decodeChunk(chunks_[i]);
    if (samples.front().tick <= lastTick) {
      refuse(Text::tr("the parts of the recording are out of order"), Text::tr("run %1", header_.trialId),
             Text::tr("Choose another recording"));
    }
    lastTick = samples.back().tick;
    places_.push_back({samples.front().device.time_us, target_rad});
    for (const Sample& sample : samples) {
      target_rad = targetAfter(target_rad, sample);
    }
    end_us = samples.back().device.time_us;
    if (reader) {
      reader(samples);
    }
  }
  if (chunks_.empty()) {
    refuse(Text::tr("the recording is empty"), Text::tr("run %1", header_.trialId),
           Text::tr("Choose another recording"));
  }
  duration_us_ = end_us - places_.front().begin_us;
}

void TrialPlayback::seek_us(std::int64_t position_us) noexcept {
  position_us_ = std::clamp<std::int64_t>(position_us, 0, duration_us());
}

void TrialPlayback::setPlaying(bool playing) noexcept {
  if (playing && position_us_ >= duration_us()) {
    position_us_ = 0;
  }
  playing_ = playing;
}

void TrialPlayback::setSpeed(double speed) {
  TORSIO_EXPECTS(std::isfinite(speed) && speed > 0.0);
  speed_ = speed;
}

void TrialPlayback::advance(double elapsed_s) noexcept {
  if (!playing_) {
    return;
  }
  seek_us(position_us_ + std::llround(elapsed_s * speed_ * 1e6));
  if (position_us_ >= duration_us()) {
    playing_ = false;
  }
}

const TrialPlayback::Decoded& TrialPlayback::decoded(std::size_t chunk) const {
  const auto found =
      std::find_if(near_.begin(), near_.end(), [chunk](const Decoded& one) { return one.chunk == chunk; });
  if (found != near_.end()) {
    std::rotate(found, found + 1, near_.end());
    return near_.back();
  }
  if (near_.size() == kKeptDecoded) {
    near_.erase(near_.begin());
  }
  near_.push_back({chunk, decodeChunk(chunks_[chunk])});
  return near_.back();
}

LiveState TrialPlayback::state() const {
  const std::int64_t time_us = places_.front().begin_us + position_us_;
  const auto place = std::upper_bound(places_.begin(), places_.end(), time_us,
                                      [](std::int64_t t, const Place& p) { return t < p.begin_us; });
  const auto chunk = static_cast<std::size_t>(std::max<std::ptrdiff_t>(place - places_.begin() - 1, 0));
  const std::vector<Sample>& samples = decoded(chunk).samples;
  const auto after = std::upper_bound(samples.begin(), samples.end(), time_us,
                                      [](std::int64_t t, const Sample& s) { return t < s.device.time_us; });
  const auto at = after == samples.begin() ? after : after - 1;
  double target_rad = places_[chunk].target_rad;
  for (auto one = samples.begin(); one != at + 1; ++one) {
    target_rad = targetAfter(target_rad, *one);
  }
  LiveState state = liveStateOf(*at);
  state.targetAngle_rad = target_rad;
  state.pose = poses_.at(at->device.time_us);
  if (const HollowPose hollow = poses_.hollowAt(at->device.time_us); hollow.present) {
    state.hollow = hollow;
    state.hollow.reading = at->hollow;
  }
  return state;
}

namespace {

/// Returns the single trial whose id is `text` or begins with it.
std::string fullTrialId(TrialRepository& trials, const std::string& text) {
  TrialFilter everything;
  everything.limit = std::numeric_limits<std::int32_t>::max();
  std::vector<std::string> found;
  for (const TrialListing& listing : trials.list(everything)) {
    if (listing.trialId.text().rfind(text, 0) == 0) {
      found.push_back(listing.trialId);
    }
  }
  if (found.size() == 1) {
    return found.front();
  }
  refuse(found.empty() ? Text::tr("no run has this id") : Text::tr("several runs begin like this"),
         Text::tr("run %1", text),
         found.empty() ? Text::tr("Check the id and the database") : Text::tr("Give more of the id"));
}

}  // namespace

Trial loadStoredTrial(const std::string& database, const TrialId& trialId) {
  Connection connection = openRecord(database, OpenMode::kReadOnly);
  TrialRepository trials(connection);
  return trials.load(fullTrialId(trials, trialId));
}

LoadedRun loadStoredRun(const std::string& database, const TrialId& trialId,
                        const std::filesystem::path& assets) {
  Connection connection = openRecord(database, OpenMode::kReadOnly);
  TrialRepository trials(connection);
  LoadedRun run{.trial = trials.load(fullTrialId(trials, trialId)), .rules = {}};
  const TrialHeader& header = run.trial.header;
  const TrialContext context = trials.context(header.trialId).value_or(TrialContext{});
  ExerciseRules exercises(assets);
  run.rules =
      recordedRules(exercises.of(connection, header.sceneId, header.patternId, context.moduleId), header);
  return run;
}

ReplayResult replayStoredTrial(const ReplayRequest& request) {
  const Trial trial = loadStoredTrial(request.database, request.trialId);
  SceneRequest wanted = sceneRequestFor(trial.header.parametersJson);
  wanted.assets = request.assets;
  wanted.id = trial.header.sceneId;
  wanted.pattern = trial.header.patternId;
  wanted.organFile = request.organFile;
  wanted.organScale_m = request.organScale_m;
  const Scene scene = loadScene(wanted);
  return {trial.header, trial.summary, replayTrial(scene, trial)};
}

}  // namespace torsio
