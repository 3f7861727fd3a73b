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

/// What one trace of a recording tells, in the order in which the traces lie under each other.
enum class TraceKind : std::uint8_t {
  kAngle = 0,     ///< degrees
  kTorque = 1,    ///< N m
  kForce = 2,     ///< on the tissue, N
  kFlow = 3,      ///< of blood, % of the untwisted organ
  kDose = 4,      ///< of ischaemia: from 1 on the tissue is lost
  kBlack = 5,     ///< blackShare of the outside, %
  kPatency = 6,   ///< of the lumen, %
  kPressure = 7,  ///< of the content, mmHg
};
inline constexpr std::size_t kTracesOfATwist = 3;
inline constexpr std::size_t kTracesOfVessels = 6;  ///< of an untwisted organ without a lumen, as the testis
inline constexpr std::size_t kTraces = 8;

/// What a recording is judged by, in the units of its traces; drawn as bands and lines.
struct TraceMarks {
  float target_deg = 0.0F;
  float tolerance_deg = 0.0F;
  std::optional<float> torqueLimit_Nm{};
  std::optional<float> forceLimit_N{};
};

/// The traces of a recording, ready to be drawn at any width: for each stretch of time, lowest and highest
/// value one after the other. A short recording has one stretch a sample; a long one no more stretches than
/// any screen can show, so that forty minutes take as little room as one.
struct TraceData {
  /// By TraceKind: kTracesOfATwist, kTracesOfVessels or kTraces of them.
  std::vector<RangePyramid> values{};
  std::vector<std::int64_t> times_us{};  ///< where each stretch begins, since the first sample
  std::int64_t duration_us = 0;
  std::optional<TraceMarks> marks{};
  [[nodiscard]] bool untwisting() const noexcept { return values.size() > kTracesOfATwist; }
};

/// Makes traces while the samples go by. Any one thread.
class TraceCollector {
 public:
  /// `samples`: as many as will come, about.
  explicit TraceCollector(std::int64_t samples);
  /// The next ones, in order.
  void add(std::span<const Sample> samples);
  /// Ends it. An organ that was not undone has the traces of a twist alone; one whose lumen stays open and
  /// without pressure has none, so that its two traces are left out.
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
