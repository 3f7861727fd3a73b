// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/round_cone.h"
#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Measures of a person's forearm and hand; millimetres. The defaults are a man's (ANSUR II 2012 means,
/// fingers after Chatzioglou 2024 scaled to a man's hand).
struct ArmMeasures {
  double forearmLength_mm = 262.0;  ///< elbow crease to wrist crease
  std::array<double, 9> girth_mm{265, 278, 285, 268, 240, 210, 183, 172, 176};  ///< along the forearm
  /// Width over thickness there.
  std::array<double, 9> widthToDepth{1.10, 1.12, 1.15, 1.18, 1.22, 1.30, 1.36, 1.42, 1.42};
  double palmLength_mm = 116.0;  ///< wrist crease to middle finger crease
  double handBreadth_mm = 88.0;  ///< at the knuckles
  double handThickness_mm = 29.0;
  std::array<double, 5> fingerLength_mm{54, 69, 77, 71, 58};  ///< thumb to little finger
};

/// Gives the arm a wrist of this width and thickness: the girths of the whole forearm follow in proportion,
/// its flatness towards the wrist only.
void setWrist(ArmMeasures& measures, double width_mm, double thickness_mm);

/// A named point on the skin.
struct ArmMarker {
  int number = 0;  ///< 1..10
  std::string name;
  Vec3 position_m;
  double arc_m = 0.0;      ///< along the forearm's axis from the elbow; the hand's too
  double angle_rad = 0.0;  ///< about the forearm's axis: 0 radial, 90 degrees dorsal, 180 ulnar, 270 palmar
};

/// A straight, supinated right forearm with its hand. Metres, LPS: the axis is the z axis, the elbow's cut
/// disc at z = 0 (fixed), fingers up; the radial side (thumb) at +x, the back of the hand at +y, the palm at
/// -y.
struct Arm {
  TriangleMesh surface;
  Vec3 fixedEnd_m;  ///< middle of the elbow's cut disc
  Vec3 wrist_m;     ///< middle of the wrist crease, on the axis
  Vec3 freeEnd_m;   ///< tip of the middle finger
  Vec3 ridgeZero;   ///< radial
  std::vector<ArmMarker> markers;
  std::vector<Vec3> zeroLine_m;               ///< on the radial side of the forearm's skin, every 10 mm
  std::vector<std::array<float, 2>> texture;  ///< TubeOrgan::texture, about the forearm's axis
};

/// Draws it. `edges`: as for makeIntestine().
[[nodiscard]] Arm makeArm(const ArmMeasures& measures = {}, double edges = 1.0);

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
