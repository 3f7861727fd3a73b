// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/recording_spec.h"

#include "app/services/base/build_info.h"
#include "sim/servo/servo_loop.h"

namespace torsio {

TrialHeader headerFor(const Scene& scene, const DeviceCapabilities& device, const RecordingSpec& spec) {
  TrialHeader header;
  header.trialId = spec.trialId;
  header.traineeCode = spec.traineeCode;
  header.phaseLabel = spec.phaseLabel;
  header.startedUtc_us = spec.startedUtc_us;
  header.demonstration = spec.demonstration;
  header.targetAngle_rad = spec.targetAngle_rad.value_or(scene.pattern.targetAngle_rad);

  header.sceneId = scene.id;
  header.patternId = scene.pattern.id;
  header.organHash = scene.organHash;
  header.parameterHash = scene.parameterHash;
  header.parametersJson = scene.parametersJson;
  header.model = scene.tissue;

  header.deviceModel = device.model;
  header.deviceLimits = deviceLimits(device);
  header.drive = device.drive;

  header.softwareVersion = softwareVersion();
  return header;
}

}  // namespace torsio
