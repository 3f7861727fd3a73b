// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/services/review/range_pyramid.h"
#include "sim/core/live_types.h"

namespace torsio::gui {

/// The traces of a recording, from top to bottom.
enum class TraceKind : std::uint8_t {
  kAngle = 0,     ///< degrees
  kTorque = 1,    ///< N m
  kForce = 2,     ///< on the tissue, N
  kFlow = 3,      ///< of ischaemia: from 1 on, the tissue is lost
  kDose = 4,      ///< blackShare of the surface, %
  kBlack = 5,     ///< blackShare of the outside, %
  kPatency = 6,   ///< of the lumen, %
  kPressure = 7,  ///< of the content, mmHg
};
inline constexpr std::size_t kTracesOfATwist = 3;
inline constexpr std::size_t kTracesOfVessels = 6;  ///< untwisting without a lumen, such as the testis
inline constexpr std::size_t kTraces = 8;

/// Target and limits of a recording, in the units of its traces; drawn as bands and lines.
struct TraceMarks {
  float target_deg = 0.0F;
  float tolerance_deg = 0.0F;
  std::optional<float> torqueLimit_Nm{};
  std::optional<float> forceLimit_N{};
};

/// The traces of a recording, prepared for drawing at any width: minimum and maximum of each stretch of time.
/// In a short recording, each sample is a stretch; a long one has at most as many stretches as a screen can
/// show, so that forty minutes need no more memory than one.
struct TraceData {
  /// By TraceKind: the first kTracesOfATwist, kTracesOfVessels or kTraces.
  std::vector<RangePyramid> values{};
  std::vector<std::int64_t> times_us{};  ///< start of each stretch, since the first sample
  std::int64_t duration_us = 0;
  std::optional<TraceMarks> marks{};
  [[nodiscard]] bool untwisting() const noexcept { return values.size() > kTracesOfATwist; }
};

/// Builds traces from a stream of samples. Use from one thread.
class TraceCollector {
 public:
  /// `samples`: approximate number of samples.
  explicit TraceCollector(std::int64_t samples);
  /// Adds the next samples, in order.
  void add(std::span<const Sample> samples);
  /// Finishes. Without untwisting, only the traces of a twist are kept; for an organ whose lumen stays open
  /// and without pressure, its two traces are omitted.
  [[nodiscard]] TraceData finish();

 private:
  std::size_t perStretch_;
  std::size_t inStretch_ = 0;
  std::int64_t begin_us_ = 0;
  bool begun_ = false;
  std::size_t traces_ = kTracesOfATwist;
  std::array<std::vector<float>, kTraces> values_;  // low, high, low, high ...
  TraceData data_;
};

}  // namespace torsio::gui
