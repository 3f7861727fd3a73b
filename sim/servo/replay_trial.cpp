// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/replay_trial.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/float_mode.h"
#include "sim/core/tissue_model.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr std::size_t kShortestPiece = 500;    // samples: shorter ones cost more than they bring
constexpr std::size_t kMaxAtOnce = 64 * 1024;  // samples: 20 MB of answers

/// An exercise with its constants as those of a servo loop.
Exercise begunAnew(const ExerciseOptions& options, const Scene& scene) {
  const PinnedFloatMode defaults;
  return Exercise(options, scene);
}

/// Tells whether a piece may begin behind `before`, by what is recorded.
bool seemsSettled(const Sample& before) noexcept {
  return before.phase == ExercisePhase::kTracking && before.contact == kContactNone;
}

ServoOptions optionsOf(const TrialHeader& header, std::uint32_t rules) {
  ServoOptions options = servoOptions(header);
  options.rules = rules;
  return options;
}

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

ExerciseAhead::ExerciseAhead(const Scene& scene, const ExerciseOptions& options,
                             std::span<const Sample> recorded, unsigned threads)
    : scene_(scene),
      options_(options),
      recorded_(recorded),
      threads_(std::max(1U, threads)),
      exercise_(begunAnew(options, scene)),
      jawClosed_(exercise_.jawClosed()) {}

bool ExerciseAhead::suits(const Scene& scene) noexcept {
  return GraspedTissue(scene, kTickPeriod_us).forgets();
}

const ExerciseStep& ExerciseAhead::next() {
  if (at_ == begun_ + answers_.size()) {
    computeMore();
  }
  return answers_[at_++ - begun_];
}

/// Also follows the jaw up to there.
std::size_t ExerciseAhead::pieceEnd(std::size_t first) {
  for (std::size_t i = first; i < recorded_.size(); ++i) {
    jawClosed_ = Exercise::jawCloses(jawClosed_, toolState(recorded_[i].device));
    if (i + 1 - first >= kShortestPiece && seemsSettled(recorded_[i])) {
      return i + 1;
    }
  }
  return recorded_.size();
}

void ExerciseAhead::step(Piece& piece) noexcept {
  const PinnedFloatMode defaults;
  for (std::size_t i = piece.first; i < piece.end; ++i) {
    const Sample& sample = recorded_[i];
    piece.exercise.apply(sample.command);
    answers_[i - begun_] = piece.exercise.step(toolState(sample.device));
  }
}

void ExerciseAhead::computeMore() {
  begun_ = at_;
  TORSIO_EXPECTS(begun_ < recorded_.size());
  const Exercise anew = begunAnew(options_, scene_);
  std::vector<Piece> pieces;
  for (std::size_t first = begun_; first < recorded_.size() && first - begun_ < kMaxAtOnce;) {
    Piece piece{first, 0, exercise_};
    if (!pieces.empty()) {
      piece.exercise = anew;
      piece.exercise.setJaw(jawClosed_);
    }
    piece.end = pieceEnd(first);
    first = piece.end;
    pieces.push_back(piece);
  }
  answers_.assign(pieces.back().end - begun_, {});
  std::atomic<std::size_t> taken{0};
  const auto work = [&] {
    for (std::size_t i = taken++; i < pieces.size(); i = taken++) {
      step(pieces[i]);
    }
  };
  {
    std::vector<std::jthread> others(std::min<std::size_t>(threads_, pieces.size()) - 1);
    for (std::jthread& other : others) {
      other = std::jthread(work);
    }
    work();
  }
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const Exercise& before = pieces[i - 1].exercise;
    // The jaw follows from the samples alone.
    if (!before.settled()) {
      pieces[i].exercise = before;
      step(pieces[i]);
      ++again_;
    }
  }
  exercise_ = pieces.back().exercise;
}

TrialRerun::HandedSample::HandedSample(const TrialHeader& header) {
  capabilities_.model = header.deviceModel;
  capabilities_.maxForce_N = header.deviceLimits.maxForce_N;
  capabilities_.continuousForce_N = header.deviceLimits.continuousForce_N;
  capabilities_.maxStiffness_N_per_m = header.deviceLimits.maxStiffness_N_per_m;
  capabilities_.workspaceMin_m = header.deviceLimits.workspaceMin_m;
  capabilities_.workspaceMax_m = header.deviceLimits.workspaceMax_m;
  capabilities_.realTime = false;
}

ExerciseOptions TrialRerun::exerciseOptions(const TrialHeader& header, std::uint32_t rules) {
  return ServoLoop::exerciseOptions(HandedSample(header).capabilities(), optionsOf(header, rules));
}

TrialRerun::TrialRerun(const Scene& scene, const TrialHeader& header, std::uint32_t rules)
    : device_(header),
      loop_({.device = &device_, .scene = &scene, .commands = &commands_, .async = &asyncLink_},
            optionsOf(header, rules)) {}

const Sample& TrialRerun::next(const Sample& recorded, const ExerciseStep* known) {
  if (recorded.command.kind != ServoCommand::Kind::kNone) {
    (void)commands_.push(recorded.command);
  }
  if (recorded.async.state != AsyncState::kNothing) {
    asyncLink_.deliveries.publish({++deliveries_, loop_.grips(), recorded.async});
  }
  device_.hand(recorded.device);
  loop_.tick(recorded.device.time_us, known);
  return loop_.lastSample();
}

std::vector<ExerciseMoment> rerunMoments(const Scene& scene, const TrialHeader& header,
                                         std::span<const Sample> samples, std::uint32_t wanted) {
  std::vector<ExerciseMoment> moments;
  if (samples.empty()) {
    return moments;
  }
  TrialRerun rerun(scene, header, samples.front().rules);
  for (const Sample& recorded : samples) {
    const Sample& answer = rerun.next(recorded);
    if (const std::uint32_t events = rerun.lastEvents() & wanted; events != kEventNone) {
      moments.push_back({recorded.tick, recorded.device.time_us, events, answer.phase});
    }
  }
  return moments;
}

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
