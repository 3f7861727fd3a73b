// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <type_traits>

#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/servo/detorsion.h"
#include "sim/servo/grasp.h"

namespace torsio {

/// Turn of a jaw round an organ that a clip holds from which the jaw slips off; assumed.
inline constexpr double kSlideTurn_rad = radians(30.0);

/// A hollow organ that came twisted: the jaw turns its mobile part, by kHandTurn_rad at most in a grip, and
/// its base keeps it where the hand leaves it (docs/model.md U).
class GraspedHollow : public CommonTissue {
 public:
  GraspedHollow(const Scene& scene, std::int64_t tickPeriod_us);

  [[nodiscard]] OrganState start(std::uint64_t seed);
  void apply(const ServoCommand& command) noexcept;
  void setHolders(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept {
    detorsion_.setHolders(jaw, organ, events);
  }
  [[nodiscard]] double step(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept;
  [[nodiscard]] ToolState carried(const ToolState& tool, const JawMotion& motion,
                                  const OrganState& organ) const noexcept;
  [[nodiscard]] bool forgets() const noexcept { return false; }

  [[nodiscard]] std::optional<AxisFrame> grip(const Vec3& held_m, double arc_m, const ToolState& tool,
                                              OrganState& organ) noexcept;
  /// Turns the mobile part, there and back together by kHandTurn_rad at most; slides on while a clip holds
  /// it.
  [[nodiscard]] std::uint32_t follow(const ToolState& tool, JawMotion& motion, OrganState& organ) noexcept;
  [[nodiscard]] TissueReturn relax(OrganState& /*organ*/) noexcept { return TissueReturn::kStays; }
  [[nodiscard]] GripFeel feel(const Vec3& tip_m, const JawMotion& motion,
                              const OrganState& organ) const noexcept;

 private:
  const HollowOrgan* hollow_;
  const SectionLattice* lattice_;
  double stiffnessCap_N_per_m_;
  DetorsionStep detorsion_;
  double turnFrom_rad_ = 0.0;  // angle of the organ where the present turn began
  // Turn of the wrist since the jaw closed: where the present turn began, its extremes, and where it was when
  // the clip was set.
  double wristFrom_rad_ = 0.0;
  double wristLeast_rad_ = 0.0;
  double wristMost_rad_ = 0.0;
  double slidFrom_rad_ = 0.0;
  double lost_rad_ = 0.0;  // turned beyond what a hand turns: the shaft does not go round by it
};
static_assert(std::is_trivially_copyable_v<GraspedHollow>);

}  // namespace torsio
