// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace torsio {

inline constexpr double kPoseCutoff_Hz = 10.0;
inline constexpr double kForceCutoff_Hz = 20.0;
inline constexpr std::size_t kReflectedSamples = 300;  ///< longer than the memory of 10 Hz at 1 kHz
inline constexpr double kLargestGap_s = 0.020;         ///< longer gaps split the trial

/// Second-order section, a0 = 1: y = b0 x + b1 x1 + b2 x2 - a1 y1 - a2 y2.
struct Biquad {
  double b0 = 1.0;
  double b1 = 0.0;
  double b2 = 0.0;
  double a1 = 0.0;
  double a2 = 0.0;
};

/// Designs a Butterworth low-pass for filtering forward and backward, with a total gain of 1/sqrt(2) at the
/// cut-off (the correction applies to the warped frequency).
[[nodiscard]] Biquad butterworthForTwoPasses(double cutoff_Hz, double rate_Hz);

/// Filters forward and backward, without phase shift: odd reflection of `reflected` samples (fewer if the
/// signal is shorter) and steady-state initial conditions.
[[nodiscard]] std::vector<double> filterZeroPhase(const Biquad& filter, std::span<const double> signal,
                                                  std::size_t reflected = kReflectedSamples);
/// Filters a signal with butterworthForTwoPasses() and filterZeroPhase().
[[nodiscard]] std::vector<double> lowPass(std::span<const double> signal, double cutoff_Hz, double rate_Hz);

/// Differentiates by central differences, one-sided at the ends; per second.
[[nodiscard]] std::vector<double> derivative(std::span<const double> signal, double rate_Hz);

/// A signal on a uniform grid.
struct UniformSignal {
  double rate_Hz = 1000.0;
  std::vector<std::vector<double>> channels;
  std::size_t lost = 0;  ///< grid points interpolated within gaps of at most 20 ms
};
/// Resamples channels with common time stamps to a uniform grid by linear interpolation. Throws
/// Error{kBadData} if time stamps do not increase or a gap exceeds 20 ms (split there first: longGaps()).
[[nodiscard]] UniformSignal resampleUniform(std::span<const std::int64_t> times_us,
                                            const std::vector<std::vector<double>>& channels,
                                            double rate_Hz = 1000.0);
/// Returns the index of the last sample at or before every grid point of resampleUniform(): categories, and
/// values that stay until a command, are held and never interpolated. `times_us` must increase.
[[nodiscard]] std::vector<std::size_t> samplesInForce(std::span<const std::int64_t> times_us,
                                                      double rate_Hz = 1000.0);
/// Finds the indices followed by a gap longer than 20 ms.
[[nodiscard]] std::vector<std::size_t> longGaps(std::span<const std::int64_t> times_us);

/// Integrates by trapezoids, samples 1/rate apart.
[[nodiscard]] double trapezoid(std::span<const double> signal, double rate_Hz);

}  // namespace torsio
