// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/forearm.h"
#include "sim/anatomy/round_cone.h"

namespace torsio {

/// The skin of forearm and hand as one implicit surface; millimetres, in the frame of Arm.
class ArmShape {
 public:
  explicit ArmShape(const ArmMeasures& measures);

  /// About the distance to the skin, negative inside.
  [[nodiscard]] double operator()(const Vec3& p) const;
  [[nodiscard]] Vec3 middleTip() const { return fingers_[1].back().b; }
  [[nodiscard]] Vec3 knuckle(std::size_t finger) const { return knuckles_[finger].a; }
  [[nodiscard]] Vec3 thumbBase() const { return thumb_.front().a; }
  [[nodiscard]] double wristZ() const { return wristZ_; }

 private:
  [[nodiscard]] double tube(const Vec3& p) const;

  double wristZ_;
  MonotoneCurve halfWidth_;
  MonotoneCurve halfDepth_;
  double palmEndZ_;
  std::vector<RoundCone> eminences_;               // thenar, hypothenar, wrist bones
  std::vector<RoundCone> thumb_;                   // metacarpal, two phalanges
  std::array<std::vector<RoundCone>, 4> fingers_;  // index to little finger
  std::array<RoundCone, 4> knuckles_;
};

}  // namespace torsio
