// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "sim/scene/organ_import.h"

namespace torsio {

struct Arm;

/// Range and default of a body measurement, millimetres.
struct PersonLength {
  double least_mm;
  double most_mm;
  double man_mm;  ///< of the shipped arm
};

inline constexpr PersonLength kWristWidth{40.0, 90.0, 65.0};
inline constexpr PersonLength kWristThickness{28.0, 70.0, 46.0};
inline constexpr PersonLength kForearmLength{150.0, 350.0, 262.0};  ///< elbow crease to wrist crease
inline constexpr PersonLength kPalmLength{70.0, 150.0, 116.0};      ///< wrist to crease of the middle finger
inline constexpr PersonLength kHandBreadth{60.0, 110.0, 88.0};      ///< at the knuckles
inline constexpr PersonLength kHandThickness{20.0, 42.0, 29.0};
/// From thumb to little finger.
inline constexpr std::array<PersonLength, 5> kFingers{{{30.0, 110.0, 54.0},
                                                       {30.0, 110.0, 69.0},
                                                       {30.0, 110.0, 77.0},
                                                       {30.0, 110.0, 71.0},
                                                       {30.0, 110.0, 58.0}}};

/// A person's measurements that the paper adapts, and those next to them, millimetres; missing ones have the
/// shipped man's values.
struct PersonArm {
  /// The forearm's girths follow those of the wrist; if only one of the two is given, the other is the
  /// shipped man's.
  std::optional<double> wristWidth_mm;
  std::optional<double> wristThickness_mm;
  double forearmLength_mm = kForearmLength.man_mm;
  double palmLength_mm = kPalmLength.man_mm;
  double handBreadth_mm = kHandBreadth.man_mm;
  double handThickness_mm = kHandThickness.man_mm;
  std::array<double, 5> fingers_mm{kFingers[0].man_mm, kFingers[1].man_mm, kFingers[2].man_mm,
                                   kFingers[3].man_mm, kFingers[4].man_mm};
};

/// A generated arm with its assessment.
struct JudgedArm {
  OrganImport import;
  std::shared_ptr<const Arm> drawn;
};

/// Generates a forearm with its hand and checks it like a mesh, fixed at the elbow and cut at the wrist, with
/// the patterns of the shipped forearm. Takes seconds: call it from a worker thread. Throws
/// Error{kBadParameter} for a length out of range. `assets`: the assets folder.
[[nodiscard]] JudgedArm importArm(const PersonArm& person, const std::filesystem::path& assets);

/// Writes NAME_markers.json next to an arm's organ file: its ten markers and zero line like those of the
/// shipped forearm. Throws Error{kFileUnwritable}.
void writeArmMarkers(const std::filesystem::path& organFile, const Arm& arm);

}  // namespace torsio
