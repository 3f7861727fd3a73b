// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/core/vec3.h"

namespace torsio {

/// What the paper's equations need of one section: the real outline, not the polygon of key points.
struct PaperSection {
  double sag_m2 = 0.0;   ///< l: membrane height at its highest point for q/f = 1 /m
  double area_m2 = 0.0;  ///< S_c
};

struct PaperOptions {
  /// (M - 1) / beta of Eq. 18, free of the lattice: the twist rate grows by e to this power from the free end
  /// to the clamp. 0: uniform (beta infinite). Up to 1, so that the angle stays monotone; negative: the rate
  /// grows towards the free end.
  double rateExponent = 0.0;
  /// F-Lfrozen. True: the sag L is that of q/f = kappa0 in every section. False: the sag follows q/f, which
  /// then cancels, and Eq. 18 has no effect.
  bool freezeSag = true;
  double pressureOverTension_per_m = 1.0;  ///< F-kappa0: q/f at the free end; cancels in every result
  bool clampLift = false;                  ///< dZ of Eq. 23 also at the clamp, as printed
};

inline constexpr double kLargestRateExponent = 1.0;
inline constexpr double kSmallestRateExponent = -20.0;

/// The paper's twist of a cylinder by a torque of 1 N m at its free end, section by section. Index j counts
/// from the clamp (j = 0); the paper's label is i = M - j (F-origin).
struct PaperTwist {
  double spacing_m = 0.0;          ///< h
  std::vector<double> height_m;    ///< H_i = (M - i) h (Eq. 14 with F-origin)
  std::vector<double> rate_per_m;  ///< theta_i (Eq. 17), rad/m for 1 N m
  std::vector<double> angle_rad;   ///< H_i theta_i for 1 N m
  std::vector<double>
      lift_m2;  ///< 2 theta_i L f / q (Eq. 23 with F-divG): dZ = lift h / sqrt(X^2 + Y^2 + h^2)
};

/// Computes Eqs. 14, 17-19 and the factor of 23. `sections`: from the clamp (j = 0) to the free end, at
/// least 2. theta_i = M_T kappa_i / (4 V_i G), kappa_i = kappa0 e^((i - 1) / beta), V_i = L_i S_i / 3.
/// Throws Error{kBadParameter}: G or length not positive, a section without sag or area, rateExponent
/// outside -20..1.
[[nodiscard]] PaperTwist paperTwist(std::span<const PaperSection> sections, double length_m,
                                    double shearModulus_Pa, const PaperOptions& options = {});

/// Computes (dX, dY, dZ) of Eqs. 21-23 in the section's frame, for a point (x, y) from the centroid, the
/// angle phi = H theta and the lift of PaperTwist (each times the torque).
[[nodiscard]] Vec3 paperDisplacement(double x_m, double y_m, double angle_rad, double lift_m2,
                                     double spacing_m) noexcept;

}  // namespace torsio
