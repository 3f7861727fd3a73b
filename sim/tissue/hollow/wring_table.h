// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/tissue/hollow/wrung_tube.h"

namespace torsio {

/// State of a wrung tube at one pressure and angle. Units of TubeWall, or SI where a WrungOrgan says so.
struct WrungState {
  double torque = 0.0;
  double waist = 0.0;       ///< mean radius of the wall where it is narrowest against its unloaded radius
  double waistPlace = 0.5;  ///< there: share of the length from the fixed end
  double patency = 1.0;     ///< free cross-section there: 1 unfolded, 0 closed
  double volume = 0.0;
  double length = 0.0;  ///< between the ends
};

/// Shape of a wrung tube at one place along it. Units of TubeWall, or SI where a WrungOrgan says so.
struct WrungPlace {
  double radius = 0.0;    ///< mean, of the middle line; of a WrungOrgan: against the organ as drawn
  double turn = 0.0;      ///< share of the angle between the ends by which this place is turned: 0 .. 1
  double shift = 0.0;     ///< from the fixed end; of a WrungOrgan: against the organ as drawn
  double slack = 1.0;     ///< mean radius against the one that the perimeter would fill round: below 1 folded
  double foldTurn = 0.0;  ///< chi, rad: turn of a fold's crest since the fixed end, approximately
};

/// A tube solved over pressure and angle for queries in the tick. The angle's axis is normalised at each
/// pressure by the angles at which the tube begins to fold and closes, so that rows of neighbouring pressures
/// agree. Immutable.
class WringTable {
 public:
  static constexpr int kPressures = 9;  ///< from 0 to the highest, as squares

  /// Solves the table for a wall and pressures from 0 to `highest` (in G). About 0.3 s. Throws
  /// Error{kBadParameter} as WrungTube does.
  WringTable(const TubeWall& wall, double highest);

  /// Returns the tube at an angle of either sign and a pressure, brought into the table's range. In the tick:
  /// no more than + - * / and a root, no allocation, same bits everywhere.
  [[nodiscard]] WrungState at(double angle_rad, double pressure) const noexcept;
  /// Returns at().torque, same bits, for a fraction of its time. In the tick.
  [[nodiscard]] double torqueAt(double angle_rad, double pressure) const noexcept;
  /// Returns how the tube lies at a share of its length, 0 at the fixed end. In the tick, as at().
  [[nodiscard]] WrungPlace placeAt(double share, double angle_rad, double pressure) const noexcept;
  /// Writes how the tube lies at equal shares of its length, both ends among them: placeAt() up to rounding,
  /// for a fraction of its time.
  void placesAt(double angle_rad, double pressure, std::span<WrungPlace> places) const noexcept;
  /// Solved tubes that a query mixes, of rows of pressure, and their weights, of sum 1.
  struct Mix {
    std::array<std::size_t, 4> solved{};
    std::array<double, 4> weights{};
  };
  /// Returns what a query at an angle and a pressure mixes. Any thread.
  [[nodiscard]] Mix mixAt(double angle_rad, double pressure) const noexcept;
  /// Returns how many tubes the table has solved.
  [[nodiscard]] std::size_t solvedCount() const noexcept { return rows_.size() * kAngles; }
  /// Writes how a solved tube lies at equal shares of its length, as placesAt() does.
  void solvedPlaces(std::size_t solved, std::span<WrungPlace> places) const noexcept;
  /// Returns the angle up to which the solved wall is taut everywhere.
  [[nodiscard]] double taut_rad(double pressure) const noexcept;
  /// Returns the angle at which the narrowest place is packed with wall.
  [[nodiscard]] double closing_rad(double pressure) const noexcept;
  /// Returns the largest torque on the way to closing.
  [[nodiscard]] double peakTorque(double pressure) const noexcept;

 private:
  static constexpr int kBeforeFolds = 12;
  static constexpr int kFolded = 24;
  static constexpr int kClosed = 4;
  static constexpr int kAngles = kBeforeFolds + kFolded + kClosed + 1;
  static constexpr double kBeyondClosing = 1.0;  // so far the table goes on, in (closing - onset)

  struct Row {
    double onset = 0.0;
    double closing = 0.0;
    std::array<WrungState, kAngles> states;
    std::vector<WrungPlace> places;  // of each angle one a node
  };
  struct Path;
  struct Between {
    const Row* low = nullptr;
    const Row* high = nullptr;
    double share = 0.0;
  };
  // A cell of the table, and where in it.
  struct Cell {
    Between rows;
    std::size_t angle = 0;
    double share = 0.0;
  };
  [[nodiscard]] Cell cellAt(double angle_rad, double pressure) const noexcept;
  [[nodiscard]] static Row solvedRow(const TubeWall& wall, double pressure);
  [[nodiscard]] Between rowsAt(double pressure) const noexcept;

  double highest_ = 0.0;
  std::vector<Row> rows_;
};

/// Returns what a solved tube with so many folds is like: the waist, and how much of it is open. The folds
/// take part of the lumen: its radius is r sqrt(1 - eps^2 / 2), eps^2 = ((R / r)^2 - 1) / (n^2 / 2 - 1); the
/// wall itself fills sqrt(2 R t).
[[nodiscard]] WrungState wrungState(const TubeWall& wall, const WrungShape& shape, int waves) noexcept;

}  // namespace torsio
