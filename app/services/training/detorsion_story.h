// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assessment/metrics/detorsion.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/core/live_types.h"
#include "sim/core/text.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Activity during an untwisting; each tick counts for one.
enum class DetorsionDoing : std::uint8_t {
  kSearching = 0,  ///< nothing holds the organ, still twisted
  kTurning = 1,    ///< the jaw holds it
  kClipped = 2,    ///< a clip or an assistant holds it alone
  kChecking = 3,   ///< a check of the blood flow is running
  kWaiting = 4,    ///< nothing holds the organ, which is within the residual angle
};
inline constexpr std::size_t kDetorsionDoings = 5;

/// Event of an untwisting.
enum class DetorsionMoment : std::uint8_t {
  kGrip,
  kLetGo,
  kClipOn,
  kClipOff,
  kVentOpen,
  kVentShut,
  kCheck,
  kBruise,   ///< the jaw pressed too hard for too long
  kTear,     ///< of the wall: the content leaks
  kSlip,     ///< the instrument slipped off
  kRelapse,  ///< the organ starts to turn back
};
/// Returns whether an event is a mishap rather than the hand's decision.
[[nodiscard]] constexpr bool isMishap(DetorsionMoment moment) noexcept {
  return moment >= DetorsionMoment::kBruise;
}

/// Course of an untwisting, for the debrief: thinned curves, events, time per activity, and measures. Times
/// are the hand's, since the first sample.
struct DetorsionStory {
  struct Event {
    double at_s = 0.0;
    DetorsionMoment what = DetorsionMoment::kGrip;
    friend bool operator==(const Event&, const Event&) = default;
  };
  double timeScale = 60.0;  ///< seconds of tissue time per second of the hand
  double residual_rad = 0.0;
  double enoughFlow = 0.5;
  std::vector<double> time_s{};
  std::vector<double> angle_rad{};
  std::vector<double> flow{};
  std::vector<double> dose{};
  std::vector<double> pressure_Pa{};
  std::vector<Event> events{};                     ///< by time
  bool mishapsKnown = false;                       ///< the events include mishaps (addMishaps())
  std::array<double, kDetorsionDoings> spent_s{};  ///< by DetorsionDoing; adds up to the duration
  DetorsionMetrics metrics{};                      ///< as measured; undefined if that was not possible
};

/// Describes the course of a recording with comesTwisted(). `times_us`: one per sample. `metrics`: as
/// measured.
[[nodiscard]] DetorsionStory detorsionStory(std::span<const Sample> samples,
                                            std::span<const std::int64_t> times_us,
                                            const DetorsionRules& rules,
                                            const Outcome<DetorsionMetrics>& metrics);

/// Adds bruises, tears, slips and relapses, which recordings do not contain, by replaying the recording in
/// its `scene`.
void addMishaps(const Scene& scene, const TrialHeader& header, std::span<const Sample> samples,
                std::span<const std::int64_t> times_us, DetorsionStory& story);

/// A finding about an untwisting, worded equally in window and browser.
struct UntwistingFinding {
  enum class Kind : std::uint8_t {
    kFirstTurnRight,
    kFirstTurnWrong,
    kTwistedFurther,  ///< value: angle, rad
    kFlowFromStart,
    kFlowBack,  ///< value: time of the hand, s; other: time of the tissue, s
    kNoFlow,
    kLost,      ///< value: ischaemic dose
    kSurvives,  ///< value: ischaemic dose
    kRegrips,   ///< value: number; other: minimum number
    kSlipBack,  ///< value: angle, rad
    kInStages,  ///< value: angle, rad
    kTooFast,   ///< value: angle, rad
    kOverload,  ///< value: seconds
    kTears,     ///< value: number
    kBruises,   ///< value: number
    kSlips,     ///< value: number
    kRelapsed,
    kResidual,  ///< value: angle, rad
    kMishapsUnknown,
  };
  Kind kind = Kind::kNoFlow;
  double value = 0.0;
  double other = 0.0;
  std::optional<double> at_s{};  ///< when to look, since the first sample; empty: everywhere

  [[nodiscard]] Text text() const;
};

/// Returns the findings about an untwisting in the order of display.
[[nodiscard]] std::vector<UntwistingFinding> findingsOf(const DetorsionStory& story);

}  // namespace torsio
