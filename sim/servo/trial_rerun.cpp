// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/trial_rerun.h"

namespace torsio {

TrialRerun::HandedSample::HandedSample(const TrialHeader& header) {
  capabilities_.model = header.deviceModel;
  capabilities_.maxForce_N = header.deviceLimits.maxForce_N;
  capabilities_.continuousForce_N = header.deviceLimits.continuousForce_N;
  capabilities_.maxStiffness_N_per_m = header.deviceLimits.maxStiffness_N_per_m;
  capabilities_.workspaceMin_m = header.deviceLimits.workspaceMin_m;
  capabilities_.workspaceMax_m = header.deviceLimits.workspaceMax_m;
  capabilities_.realTime = false;
}

TrialRerun::TrialRerun(const Scene& scene, const TrialHeader& header)
    : device_(header),
      loop_({.device = &device_, .scene = &scene, .commands = &commands_, .beside = &beside_},
            servoOptions(header)) {}

const Sample& TrialRerun::next(const Sample& recorded) {
  if (recorded.command.kind != ServoCommand::Kind::kNone) {
    (void)commands_.push(recorded.command);
  }
  if (recorded.beside.state != BesideState::kNothing) {
    beside_.deliveries.publish({++deliveries_, loop_.grips(), recorded.beside});
  }
  device_.hand(recorded.device);
  loop_.tick(recorded.device.time_us);
  return loop_.lastSample();
}

}  // namespace torsio
