// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/device_sample.h"
#include "sim/core/vec3.h"

namespace torsio {

/// A reading on its way from a driver's thread, numbered so that an old one is recognised.
struct MailedReading {
  DeviceSample sample;
  std::uint64_t number = 0;  ///< 0: none yet
};

/// A force on its way to a driver's thread, N in the world frame, numbered in the same way.
struct MailedForce {
  Vec3 force_N;
  std::uint64_t number = 0;
};

}  // namespace torsio
