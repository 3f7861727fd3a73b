// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "sim/core/vec3.h"
#include "sim/tissue/rod/landmark_turn.h"

namespace torsio {

/// What the hand that holds an organ turns it about.
enum class GripAxis {
  kOwn,         ///< the organ's own axis at the grip; the gripped section keeps its place to itself
  kLine,        ///< a straight line through two landmarks: the grip is carried round it
  kInstrument,  ///< nothing given: the grip follows the instrument in all six degrees
};

/// How an organ that is a rod is turned and how its turn is measured. All places: organ at rest, world frame.
struct TurnTask {
  GripAxis axis = GripAxis::kOwn;
  Vec3 axisFrom_m;  ///< kLine: the line starts here
  Vec3 axisTo_m;    ///< kLine: and runs through here; a positive angle turns right-handed about it
  /// Points of the organ whose turn is the angle of the task; none: the turn of the gripped section about
  /// the axis of the grip.
  std::optional<Landmarks> measured;
};

/// Where across a section something holds the organ.
enum class SectionSide {
  kCentre,  ///< the centre of the section
  kInner,   ///< its outline towards the inside of the organ's bend
  kOuter,   ///< its outline away from the inside of the bend
};

/// Something that holds an organ: a ligament, a mesentery, the neighbouring organ at an end. `count` springs
/// spread evenly from `from` to `to`, each shared by the nodes of a patch; a spring pulls only.
struct Restraint {
  std::string id;     ///< "cardia", "mesentery" ...
  double from = 0.0;  ///< fraction of the organ's length
  double to = 0.0;
  int count = 1;
  SectionSide side = SectionSide::kCentre;
  std::optional<Vec3> point_m;  ///< the held point, instead of `from` and `side`; world frame, at rest
  /// Where the springs end: none of both: where the held points are at rest.
  std::optional<Vec3> anchor_m;    ///< world frame
  bool towardsChord = false;       ///< on the line between the organ's ends, as the root of a mesentery
  double slack_m = 0.0;            ///< way beyond the distance at rest before a spring pulls
  double halfWidth_m = 0.0;        ///< of the patch along the organ; 0: half the radius there
  double stiffness_N_per_m = 0.0;  ///< of each spring
  double turn_Nm_per_rad = 0.0;    ///< resistance of the patch to turning, about every axis
  std::string source;              ///< of the numbers, or "assumed ..."
};

}  // namespace torsio
