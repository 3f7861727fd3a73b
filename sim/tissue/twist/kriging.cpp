// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/kriging.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/index.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

/// Samples count as equally spaced when no step differs from the mean by more than this part of it.
constexpr double kEqualSpacing = 1e-10;
/// A covariance matrix worse than this has lost every digit: treated like a pivot that failed.
constexpr double kWorstCondition = 1e14;
constexpr double kFirstNugget = 1e-12;
constexpr double kLastNugget = 0.999e-8;  // 1e-8 up to rounding

void checkOptions(const KrigingOptions& options) {
  const auto text = [](double value) { return std::to_string(value); };
  if (!(options.rangeInSpacings > 0.0) || !(options.rangeInSpacings <= 1e6)) {
    refuseParameter(
        Text::verbatim("kriging range is %1 spacings, outside 0 to 1e6", text(options.rangeInSpacings)),
        Text::verbatim("kriging options"), Text::verbatim("Choose a range above 0, usually 20"));
  }
  if (!(options.nugget >= 0.0) || !(options.nugget <= 1.0)) {
    refuseParameter(Text::verbatim("kriging nugget is %1, outside 0 to 1", text(options.nugget)),
                    Text::verbatim("kriging options"),
                    Text::verbatim("Choose 0 unless the samples carry noise"));
  }
  if (options.window < 0 || options.window == 1) {
    refuseParameter(Text::verbatim("kriging window is %1 samples, it must be 0 (all) or at least 2",
                                   std::to_string(options.window)),
                    Text::verbatim("kriging options"), Text::verbatim("Choose 8"));
  }
}

void checkSamples(std::span<const double> samples) {
  if (samples.size() < 2) {
    refuseParameter(
        Text::verbatim("kriging needs at least 2 samples, there are %1", std::to_string(samples.size())),
        Text::verbatim("kriging samples"), Text::verbatim("Give more sections"));
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!std::isfinite(samples[i])) {
      refuseParameter(Text::verbatim("an abscissa is not a finite number"),
                      Text::verbatim("kriging sample %1", std::to_string(i + 1)),
                      Text::verbatim("Correct the sample"));
    }
    if (i > 0 && !(samples[i] > samples[i - 1])) {
      refuseParameter(Text::verbatim("abscissae must increase: %1 follows %2", std::to_string(samples[i]),
                                     std::to_string(samples[i - 1])),
                      Text::verbatim("kriging sample %1", std::to_string(i + 1)),
                      Text::verbatim("Sort the samples and leave out repeated ones"));
    }
  }
}

int driftTerms(Drift drift) {
  return drift == Drift::kLinear ? 2 : 1;
}

}  // namespace

double covarianceAt(Covariance covariance, double lag, double range) {
  constexpr double kSqrt3 = 1.7320508075688772;
  constexpr double kSqrt5 = 2.2360679774997897;
  const double u = lag / range;
  switch (covariance) {
    case Covariance::kGaussian:
      return portableExp(-u * u);
    case Covariance::kExponential:
      return portableExp(-u);
    case Covariance::kSpherical:
      return u < 1.0 ? 1.0 - 0.5 * u * (3.0 - u * u) : 0.0;
    case Covariance::kMatern32:
      return (1.0 + kSqrt3 * u) * portableExp(-kSqrt3 * u);
    case Covariance::kMatern52:
      return (1.0 + kSqrt5 * u + 5.0 / 3.0 * u * u) * portableExp(-kSqrt5 * u);
  }
  TORSIO_EXPECTS(false);
  return 0.0;
}

/// The factorised systems of all windows. Unknowns: lambda, then minus the Lagrange multipliers (sign of
/// Eq. 16); abscissae in spacings from the first sample of the window.
struct Kriging1d::Systems {
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  struct Window {
    Eigen::MatrixXd covariance;  // with nugget
    RowMatrix factors;           // of the whole system: L (unit diagonal) and U
    std::vector<int> rows;       // row of the system that each row of the factors came from
    Eigen::MatrixXd correction;  // takes a defect of the conditions out of the weights
    std::vector<double> places;  // of the samples, in spacings from the first

    void factorize(const Eigen::MatrixXd& drift) {
      const Eigen::Index n = covariance.rows(), p = drift.cols();
      Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n + p, n + p);
      full.topLeftCorner(n, n) = covariance;
      full.topRightCorner(n, p) = drift;
      full.bottomLeftCorner(p, n) = drift.transpose();
      const Eigen::PartialPivLU<Eigen::MatrixXd> lu(full);
      factors = lu.matrixLU();
      rows.resize(torsio::at(static_cast<int>(n + p)));
      for (Eigen::Index i = 0; i < n + p; ++i) {
        rows[static_cast<std::size_t>(lu.permutationP().indices()(i))] = static_cast<int>(i);
      }
      correction = drift * (drift.transpose() * drift).inverse();
    }

    /// Forward and back substitution. An inverse would be quicker, but at condition 1e7 it costs two digits.
    void solve(const double* right, double* x) const {
      const auto size = static_cast<Eigen::Index>(rows.size());
      Eigen::Map<Eigen::VectorXd> y(x, size);
      for (Eigen::Index i = 0; i < size; ++i) {
        y(i) = right[rows[static_cast<std::size_t>(i)]] - factors.row(i).head(i).dot(y.head(i));
      }
      for (Eigen::Index i = size - 1; i >= 0; --i) {
        const Eigen::Index done = size - 1 - i;
        y(i) = (y(i) - factors.row(i).tail(done).dot(y.tail(done))) / factors(i, i);
      }
    }
  };
  bool shared = false;
  std::vector<Window> windows;

  [[nodiscard]] const Window& at(int first) const { return windows[shared ? 0 : torsio::at(first)]; }
};

namespace {

Eigen::MatrixXd covarianceMatrix(const std::vector<double>& places, const KrigingOptions& options,
                                 double nugget) {
  const auto n = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd c(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      c(i, j) =
          covarianceAt(options.covariance,
                       std::abs(places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)]),
                       options.rangeInSpacings);
    }
  }
  c.diagonal().array() += nugget;
  return c;
}

/// 1 and the place, scaled to the window so that both columns are of order 1.
Eigen::MatrixXd driftMatrix(const std::vector<double>& places, Drift drift) {
  const auto n = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd f(n, driftTerms(drift));
  f.col(0).setOnes();
  if (drift == Drift::kLinear) {
    for (Eigen::Index i = 0; i < n; ++i) {
      f(i, 1) = places[static_cast<std::size_t>(i)] / places.back();
    }
  }
  return f;
}

/// Condition number (estimate in the 1-norm); infinity when a pivot of the Cholesky factorisation fails.
double conditionOf(const Eigen::MatrixXd& covariance) {
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  const double reciprocal = factor.info() == Eigen::Success ? factor.rcond() : 0.0;
  return reciprocal > 0.0 ? 1.0 / reciprocal : std::numeric_limits<double>::infinity();
}

}  // namespace

Kriging1d::Kriging1d(std::span<const double> samples, const KrigingOptions& options)
    : samples_(samples.begin(), samples.end()), options_(options) {
  checkOptions(options);
  checkSamples(samples);
  const int count = static_cast<int>(samples.size());
  window_ = options.window == 0 ? count : std::min(options.window, count);
  spacing_ = (samples_.back() - samples_.front()) / (count - 1);
  auto systems = std::make_shared<Systems>();
  systems->shared = true;
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    if (std::abs(samples_[i] - samples_[i - 1] - spacing_) > kEqualSpacing * spacing_) {
      systems->shared = false;
    }
  }
  systems->windows.resize(systems->shared ? 1 : torsio::at(count - window_ + 1));
  for (std::size_t first = 0; first < systems->windows.size(); ++first) {
    for (int i = 0; i < window_; ++i) {
      systems->windows[first].places.push_back(
          systems->shared ? static_cast<double>(i)
                          : (samples_[first + torsio::at(i)] - samples_[first]) / spacing_);
    }
  }
  chooseNugget(*systems);
  for (auto& window : systems->windows) {
    window.factorize(driftMatrix(window.places, options_.drift));
  }
  systems_ = std::move(systems);
}

/// One nugget for all windows: the smallest with which every one of them can be solved.
void Kriging1d::chooseNugget(Systems& systems) {
  nuggetUsed_ = options_.nugget;
  for (;;) {
    conditionNumber_ = 1.0;
    for (auto& window : systems.windows) {
      window.covariance = covarianceMatrix(window.places, options_, nuggetUsed_);
      conditionNumber_ = std::max(conditionNumber_, conditionOf(window.covariance));
    }
    if (conditionNumber_ <= kWorstCondition) {
      return;
    }
    if (nuggetUsed_ >= kLastNugget) {
      refuseParameter(Text::verbatim("the covariance matrix is singular even with a nugget of 1e-8"),
                      Text::verbatim("kriging options"),
                      Text::verbatim("Choose a shorter range or another covariance"));
    }
    nuggetUsed_ = std::max(10.0 * nuggetUsed_, kFirstNugget);
  }
}

int Kriging1d::firstOf(double query) const {
  const int count = static_cast<int>(samples_.size());
  if (window_ == count) {
    return 0;
  }
  // Take the nearer neighbour again and again; with equal spacing and an even window the choice changes at
  // samples only, where every window gives the sample, so that the estimate is continuous.
  int high = static_cast<int>(std::upper_bound(samples_.begin(), samples_.end(), query) - samples_.begin());
  int low = high;
  for (int taken = 0; taken < window_; ++taken) {
    if (high >= count || (low > 0 && query - samples_[at(low - 1)] <= samples_[at(high)] - query)) {
      --low;
    } else {
      ++high;
    }
  }
  return low;
}

void Kriging1d::solve(double query, int first, std::span<double> lambda, double* variance) const {
  // Windows are small: their right-hand side and solution stay on the stack.
  constexpr int kSmall = 34;
  const Systems::Window& w = systems_->at(first);
  const int n = window_, p = driftTerms(options_.drift);
  std::array<double, 2 * kSmall> small;
  std::vector<double> large(n + p > kSmall ? at(2 * (n + p)) : 0);
  double* right = large.empty() ? small.data() : large.data();
  double* solution = right + n + p;
  const double place = (query - samples_[at(first)]) / spacing_;
  const double span = w.places.back();
  for (int i = 0; i < n; ++i) {
    right[i] = covarianceAt(options_.covariance, std::abs(w.places[at(i)] - place), options_.rangeInSpacings);
  }
  right[n] = 1.0;
  if (p == 2) {
    right[n + 1] = place / span;
  }
  w.solve(right, solution);
  const Eigen::Map<const Eigen::VectorXd> c0(right, n);
  Eigen::Map<Eigen::VectorXd> weights(lambda.data(), n);
  weights = Eigen::Map<const Eigen::VectorXd>(solution, n);
  // The conditions on the weights (Eq. 7 and the drift) hold to rounding, whatever the condition number; the
  // second round takes out what the first one rounded.
  for (int round = 0; round < 2; ++round) {
    double defect0 = 1.0, defect1 = p == 2 ? right[n + 1] : 0.0;
    for (int i = 0; i < n; ++i) {
      defect0 -= weights(i);
      if (p == 2) {
        defect1 -= weights(i) * (w.places[at(i)] / span);
      }
    }
    weights += defect0 * w.correction.col(0);
    if (p == 2) {
      weights += defect1 * w.correction.col(1);
    }
  }
  if (variance == nullptr) {
    return;
  }
  // Eq. 8 in full: right for any weights that sum to 1.
  const double sigma2 =
      weights.dot(w.covariance * weights) - nuggetUsed_ * weights.squaredNorm() - 2.0 * weights.dot(c0) + 1.0;
  *variance = std::max(sigma2, 0.0);
}

KrigingWeights Kriging1d::weights(double query) const {
  TORSIO_EXPECTS(std::isfinite(query));
  query = std::clamp(query, samples_.front(), samples_.back());
  const auto sample = std::lower_bound(samples_.begin(), samples_.end(), query);
  KrigingWeights out;
  out.first = firstOf(query);
  out.lambda.assign(at(window_), 0.0);
  if (*sample == query) {
    out.lambda[at(static_cast<int>(sample - samples_.begin()) - out.first)] = 1.0;
  } else {
    solve(query, out.first, out.lambda, &out.variance);
  }
  return out;
}

double Kriging1d::estimate(double query, std::span<const double> values) const {
  TORSIO_EXPECTS(values.size() == samples_.size());
  const KrigingWeights w = weights(query);
  double sum = 0.0;
  for (std::size_t i = 0; i < w.lambda.size(); ++i) {
    sum += w.lambda[i] * values[at(w.first) + i];
  }
  return sum;
}

KrigingTable::KrigingTable(const Kriging1d& kriging, std::span<const double> queries)
    : width_(kriging.windowSize()) {
  first_.reserve(queries.size());
  lambda_.assign(queries.size() * at(width_), 0.0);
  const std::span<const double> samples = kriging.samples();
  for (std::size_t q = 0; q < queries.size(); ++q) {
    TORSIO_EXPECTS(std::isfinite(queries[q]));
    const double query = std::clamp(queries[q], samples.front(), samples.back());
    const int first = kriging.firstOf(query);
    const std::span<double> row = std::span(lambda_).subspan(q * at(width_), at(width_));
    const auto sample = std::lower_bound(samples.begin(), samples.end(), query);
    if (*sample == query) {
      row[at(static_cast<int>(sample - samples.begin()) - first)] = 1.0;
    } else {
      kriging.solve(query, first, row, nullptr);
    }
    first_.push_back(first);
  }
}

}  // namespace torsio
