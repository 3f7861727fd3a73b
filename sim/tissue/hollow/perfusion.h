// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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

/// Colour of an organ's outside, sRGB, each 0 .. 1.
struct TissueColour {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
  friend constexpr bool operator==(const TissueColour&, const TissueColour&) = default;
};

// The five colours are assumed: chosen to read as a surgeon describes them, not measured. What moves the mix
// between them has sources (docs/model.md P).
inline constexpr TissueColour kSerosaPink{0.86, 0.57, 0.53};  ///< blood as well saturated as in a sound organ
inline constexpr TissueColour kSerosaDusky{0.56, 0.38,
                                           0.42};  ///< blood as badly saturated as after 720 degrees
inline constexpr TissueColour kSerosaPurple{0.36, 0.14, 0.33};  ///< veins shut, artery open
inline constexpr TissueColour kSerosaPale{0.80, 0.74, 0.69};    ///< artery shut, little blood inside
inline constexpr TissueColour kSerosaBlack{0.10, 0.07, 0.09};   ///< dead
inline constexpr double kSaturationSound = 0.78;                ///< of a sound testis (Hallacoglu 2009)
inline constexpr double kSaturationDusky = 0.36;                ///< after 720 degrees (Hallacoglu 2009)
inline constexpr double kMaxPurple = 0.85;  ///< share of purple at full congestion: assumed
/// Dose below which tissue does not blacken, and from which it is black; assumed. Rat adnexa that are
/// bluish-black since 4 h are sound at 24 h: a little dose must not darken the outside.
inline constexpr double kDoseFirstBlack = 0.7;
inline constexpr double kDoseBlack = 1.2;

/// Returns the share of purple at a congestion, 0 .. 1. Veins fill most at the first millimetres of mercury
/// and hardly at the last: a turn that dams up a quarter of the pressure shows nearly half of the purple. The
/// shape is assumed.
[[nodiscard]] inline double purpleShare(double congestion) noexcept {
  const double empty = 1.0 - std::clamp(congestion, 0.0, 1.0);
  return kMaxPurple * (1.0 - empty * empty);
}

/// Returns how much of the outside is black from loss, 0 .. 1: smoothstep between kDoseFirstBlack and
/// kDoseBlack.
[[nodiscard]] inline double blackShare(double dose) noexcept {
  const double u = std::clamp((dose - kDoseFirstBlack) / (kDoseBlack - kDoseFirstBlack), 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

/// Returns `share` of the way from one colour to another.
[[nodiscard]] inline TissueColour mixed(const TissueColour& from, const TissueColour& to,
                                        double share) noexcept {
  const double rest = 1.0 - share;
  return {rest * from.red + share * to.red, rest * from.green + share * to.green,
          rest * from.blue + share * to.blue};
}

/// Returns the colour of the serosa: pink by the saturation of its blood, purple where blood is dammed up,
/// pale where neither flow nor dammed blood fills it, black from loss. It is not a measure of viability:
/// below a dose of kDoseFirstBlack the dose does not show at all. Any thread.
[[nodiscard]] inline TissueColour colourOf(const PerfusionState& state) noexcept {
  const double sound =
      std::clamp((state.saturation - kSaturationDusky) / (kSaturationSound - kSaturationDusky), 0.0, 1.0);
  const double pale = std::clamp(1.0 - state.flow - state.congestion, 0.0, 1.0);
  const TissueColour filled =
      mixed(mixed(kSerosaDusky, kSerosaPink, sound), kSerosaPurple, purpleShare(state.congestion));
  return mixed(mixed(filled, kSerosaPale, pale), kSerosaBlack, blackShare(state.dose));
}

}  // namespace torsio
