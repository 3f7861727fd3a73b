// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/organ_pose.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// The shapes of an organ that is a rod over a recorded trial, for views: a recording holds what the hand
/// did, not how the organ lay, so the shapes are found by running the trial again. Kept in single precision
/// at 25 Hz while the organ is moved, and wherever it moves by 2 mm (0.9 kB a shape), interpolated between.
/// Likewise who holds a hollow organ that came twisted, its marks and checks: at 10 Hz, and wherever they
/// change (1.2 kB). Immutable once made.
class PoseTrack {
 public:
  PoseTrack() = default;
  /// Runs the trial of `header` and `chunks` again in `scene`; 30 to 60 us a tick in which the organ is
  /// moved. An organ that is neither a rod nor undone has none. Throws as decodeChunk. Any one thread.
  PoseTrack(const Scene& scene, const TrialHeader& header, std::span<const TrialChunk> chunks);

  /// Returns how the organ lay at this servo time; no nodes: at rest.
  [[nodiscard]] RodPose at(std::int64_t time_us) const noexcept;
  /// Returns how a hollow organ fared at this servo time; not present: the trial undid none. Its reading is
  /// that of the last kept moment: the sample's own is newer.
  [[nodiscard]] HollowPose hollowAt(std::int64_t time_us) const noexcept;

 private:
  struct Shape {
    std::int64_t time_us = 0;
    int count = 0;  // 0: at rest from here on
    std::size_t first = 0;
  };
  using Node = std::array<float, 7>;

  struct Moment {
    std::int64_t time_us = 0;
    HollowPose pose;
  };

  void keep(std::int64_t time_us, const RodPose& pose);
  void keep(std::int64_t time_us, const HollowPose& pose);
  [[nodiscard]] RodPose pose(const Shape& shape) const noexcept;

  std::vector<Shape> shapes_;  // by time
  std::vector<Node> nodes_;
  std::vector<Moment> moments_;  // by time
};

}  // namespace torsio
