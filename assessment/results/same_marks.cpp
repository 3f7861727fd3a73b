// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/same_marks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace torsio {

namespace {

constexpr std::int64_t kOneIn = 10;  // shared marks at most that differ
constexpr double kByChance = 0.05;   // cohorts with a pair by chance

/// All marks of a trainee in one order, and how often chance makes two of them equal.
struct Cells {
  std::vector<std::vector<std::optional<double>>> marks;  ///< trainees x cells
  std::vector<double> alike;                              ///< by cell
};

/// Smallest distance between two different marks; 0 if there are none.
double stepOf(const OccasionMarks& at) {
  std::set<double> used;
  for (const std::vector<std::optional<double>>& row : at.marks) {
    for (const std::optional<double>& mark : row) {
      if (mark) {
        used.insert(*mark);
      }
    }
  }
  double step = 0.0;
  for (auto mark = used.begin(); mark != used.end() && std::next(mark) != used.end(); ++mark) {
    const double distance = *std::next(mark) - *mark;
    step = step == 0.0 ? distance : std::min(step, distance);
  }
  return step;
}

/// Probability that two marks by one rater of the same performance are equal after rounding to steps.
double equalByNoise(const OccasionMarks& at) {
  const double step = stepOf(at);
  if (!at.reliability || step == 0.0) {
    return 0.0;
  }
  constexpr double kOfRounding = 1.0 / 12.0;
  const double variance = at.reliability->varianceResidual - kOfRounding * step * step;
  if (variance <= 0.0) {
    return 1.0;
  }
  const double x = step / std::sqrt(2.0 * variance);
  const auto density = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); };
  return std::erf(x / std::numbers::sqrt2) - 2.0 / x * (density(0.0) - density(x));
}

/// Share of the pairs of a rater's marks that are equal.
double equalOfRater(const OccasionMarks& at, std::size_t rater) {
  std::map<double, double> counts;
  double all = 0.0;
  for (const std::vector<std::optional<double>>& row : at.marks) {
    if (row[rater]) {
      counts[*row[rater]] += 1.0;
      all += 1.0;
    }
  }
  double equal = 0.0;
  for (const auto& [mark, count] : counts) {
    equal += count * (count - 1.0);
  }
  return all > 1.0 ? equal / (all * (all - 1.0)) : 0.0;
}

Cells cellsOf(std::size_t trainees, const std::vector<OccasionMarks>& occasions) {
  Cells out;
  out.marks.resize(trainees);
  for (const OccasionMarks& at : occasions) {
    const double noise = equalByNoise(at);
    for (const std::size_t rater : at.present) {
      out.alike.push_back(std::max(noise, equalOfRater(at, rater)));
      for (std::size_t i = 0; i < trainees; ++i) {
        out.marks[i].push_back(at.marks[i][rater]);
      }
    }
  }
  return out;
}

/// Probability of `least` or more successes among `n`.
double atLeast(std::int64_t least, std::int64_t n, double probability) {
  if (probability >= 1.0) {
    return 1.0;
  }
  double sum = 0.0;
  for (std::int64_t k = least; k <= n && probability > 0.0; ++k) {
    const auto successes = static_cast<double>(k);
    const auto all = static_cast<double>(n);
    sum +=
        std::exp(std::lgamma(all + 1.0) - std::lgamma(successes + 1.0) - std::lgamma(all - successes + 1.0) +
                 successes * std::log(probability) + (all - successes) * std::log1p(-probability));
  }
  return sum;
}

}  // namespace

std::vector<AlikeTrainees> traineesMarkedAlike(const std::vector<std::string>& trainees,
                                               const std::vector<OccasionMarks>& occasions) {
  const Cells cells = cellsOf(trainees.size(), occasions);
  const double pairs = 0.5 * static_cast<double>(trainees.size()) * static_cast<double>(trainees.size() - 1);
  const std::int64_t all = std::ssize(cells.alike);
  std::vector<AlikeTrainees> out;
  for (std::size_t i = 0; i < trainees.size(); ++i) {
    for (std::size_t j = i + 1; j < trainees.size(); ++j) {
      AlikeTrainees pair{trainees[i], trainees[j]};
      double chance = 0.0;
      for (std::size_t c = 0; c < cells.alike.size() && kOneIn * (pair.shared - pair.same) <= all; ++c) {
        const std::optional<double>& one = cells.marks[i][c];
        const std::optional<double>& other = cells.marks[j][c];
        if (one && other) {
          ++pair.shared;
          pair.same += *one == *other ? 1 : 0;
          chance += cells.alike[c];
        }
      }
      if (pair.shared > 0 && kOneIn * (pair.shared - pair.same) <= pair.shared &&
          pairs * atLeast(pair.same, pair.shared, chance / static_cast<double>(pair.shared)) < kByChance) {
        out.push_back(std::move(pair));
      }
    }
  }
  return out;
}

}  // namespace torsio
