// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/live_types.h"

namespace torsio {

LiveState liveStateOf(const Sample& sample) noexcept {
  const ToolState tool = toolState(sample.device);
  LiveState live;
  live.time_us = sample.device.time_us;
  live.tick = sample.tick;
  live.tool = tool.pose;
  live.grip = tool.grip;
  live.phase = sample.phase;
  live.response = sample.response;
  live.force_N = sample.force_N;
  live.limits = sample.limits;
  live.contact = sample.contact;
  live.hollow.present = areOfDetorsion(sample.rules);
  live.hollow.reading = sample.hollow;
  return live;
}

}  // namespace torsio
