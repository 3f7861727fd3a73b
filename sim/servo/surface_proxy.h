// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "sim/core/device_sample.h"
#include "sim/core/live_types.h"
#include "sim/core/vec3.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/scene.h"
#include "sim/servo/exercise.h"

namespace torsio {

/// Deepest that the tip gets into an organ however hard a hand presses; the force is that of 8 N then.
inline constexpr double kDeepestPress_m = 0.020;
/// Deepest that the shaft gets.
inline constexpr double kDeepestShaft_m = 0.010;
/// Depth from which the screen says that the trainee presses too deep.
inline constexpr double kTooDeep_m = 0.005;

/// Holds the instrument at the side of the organ on which it arrived (a proxy, or god object: Zilles and
/// Salisbury 1995): a wheel, a stick or a hand that is stronger than its device cannot lead it through. Where
/// a part touches, the tool goes no further inwards along the normal of the place where it arrived than
/// kDeepestPress_m, kDeepestShaft_m, or until the tissue beyond is nearer to the other side; sideways and
/// outwards it is free. What is recorded is the instrument that is held back, so that a replay needs no
/// proxy. A hand that leads a gripped organ round is not held back while it holds.
///
/// A plain value: deterministic, allocation-free; a copy continues on its own. One thread.
class SurfaceProxy {
 public:
  /// Returns the reading with the tip where the tissue lets it be. Without contact, and in contact that is
  /// not deep, this is the reading itself, unless the tip jumps: it goes kProxyStep_m a tick.
  [[nodiscard]] DeviceSample held(const DeviceSample& reading) noexcept;
  /// Takes what the tool touches in this tick, at the place that held() gave. `organ`: as it lies.
  void note(const ExerciseStep& step, TwistDrive drive, const Scene& scene, const OrganState& organ) noexcept;

 private:
  /// The place where a part arrived: the tool may go so far inwards from it.
  struct Arrival {
    Vec3 tip_m;   ///< tip of the tool, the part just touching
    Vec3 normal;  ///< outwards
    double most_m = 0.0;
    double deepest_m = 0.0;  ///< so far, where the way ahead was looked at
  };
  enum Part : std::size_t { kJaw, kShaft, kParts };

  void noteContact(Part part, const ContactPatch& patch, double depth_m) noexcept;
  /// Ends the way inwards where the tissue ahead is nearer to another side.
  void lookAhead(const Scene& scene, const OrganState& organ) noexcept;
  [[nodiscard]] Vec3 allowed(Vec3 way_m) const noexcept;

  bool placed_ = false;
  Vec3 tip_m_;
  std::array<std::optional<Arrival>, kParts> arrivals_{};
};
static_assert(std::is_trivially_copyable_v<SurfaceProxy>);

/// Longest way of the tip in one tick, 2 m/s: no jump takes it through an organ.
inline constexpr double kProxyStep_m = 0.002;

}  // namespace torsio
