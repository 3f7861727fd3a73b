// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

/// Sine and cosine of one angle. The C library picks its sine by processor (with and without fused
/// multiply-add), and the last bit differs. What enters a recorded sample uses the functions of this header
/// instead: they give the same bits on every machine, because they consist of correctly rounded IEEE
/// operations only. Accuracy: below 2.5 units in the last place for
/// |x| <= 1e5; larger or non-finite arguments give a quiet NaN (sine, cosine).
struct SinCos {
  double sin = 0.0;
  double cos = 1.0;
};

[[nodiscard]] SinCos portableSinCos(double x) noexcept;
/// Returns the angle of (x, y) in (-pi, pi]; (0, 0) gives 0.
[[nodiscard]] double portableAtan2(double y, double x) noexcept;
/// Returns e^x; below -708 gives 0, above 709 gives infinity.
[[nodiscard]] double portableExp(double x) noexcept;
/// Returns the natural logarithm of x > 0; otherwise NaN (x < 0) or -infinity (x = 0).
[[nodiscard]] double portableLog(double x) noexcept;

inline constexpr double kPi = 3.14159265358979323846;

/// Returns the value of `angle_rad` + 2 pi k that lies nearest to `reference_rad`.
[[nodiscard]] double unwrapNear(double angle_rad, double reference_rad) noexcept;

}  // namespace torsio
