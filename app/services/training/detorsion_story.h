// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "assessment/metrics/detorsion.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/core/live_types.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// What a hand does to an organ that it undoes; each tick counts once.
enum class DetorsionDoing : std::uint8_t {
  kSearching = 0,  ///< nothing holds the organ, which is still twisted
  kTurning = 1,    ///< the jaw holds it
  kClipped = 2,    ///< a clip or an assistant holds it alone
  kChecking = 3,   ///< a check of the blood flow runs
  kWaiting = 4,    ///< nothing holds the organ, which lies within the residual angle
};
inline constexpr std::size_t kDetorsionDoings = 5;

/// What happened at an instant of an untwisting.
enum class DetorsionMoment : std::uint8_t {
  kGrip,
  kLetGo,
  kClipOn,
  kClipOff,
  kVentOpen,
  kVentShut,
  kCheck,
  kBruise,   ///< the jaw has pressed too hard for too long
  kTear,     ///< through the wall: the content leaks
  kSlip,     ///< the instrument pulled itself free of what it held
  kRelapse,  ///< the organ begins to turn back by itself
};
/// Whether an instant is one at which something went wrong, not one that the hand chose.
[[nodiscard]] constexpr bool isMishap(DetorsionMoment moment) noexcept {
  return moment >= DetorsionMoment::kBruise;
}

/// How an untwisting went, for the debrief: curves thinned for drawing, instants, where the seconds went and
/// the measures. Times are those of the hand, since the first sample.
struct DetorsionStory {
  struct Event {
    double at_s = 0.0;
    DetorsionMoment what = DetorsionMoment::kGrip;
    friend bool operator==(const Event&, const Event&) = default;
  };
  double timeScale = 60.0;  ///< seconds of the tissue for a second of the hand
  double residual_rad = 0.0;
  double enoughFlow = 0.5;
  std::vector<double> time_s{};
  std::vector<double> angle_rad{};
  std::vector<double> flow{};
  std::vector<double> dose{};
  std::vector<double> pressure_Pa{};
  std::vector<Event> events{};                     ///< by time
  bool mishapsKnown = false;                       ///< whether the events hold the mishaps, too (addMishaps)
  std::array<double, kDetorsionDoings> spent_s{};  ///< by DetorsionDoing; their sum is the duration
  DetorsionMetrics metrics{};  ///< as they were measured; undefined where they could not be
};

/// Tells how a recording that comesTwisted went. `times_us`: one a sample. `metrics`: as they were measured.
[[nodiscard]] DetorsionStory detorsionStory(std::span<const Sample> samples,
                                            std::span<const std::int64_t> times_us,
                                            const DetorsionRules& rules,
                                            const Outcome<DetorsionMetrics>& metrics);

/// Adds bruises, tears, slips and relapses of the same recording to its story: no recording holds them, so
/// that they are found by running it again in its `scene`.
void addMishaps(const Scene& scene, const TrialHeader& header, std::span<const Sample> samples,
                std::span<const std::int64_t> times_us, DetorsionStory& story);

}  // namespace torsio
