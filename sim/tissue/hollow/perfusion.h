// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace torsio {

/// Vessels and tissue of an organ on a pedicle (docs/model.md P). Pressures in mmHg, as clinicians write
/// them; times in seconds of the tissue's own time.
struct PerfusionParameters {
  double arterial_mmHg = 90.0;
  double venous_mmHg = 5.0;
  double shutAtTurn_mmHg = 35.0;      ///< P_1: pressure at which vessels turned by 360 degrees reopen
  double shutPower = 1.28;            ///< k, from 1 on
  double pedicle_m = 0.06;            ///< L_v
  double pedicleReference_m = 0.06;   ///< L_ref: the length for which P_1 holds
  double pedicleShare = 1.0;          ///< of the organ's angle that the pedicle turns by
  double lumenThreshold_mmHg = 25.0;  ///< pressure in the lumen less this shuts the vessels of the wall
  double lumenFloor = 0.25;           ///< least flow that pressure in the lumen leaves
  double flowTime_s = 60.0;           ///< tau_q
  double lossTime_s = 6.0 * 3600.0;   ///< tau_i: without flow the tissue is lost after so long
  double enoughFlow = 0.5;            ///< q_c: above it the tissue recovers
};

/// Blood supply of an organ between ticks. Trivially copyable.
struct PerfusionState {
  double flow = 1.0;         ///< q, against the untwisted organ
  double congestion = 0.0;   ///< c: 0 none, 1 as with shut veins and open artery
  double dose = 0.0;         ///< D: from 1 on the tissue is lost
  double saturation = 0.78;  ///< S: of the tissue's haemoglobin
  friend constexpr bool operator==(const PerfusionState&, const PerfusionState&) = default;
};
static_assert(std::is_trivially_copyable_v<PerfusionState>);

/// Vessels of an organ, ready for the tick: the power of the angle is tabled. Immutable; queries are noexcept
/// and allocate nothing.
class Perfusion {
 public:
  /// Tables the pressure at which the twisted vessels shut. Throws Error{kBadParameter} for numbers out of
  /// range.
  explicit Perfusion(const PerfusionParameters& parameters);

  /// Returns the flow at an angle (either sign) and a pressure in the lumen, once it has settled.
  [[nodiscard]] double steadyFlow(double angle_rad, double lumenPressure_mmHg) const noexcept;
  /// Returns the state of an organ that was sound and has then lain so for `since_s` of the tissue's time, by
  /// the closed form of step(). The same bits on every machine.
  [[nodiscard]] PerfusionState after(double angle_rad, double lumenPressure_mmHg,
                                     double since_s) const noexcept;
  /// Moves the state on by `duration_s` of the tissue's time, within which angle and pressure stay. In the
  /// tick: + - * / only.
  void step(PerfusionState& state, double angle_rad, double lumenPressure_mmHg,
            double duration_s) const noexcept;

  [[nodiscard]] const PerfusionParameters& parameters() const noexcept { return parameters_; }

 private:
  static constexpr std::size_t kCells = 64;
  /// Flow, and congestion of the tissue, once both have settled.
  struct Settled {
    double flow = 1.0;
    double congestion = 0.0;
  };
  [[nodiscard]] double shutPressure_mmHg(double angle_rad) const noexcept;
  [[nodiscard]] Settled settled(double angle_rad, double lumenPressure_mmHg) const noexcept;

  PerfusionParameters parameters_;
  double cellsPerRadian_ = 0.0;  ///< of the organ's angle; the table ends where the arteries are shut
  std::array<double, kCells + 1> pressure_mmHg_{};
  std::array<double, kCells + 1> slope_mmHg_{};  ///< per cell
};

}  // namespace torsio
