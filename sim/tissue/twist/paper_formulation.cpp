// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/paper_formulation.h"

#include <cmath>
#include <string>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr double kConeFactor = 1.0 / 3.0;  // Eq. 19: V = L S_c / 3

void checkInput(std::span<const PaperSection> sections, double length_m, double shearModulus_Pa,
                const PaperOptions& options) {
  TORSIO_EXPECTS(sections.size() >= 2);
  if (!(shearModulus_Pa > 0.0) || !std::isfinite(shearModulus_Pa)) {
    throw Error(
        ErrorCode::kBadParameter,
        Text::verbatim("the shear modulus is %1 Pa, but must be above 0", std::to_string(shearModulus_Pa)),
        Text::verbatim("material"),
        Text::verbatim("Give G in pascal; for nearly incompressible tissue it is E / 3."));
  }
  if (!(length_m > 0.0) || !std::isfinite(length_m)) {
    throw Error(ErrorCode::kBadParameter,
                Text::verbatim("the organ's length is %1 m", std::to_string(length_m)),
                Text::verbatim("lattice"), Text::verbatim("Give a length above 0."));
  }
  const double exponent = options.rateExponent;
  if (!(exponent >= kSmallestRateExponent && exponent <= kLargestRateExponent)) {
    throw Error(
        ErrorCode::kBadParameter,
        Text::verbatim("(M - 1) / beta of Eq. 18 is %1, but must lie in -20..1", std::to_string(exponent)),
        Text::verbatim("paper options"),
        Text::verbatim("Give at most 1, or the free end turns less than the middle."));
  }
  for (std::size_t j = 0; j < sections.size(); ++j) {
    if (!(sections[j].sag_m2 > 0.0) || !(sections[j].area_m2 > 0.0) ||
        !std::isfinite(sections[j].sag_m2 * sections[j].area_m2)) {
      throw Error(ErrorCode::kBadParameter, Text::verbatim("a section has no area"),
                  Text::verbatim("section %1", std::to_string(j)),
                  Text::verbatim("Check the organ's surface there."));
    }
  }
}

}  // namespace

PaperTwist paperTwist(std::span<const PaperSection> sections, double length_m, double shearModulus_Pa,
                      const PaperOptions& options) {
  checkInput(sections, length_m, shearModulus_Pa, options);
  const std::size_t m = sections.size();
  const double last = static_cast<double>(m - 1);
  const double kappa0 = options.pressureOverTension_per_m;
  PaperTwist twist;
  twist.spacing_m = length_m / last;
  for (std::size_t j = 0; j < m; ++j) {
    const double fromFreeEnd = last - static_cast<double>(j);  // i - 1
    const double kappa = kappa0 * portableExp(options.rateExponent * fromFreeEnd / last);
    const double sag = sections[j].sag_m2 * (options.freezeSag ? kappa0 : kappa);
    const double volume = kConeFactor * sag * sections[j].area_m2;
    const double height = static_cast<double>(j) * twist.spacing_m;
    const double rate = kappa / (4.0 * volume * shearModulus_Pa);
    const bool lifted = j > 0 || options.clampLift;
    twist.height_m.push_back(height);
    twist.rate_per_m.push_back(rate);
    twist.angle_rad.push_back(height * rate);
    twist.lift_m2.push_back(lifted ? 2.0 * rate * sag / kappa : 0.0);
  }
  return twist;
}

Vec3 paperDisplacement(double x_m, double y_m, double angle_rad, double lift_m2, double spacing_m) noexcept {
  const double slant = std::sqrt(x_m * x_m + y_m * y_m + spacing_m * spacing_m);
  return {-y_m * angle_rad, x_m * angle_rad, lift_m2 * spacing_m / slant};
}

}  // namespace torsio
