// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "sim/core/angle.h"
#include "sim/core/pose.h"

namespace torsio {

/// Most nodes that a rod may have: all arrays of the tick have this fixed size.
inline constexpr int kMaxRodNodes = 64;

/// Places and orientations of the nodes of a rod, trivially copyable. Node i lies at `nodes[i].position_m`
/// (the centroid of its section, metres, world frame); its unit quaternion turns the section's axes into the
/// world frame: the images of x and y are the section's axes e1 and e2, the image of z is its normal t.
struct RodPose {
  int count = 0;  ///< nodes in use, 0 to kMaxRodNodes
  std::array<Pose, kMaxRodNodes> nodes{};
  friend constexpr bool operator==(const RodPose&, const RodPose&) = default;
};

static_assert(std::is_trivially_copyable_v<RodPose>);

/// Turn of one hand without regrasping: 70 degrees of pronation and 85 of supination.
inline constexpr double kHandTurn_rad = radians(155.0);

/// Most marks of the jaw that a trial keeps.
inline constexpr int kMaxTissueMarks = 32;

/// Ways to check the blood flow. Each takes time and has a stated error.
enum class FlowCheck : std::uint8_t {
  kNone = 0,
  kLook = 1,     ///< at the colour and the pulsation of the vessels
  kTouch = 2,    ///< for the pulse
  kDoppler = 3,  ///< with a probe
};

/// Result of the last check of the blood flow.
struct FlowReading {
  FlowCheck running = FlowCheck::kNone;  ///< begun and not yet done
  FlowCheck done = FlowCheck::kNone;     ///< the last that was done; its answer follows
  double flow = 0.0;                     ///< 0 .. 1, as reported: the true flow with the check's error
  std::int64_t done_us = -1;             ///< servo time; -1: none yet
  std::int64_t ready_us = -1;            ///< when the running check ends
  std::int32_t count = 0;                ///< checks done in this trial
  friend constexpr bool operator==(const FlowReading&, const FlowReading&) = default;
};

/// A place where the jaw has hurt the wall; it stays.
struct TissueMark {
  double arc_m = 0.0;      ///< of the organ at rest
  double round_rad = 0.0;  ///< round the section at rest, from e1 of SectionLattice::frameAt
  std::int64_t tick = 0;
  bool torn = false;  ///< through the wall; else bruised
  friend constexpr bool operator==(const TissueMark&, const TissueMark&) = default;
};

/// State of a hollow organ, recorded with each tick. A solid organ keeps these defaults.
struct HollowReading {
  double pressure_Pa = 0.0;  ///< of the content, over outside
  double patency = 1.0;      ///< free cross-section of the narrowest place: 1 open, 0 closed
  double flow = 1.0;         ///< of blood, against that of the untwisted organ
  double dose = 0.0;         ///< of ischaemia: from 1 on the tissue is lost
  friend constexpr bool operator==(const HollowReading&, const HollowReading&) = default;
};

/// Pose and state of a hollow organ that came twisted. Trivially copyable. The angle of its mobile part
/// stands in TwistState::graspAngle_rad.
struct HollowPose {
  bool present = false;    ///< false: a solid organ
  double start_rad = 0.0;  ///< angle with which the trial began, signed
  HollowReading reading;
  double congestion = 0.0;  ///< 0 .. 1: veins shut, artery open
  double saturation = 0.0;  ///< of the tissue's haemoglobin, 0 .. 1: for its colour
  double scaled_s = 0.0;    ///< time of the tissue: that of the hand by the scene's time scale
  double jaw_Pa = 0.0;      ///< of the jaw on the wall
  bool clipped = false;     ///< a clip or an assistant holds the mobile part
  bool venting = false;     ///< the content leaves
  bool leaking = false;     ///< the wall is torn: the content leaves for good
  FlowReading check;
  int markCount = 0;
  std::array<TissueMark, kMaxTissueMarks> marks{};
  friend constexpr bool operator==(const HollowPose&, const HollowPose&) = default;
};

static_assert(std::is_trivially_copyable_v<HollowPose>);

}  // namespace torsio
