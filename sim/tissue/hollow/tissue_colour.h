// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "sim/tissue/hollow/perfusion.h"

namespace torsio {

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
/// pale where neither flow nor dammed blood fills it, black from loss. It is no measure of viability: below a
/// dose of kDoseFirstBlack the dose does not show at all. Any thread.
[[nodiscard]] inline TissueColour colourOf(const PerfusionState& state) noexcept {
  const double sound =
      std::clamp((state.saturation - kSaturationDusky) / (kSaturationSound - kSaturationDusky), 0.0, 1.0);
  const double pale = std::clamp(1.0 - state.flow - state.congestion, 0.0, 1.0);
  const TissueColour filled =
      mixed(mixed(kSerosaDusky, kSerosaPink, sound), kSerosaPurple, purpleShare(state.congestion));
  return mixed(mixed(filled, kSerosaPale, pale), kSerosaBlack, blackShare(state.dose));
}

}  // namespace torsio
