// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace torsio {

/// Two-sided tabular CUSUM of measured values around a target.
struct TabularCusumPoint {
  double upper = 0.0;  ///< C+
  double lower = 0.0;  ///< C-
  int upperRun = 0;    ///< number of values since C+ was last 0
  int lowerRun = 0;
};
struct TabularCusum {
  std::vector<TabularCusumPoint> points;
  std::optional<std::size_t> firstSignal;  ///< index of the value, from 1
};
/// Computes a tabular CUSUM. `reference` K and `limit` H are in the unit of the values (k sigma, h sigma; k =
/// 0.5 and h = 4 or 5 are usual). Sigma estimated from trials during learning is too large.
[[nodiscard]] TabularCusum tabularCusum(std::span<const double> values, double target, double reference,
                                        double limit);

/// Computes the average run length of the one-sided and two-sided CUSUM of normal values, in units of sigma,
/// from the integral equation (Gauss-Legendre collocation); empty above 1e12, where double precision fails.
[[nodiscard]] std::optional<double> averageRunLengthOneSided(double k, double h, double shift);
[[nodiscard]] std::optional<double> averageRunLengthTwoSided(double k, double h, double shift);

/// CUSUM of successes and failures as drawn in the surgical literature: a failure adds 1 - s, a success
/// subtracts s.
struct BinaryCusum {
  double s = 0.0;
  double h0 = 0.0;  ///< crossing this many below: performance is as good as p0
  double h1 = 0.0;  ///< crossing this many above: as bad as p1
  std::vector<double> sums;
};
/// Computes the CUSUM of successes and failures for the failure rates `acceptable` p0 < `unacceptable` p1.
[[nodiscard]] BinaryCusum binaryCusum(const std::vector<bool>& failed, double acceptable, double unacceptable,
                                      double alpha, double beta);

/// How attempts of one person depend on each other: they come in sessions whose failure rates differ, and an
/// attempt takes after the one before it. With probability `lag` an attempt repeats the outcome before it;
/// otherwise it fails at the session's rate, which follows a beta distribution. The failure rate of all
/// attempts is the mean of that distribution.
struct AttemptDependence {
  double session = 0.0;  ///< correlation of attempts of one session through its rate, at least 0, below 1
  double lag = 0.0;      ///< of successive attempts, at least 0, below 1
  std::int64_t perSession = 1;  ///< attempts of a session
  friend bool operator==(const AttemptDependence&, const AttemptDependence&) = default;
};

/// LC-CUSUM (Biau and Porcher 2010): assumes that the trainee is not yet adequate and signals when that has
/// become untenable. S = max(0, S + W).
struct LcCusumDesign {
  double adequate = 0.1;           ///< failure rate p0
  double inadequate = 0.2;         ///< failure rate p1 > p0
  double limit = 1.25;             ///< h
  AttemptDependence dependence{};  ///< changes the probabilities, not the sum
};
struct LcCusum {
  double successWeight = 0.0;
  double failureWeight = 0.0;
  std::vector<double> sums;
  std::optional<std::size_t> competentAt;  ///< index of the attempt, from 1
};
[[nodiscard]] LcCusum lcCusum(const std::vector<bool>& failed, const LcCusumDesign& design);

/// Computes the exact probability that a trainee with the given failure rate is declared competent within
/// so many attempts.
[[nodiscard]] double lcCusumProbability(const LcCusumDesign& design, double failureRate,
                                        std::size_t attempts);

/// Computes the exact probability that a trainee with the given failure rate does not count as competent
/// after so many attempts: never declared, or revoked by an alarm of watchForRelapse().
[[nodiscard]] double lcCusumNotAble(const LcCusumDesign& design, double failureRate, std::size_t attempts);

/// Returns the smallest limit, in steps of 0.01, at which an inadequate trainee passes with probability at
/// most `falsePass`; empty if even the largest reachable sum would be too low. Ignores `design.limit`.
[[nodiscard]] std::optional<double> chooseLcCusumLimit(LcCusumDesign design, std::size_t attempts,
                                                       double falsePass);

/// Monitoring for relapse after competence: S = max(0, S + W') with reversed weights; an alarm means that the
/// skill has decayed.
struct RelapseWatch {
  std::vector<double> sums;
  std::optional<std::size_t> alarmAt;
};
[[nodiscard]] RelapseWatch watchForRelapse(const std::vector<bool>& failed, const LcCusumDesign& design);

}  // namespace torsio
