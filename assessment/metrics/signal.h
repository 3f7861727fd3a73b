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
inline constexpr double kLargestGap_s = 0.020;         ///< a longer gap splits the trial

/// Second-order section, a0 = 1: y = b0 x + b1 x1 + b2 x2 - a1 y1 - a2 y2.
struct Biquad {
  double b0 = 1.0;
  double b1 = 0.0;
  double b2 = 0.0;
  double a1 = 0.0;
  double a2 = 0.0;
};

/// Designs a Butterworth low-pass for running forward and backward, so that the two passes together have
/// gain 1/sqrt(2) at the cut-off (the correction acts on the warped frequency).
[[nodiscard]] Biquad butterworthForTwoPasses(double cutoff_Hz, double rate_Hz);

/// Filters forward and backward, without phase shift: odd reflection of `reflected` samples (fewer when the
/// signal is shorter) and a steady-state start.
[[nodiscard]] std::vector<double> filterZeroPhase(const Biquad& filter, std::span<const double> signal,
                                                  std::size_t reflected = kReflectedSamples);
/// Filters a signal by butterworthForTwoPasses and filterZeroPhase.
[[nodiscard]] std::vector<double> lowPass(std::span<const double> signal, double cutoff_Hz, double rate_Hz);

/// Differentiates by central differences, one-sided at the ends; per second.
[[nodiscard]] std::vector<double> derivative(std::span<const double> signal, double rate_Hz);

/// A signal on a uniform grid, or what is wrong with its time stamps.
struct UniformSignal {
  double rate_Hz = 1000.0;
  std::vector<std::vector<double>> channels;
  std::size_t lost = 0;  ///< grid points that fell into gaps of at most 20 ms and were interpolated
};
/// Resamples channels with common time stamps to a uniform grid by linear interpolation. Throws
/// Error{kBadData} when time stamps do not rise or a gap exceeds 20 ms (split there first: longGaps).
[[nodiscard]] UniformSignal resampleUniform(std::span<const std::int64_t> times_us,
                                            const std::vector<std::vector<double>>& channels,
                                            double rate_Hz = 1000.0);
/// Position of the last sample at or before every point of the grid of resampleUniform: what is a category,
/// or stays until it is changed by a command, is held from that sample and never interpolated. `times_us`
/// must rise.
[[nodiscard]] std::vector<std::size_t> samplesInForce(std::span<const std::int64_t> times_us,
                                                      double rate_Hz = 1000.0);
/// Finds the positions after which a gap longer than 20 ms follows.
[[nodiscard]] std::vector<std::size_t> longGaps(std::span<const std::int64_t> times_us);

/// Integrates by trapezoids, all samples 1/rate apart.
[[nodiscard]] double trapezoid(std::span<const double> signal, double rate_Hz);

}  // namespace torsio
