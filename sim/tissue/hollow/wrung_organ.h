// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/hollow/wring_table.h"

namespace torsio {

/// Pascals of a millimetre of mercury.
inline constexpr double kPascalsPerMmHg = 133.322387415;
/// Pressure outside an organ, Pa, to which that of a gas inside adds.
inline constexpr double kAtmosphere_Pa = 101'325.0;

/// The wall of an organ at one place as it is drawn: at its rest pressure.
struct WallPlace {
  double radius_m = 0.0;     ///< perimeter of the wall's middle line over 2 pi
  double thickness_m = 0.0;  ///< below half the radius
};

/// Tissue and content of a hollow organ.
struct HollowContent {
  double shearModulus_Pa = 0.0;
  double gentLimit = 1.0;           ///< J_m; 1 assumed for a normal wall, 0.6 for a distended one
  double restPressure_Pa = 0.0;     ///< over outside, at which the organ is drawn
  double highestPressure_Pa = 0.0;  ///< up to which the table goes; at least the rest pressure
  bool freeLength = false;          ///< whether the turned end may come nearer
  bool foldsNeedRoom = true;        ///< TubeWall::foldsNeedRoom
};

/// A straight hollow organ, or the stretch of one between two holds, that is wrung: SI. Immutable.
class WrungOrgan {
 public:
  /// Takes the wall at equal steps from the fixed to the turned end, `length_m` between them, and solves the
  /// table. Throws Error{kBadParameter} for a number out of range, {kFolded} for a wall that finds
  /// no balance.
  WrungOrgan(std::span<const WallPlace> places, double length_m, const HollowContent& content);

  /// Returns the organ at an angle and a pressure: torque in N m, lengths in m, volume in m^3. In the tick,
  /// as WringTable::at.
  [[nodiscard]] WrungState at(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns at().torque, same bits, for a fraction of its time. In the tick.
  [[nodiscard]] double torque_Nm(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns how the wall lies at a share of the length from the fixed end: its radius against the organ as
  /// drawn, exactly 1 at rest pressure without an angle; its shift along the axis against that, m. In the
  /// tick, as at().
  [[nodiscard]] WrungPlace placeAt(double share, double angle_rad, double pressure_Pa) const noexcept;
  /// Number of places of a profile: at equal shares of the length, both ends among them.
  static constexpr std::size_t kPlaces = 65;
  using Profile = std::array<WrungPlace, kPlaces>;
  /// Writes how the wall lies at all places of a profile: placeAt() up to rounding, for a fraction of its
  /// time; without shift, which is 0. In the tick.
  void profileAt(double angle_rad, double pressure_Pa, Profile& profile) const noexcept;
  /// Returns the solved tubes that profileAt() mixes, up to rounding.
  [[nodiscard]] WringTable::Mix mixAt(double angle_rad, double pressure_Pa) const noexcept {
    return table_.mixAt(angle_rad, pressure_Pa / shear_Pa_);
  }
  /// Returns how many solved tubes there are to mix.
  [[nodiscard]] std::size_t solvedCount() const noexcept { return table_.solvedCount(); }
  /// Writes how the wall of a solved tube lies at all places of a profile, as profileAt() does.
  void profileOf(std::size_t solved, Profile& profile) const noexcept;
  /// Returns the pressure at an angle when the gas cannot leave: (p_atm + p) V stays what it was at
  /// `filled_Pa` and angle 0. 30 queries.
  [[nodiscard]] double sealedPressure_Pa(double angle_rad, double filled_Pa) const noexcept;
  /// Returns the angle at which the wall begins to fold, by the shell (foldOnset) at the place that folds
  /// first.
  [[nodiscard]] double onset_rad(double pressure_Pa) const;
  /// Returns the angle up to which the solved wall is taut everywhere: that of torque_Nm, whereas
  /// onset_rad is that of the shell.
  [[nodiscard]] double taut_rad(double pressure_Pa) const noexcept;
  /// Returns the angle at which the narrowest place is packed with wall.
  [[nodiscard]] double closing_rad(double pressure_Pa) const noexcept;
  /// Returns the largest torque on the way to closing, N m.
  [[nodiscard]] double peakTorque_Nm(double pressure_Pa) const noexcept;
  /// Returns the torque for a small turn of the wall as drawn, without pressure and bend: 1 / integral of
  /// ds / (2 pi G t R^3), N m/rad.
  [[nodiscard]] double plainStiffness_Nm_per_rad() const noexcept { return plainStiffness_Nm_per_rad_; }
  /// Returns the number of folds round the organ.
  [[nodiscard]] int waves(double pressure_Pa) const;

 private:
  struct Unloaded {
    TubeWall wall;
    double radius_m = 0.0;  // mean: the unit
    double plainStiffness_Nm_per_rad = 0.0;
  };
  static Unloaded unloaded(std::span<const WallPlace> places, double length_m, const HollowContent& content);
  WrungOrgan(Unloaded tube, const HollowContent& content);
  void againstDrawn(Profile& profile) const noexcept;
  [[nodiscard]] TubePlace tubeAt(double radius, double thickness, double pressure_Pa) const;

  double shear_Pa_ = 0.0;
  double rest_Pa_ = 0.0;
  double unit_m_ = 0.0;
  double plainStiffness_Nm_per_rad_ = 0.0;
  TubeWall wall_;
  WringTable table_;
  double meanRadius_ = 0.0;  // of the wall
  double meanThickness_ = 0.0;
  std::array<double, kPlaces> drawnRadius_{};  // of the organ as drawn, at the places of a profile
};

}  // namespace torsio
