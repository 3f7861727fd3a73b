// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/trial_rerun.h"

namespace torsio {

namespace {

ServoOptions optionsOf(const TrialHeader& header, std::uint32_t rules) {
  ServoOptions options = servoOptions(header);
  options.rules = rules;
  return options;
}

}  // namespace

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

}  // namespace torsio
