// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "sim/tissue/hollow/tube_onset.h"

namespace torsio {

/// A tube of wall, unloaded: in units of its mean radius and of the shear modulus, so that torque comes in
/// G R^3, pressure in G.
struct TubeWall {
  std::vector<double> radius;        ///< R of the middle line, one a node; nodes at equal steps, at least 5
  std::vector<double> thickness;     ///< t, likewise
  double length = 0.0;               ///< L
  std::array<double, 2> ends{1, 1};  ///< radius to which each end is held round
  double gentLimit = 1.0;            ///< J_m
  bool freeLength = false;           ///< whether the turned end may come nearer; its ends are closed
  /// Whether folds need room beside a held end, as they do (docs/model.md H.3); false: as in recordings from
  /// before.
  bool foldsNeedRoom = false;
  double pull = 0.0;  ///< on free ends, in G R^2: a folded wall alone holds no length
};

/// A tube in balance. Units of TubeWall.
struct WrungShape {
  struct Node {
    double r = 0.0;
    double z = 0.0;
    double turn_rad = 0.0;
  };
  std::vector<Node> nodes;
  double torque = 0.0;
  double energy = 0.0;  ///< of wall and pressure
  double volume = 0.0;  ///< inside the middle surface
  /// Largest of (delta - s / 4) / s over the elements away from the ends: at 0 the wall begins to fold.
  double folding = -1.0;
  double residual = 0.0;  ///< largest force on a free node over the mean thickness
  int iterations = 0;
};

/// The axisymmetric relaxed shell (docs/model.md H.3): rotationally symmetric on the mean, its folds in the
/// law of the wall. Solved at load only, by Newton; same bits on every machine. Immutable.
class WrungTube {
 public:
  /// Takes a wall and the number of its folds (waves round). Throws Error{kBadParameter} for fewer than 5
  /// nodes, or a number that is not positive.
  WrungTube(TubeWall wall, int waves);

  /// Returns the tube as it is before anything turns it: the start of a path.
  [[nodiscard]] WrungShape start() const;
  /// Brings `shape`, in balance nearby, into balance at an angle between the ends and a pressure. Where the
  /// tube has a neck and both mirror images are in balance alike, the neck stays on the side of the turned
  /// end. Throws Error{kFolded} when no balance is found.
  void solve(double angle_rad, double pressure, WrungShape& shape) const;

  [[nodiscard]] const TubeWall& wall() const noexcept { return wall_; }
  /// Returns the least radius that the wall's own volume allows at a node: sqrt(2 R t).
  [[nodiscard]] double packedRadius(std::size_t node) const noexcept;

 private:
  void balance(double angle_rad, double pressure, WrungShape& shape) const;
  [[nodiscard]] double roomHold(std::size_t element) const noexcept;
  [[nodiscard]] WrungShape mirrored(const WrungShape& shape) const;

  TubeWall wall_;
  std::vector<WallLaw> laws_;  // one an element
  bool even_ = true;           // the same from either end
};

}  // namespace torsio
