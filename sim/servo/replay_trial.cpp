// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/replay_trial.h"

#include <algorithm>
#include <array>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/servo/exercise_ahead.h"
#include "sim/servo/trial_rerun.h"

namespace torsio {

namespace {

void requireSameScene(const Scene& scene, const TrialHeader& header) {
  const bool sameOrgan = scene.organHash == header.organHash;
  if (sameOrgan && scene.parameterHash == header.parameterHash) {
    return;
  }
  throw Error(ErrorCode::kVerifyFailed,
              sameOrgan ? Text::verbatim("the run was recorded with other parameters of the model")
                        : Text::verbatim("the run was recorded with another organ"),
              Text::tr("run %1", header.trialId),
              Text::verbatim("Replay it with the scene and the version that recorded it"));
}

void requireKnownRules(const std::vector<Sample>& recorded, const TrialHeader& header) {
  const auto known = [](const Sample& sample) { return sample.rules >= 1 && sample.rules <= kServoRules; };
  if (std::all_of(recorded.begin(), recorded.end(), known)) {
    return;
  }
  throw Error(ErrorCode::kVerifyFailed,
              Text::verbatim("the run was recorded by rules that this version does not know"),
              Text::tr("run %1", header.trialId),
              Text::verbatim("Replay it with the version that recorded it, or a newer one"));
}

/// The samples before the first gap.
std::span<const Sample> withoutGap(const std::vector<Sample>& recorded) {
  std::size_t count = 0;
  while (count < recorded.size() && recorded[count].tick == static_cast<std::int64_t>(count)) {
    ++count;
  }
  return std::span(recorded).first(count);
}

/// The first field in which the two differ, if any.
std::optional<ReplayDifference> difference(const Sample& recorded, const Sample& replayed) {
  using Field = std::pair<const char*, double (*)(const Sample&)>;
  static constexpr std::array<Field, 18> kFields{{
      {"time", [](const Sample& s) { return static_cast<double>(s.device.time_us); }},
      {"phase", [](const Sample& s) { return static_cast<double>(s.phase); }},
      {"contact", [](const Sample& s) { return static_cast<double>(s.contact); }},
      {"limits", [](const Sample& s) { return static_cast<double>(s.limits); }},
      {"angle", [](const Sample& s) { return s.response.angle_rad; }},
      {"torque", [](const Sample& s) { return s.response.torque_Nm; }},
      {"depth", [](const Sample& s) { return s.response.depth_m; }},
      {"grasp arc", [](const Sample& s) { return s.response.graspArc_m; }},
      {"wanted force x", [](const Sample& s) { return s.response.force_N.x; }},
      {"wanted force y", [](const Sample& s) { return s.response.force_N.y; }},
      {"wanted force z", [](const Sample& s) { return s.response.force_N.z; }},
      {"sent force x", [](const Sample& s) { return s.force_N.x; }},
      {"sent force y", [](const Sample& s) { return s.force_N.y; }},
      {"sent force z", [](const Sample& s) { return s.force_N.z; }},
      {"pressure", [](const Sample& s) { return s.hollow.pressure_Pa; }},
      {"patency", [](const Sample& s) { return s.hollow.patency; }},
      {"flow", [](const Sample& s) { return s.hollow.flow; }},
      {"dose", [](const Sample& s) { return s.hollow.dose; }},
  }};
  if (recorded == replayed) {
    return std::nullopt;
  }
  for (const auto& [name, value] : kFields) {
    if (value(recorded) != value(replayed)) {
      return ReplayDifference{recorded.tick, name, value(recorded), value(replayed)};
    }
  }
  return ReplayDifference{recorded.tick, "device or command", 0.0, 0.0};
}

}  // namespace

ReplayReport replayTrial(const Scene& scene, const Trial& trial, unsigned threads) {
  requireSameScene(scene, trial.header);
  const std::vector<Sample> recorded = decodeTrial(trial);
  requireKnownRules(recorded, trial.header);
  ReplayReport report;
  report.chunks = static_cast<std::int64_t>(trial.chunks.size());
  report.contentIntact = contentHash(trial) == trial.summary.contentHash;

  const std::uint32_t rules = recorded.empty() ? kServoRules : recorded.front().rules;
  TrialRerun rerun(scene, trial.header, rules);
  threads = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
  std::optional<ExerciseAhead> ahead;
  if (threads > 1 && ExerciseAhead::suits(scene)) {
    ahead.emplace(scene, TrialRerun::exerciseOptions(trial.header, rules), withoutGap(recorded), threads);
  }
  std::size_t at = 0;
  std::int64_t expectedTick = 0;
  for (const TrialChunk& chunk : trial.chunks) {
    const std::size_t first = at;
    std::vector<Sample> replayed;
    for (; at < first + static_cast<std::size_t>(chunk.samples); ++at) {
      if (recorded[at].tick != expectedTick) {
        report.gapAfterTick = expectedTick - 1;
        return report;
      }
      ++expectedTick;
      replayed.push_back(rerun.next(recorded[at], ahead ? &ahead->next() : nullptr));
      ++report.samples;
      const auto differs = difference(recorded[at], inStoredSteps(replayed.back()));
      if (!differs) {
        continue;
      }
      ++report.differentSamples;
      if (!report.first) {
        report.first = differs;
      }
    }
    if (outputDigest(replayed) == chunk.outputDigest) {
      continue;
    }
    ++report.differentChunks;
    if (!report.first) {
      report.first = ReplayDifference{chunk.firstTick, "exact answers", 0.0, 0.0};
    }
  }
  return report;
}

}  // namespace torsio
