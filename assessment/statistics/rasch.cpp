// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rasch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <Eigen/Dense>

#include "assessment/statistics/cone.h"
#include "sim/base/error.h"
#include "sim/base/text.h"

namespace torsio {

namespace {

using Ratings = std::vector<std::vector<std::optional<int>>>;
using Eigen::Index;

constexpr int kMaxIterations = 200;
constexpr double kConverged = 1e-12;  // largest Newton step, logits

/// Probabilities of the categories at location ability - severity.
struct Category {
  std::vector<double> p;
  double mean = 0.0;
  double variance = 0.0;
};

Category categoryAt(double location, const std::vector<double>& tau) {
  Category out;
  out.p.assign(tau.size() + 1, 0.0);
  double exponent = 0.0;
  double largest = 0.0;
  for (std::size_t k = 1; k < out.p.size(); ++k) {
    exponent += location - tau[k - 1];
    out.p[k] = exponent;
    largest = std::max(largest, exponent);
  }
  double sum = 0.0;
  for (double& p : out.p) {
    p = std::exp(p - largest);
    sum += p;
  }
  for (std::size_t k = 0; k < out.p.size(); ++k) {
    out.p[k] /= sum;
    out.mean += static_cast<double>(k) * out.p[k];
  }
  for (std::size_t k = 0; k < out.p.size(); ++k) {
    const double d = static_cast<double>(k) - out.mean;
    out.variance += d * d * out.p[k];
  }
  return out;
}

/// Sets extreme persons and raters aside until none is left: without one, another may have become extreme.
class Plan {
 public:
  Plan(const Ratings& ratings, int highest)
      : ratings_(ratings),
        highest_(highest),
        persons(ratings.size(), RaschStatus::kEstimated),
        raters(ratings.empty() ? 0 : ratings.front().size(), RaschStatus::kEstimated) {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t n = 0; n < persons.size(); ++n)
        changed = judge(persons[n], personRatings(n), true) || changed;
      for (std::size_t r = 0; r < raters.size(); ++r)
        changed = judge(raters[r], raterRatings(r), false) || changed;
    }
  }

  [[nodiscard]] bool used(std::size_t n, std::size_t r) const {
    return ratings_[n][r] && persons[n] == RaschStatus::kEstimated && raters[r] == RaschStatus::kEstimated;
  }

  [[nodiscard]] bool connected() const {
    std::vector<std::size_t> root(persons.size() + raters.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
      while (root[i] != i) i = root[i];
      return i;
    };
    for (std::size_t n = 0; n < persons.size(); ++n)
      for (std::size_t r = 0; r < raters.size(); ++r)
        if (used(n, r)) root[find(n)] = find(persons.size() + r);
    std::optional<std::size_t> part;
    for (std::size_t i = 0; i < root.size(); ++i) {
      const RaschStatus status = i < persons.size() ? persons[i] : raters[i - persons.size()];
      if (status != RaschStatus::kEstimated) continue;
      if (part && *part != find(i)) return false;
      part = find(i);
    }
    return true;
  }

  const Ratings& ratings_;
  int highest_;
  std::vector<RaschStatus> persons;
  std::vector<RaschStatus> raters;

 private:
  [[nodiscard]] std::vector<int> personRatings(std::size_t n) const {
    std::vector<int> out;
    for (std::size_t r = 0; r < raters.size(); ++r)
      if (ratings_[n][r] && raters[r] == RaschStatus::kEstimated) out.push_back(*ratings_[n][r]);
    return out;
  }
  [[nodiscard]] std::vector<int> raterRatings(std::size_t r) const {
    std::vector<int> out;
    for (std::size_t n = 0; n < persons.size(); ++n)
      if (ratings_[n][r] && persons[n] == RaschStatus::kEstimated) out.push_back(*ratings_[n][r]);
    return out;
  }
  bool judge(RaschStatus& status, const std::vector<int>& marks, bool person) const {
    if (status != RaschStatus::kEstimated) return false;
    if (marks.empty()) {
      status = RaschStatus::kNoRatings;
      return true;
    }
    const auto [low, high] = std::minmax_element(marks.begin(), marks.end());
    // A rater who gives the lowest category only is infinitely severe.
    if (*high == 0) status = person ? RaschStatus::kExtremeLow : RaschStatus::kExtremeHigh;
    if (*low == highest_) status = person ? RaschStatus::kExtremeHigh : RaschStatus::kExtremeLow;
    return status != RaschStatus::kEstimated;
  }
};

/// Free parameters: abilities, then severities and thresholds without their last, which makes the sums 0.
class JointModel {
 public:
  JointModel(const Plan& plan, int highest) : plan_(plan), thresholds_(static_cast<std::size_t>(highest)) {
    for (std::size_t n = 0; n < plan.persons.size(); ++n)
      if (plan.persons[n] == RaschStatus::kEstimated) persons_.push_back(n);
    for (std::size_t r = 0; r < plan.raters.size(); ++r)
      if (plan.raters[r] == RaschStatus::kEstimated) raters_.push_back(r);
  }

  [[nodiscard]] Index size() const {
    return static_cast<Index>(persons_.size() + raters_.size() + thresholds_ - 2);
  }
  [[nodiscard]] const std::vector<std::size_t>& persons() const { return persons_; }
  [[nodiscard]] const std::vector<std::size_t>& raters() const { return raters_; }

  [[nodiscard]] double ability(const Eigen::VectorXd& x, std::size_t i) const {
    return x[static_cast<Index>(i)];
  }
  [[nodiscard]] double severity(const Eigen::VectorXd& x, std::size_t j) const {
    return constrained(x, persons_.size(), raters_.size(), j);
  }
  [[nodiscard]] std::vector<double> tau(const Eigen::VectorXd& x) const {
    std::vector<double> out;
    for (std::size_t k = 0; k < thresholds_; ++k)
      out.push_back(constrained(x, persons_.size() + raters_.size() - 1, thresholds_, k));
    return out;
  }

  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* gradient, Eigen::MatrixXd* information) const {
    const std::vector<double> thresholds = tau(x);
    double logLikelihood = 0.0;
    if (gradient != nullptr) gradient->setZero(size());
    if (information != nullptr) information->setZero(size(), size());
    for (std::size_t i = 0; i < persons_.size(); ++i)
      for (std::size_t j = 0; j < raters_.size(); ++j) {
        if (!plan_.used(persons_[i], raters_[j])) continue;
        const int mark = *plan_.ratings_[persons_[i]][raters_[j]];
        const Category at = categoryAt(ability(x, i) - severity(x, j), thresholds);
        logLikelihood += std::log(at.p[static_cast<std::size_t>(mark)]);
        if (gradient == nullptr) continue;
        // Each category k has the log weight s_k . x with a design row s_k; gradient and information are the
        // mean and covariance of these rows.
        Eigen::VectorXd mean = Eigen::VectorXd::Zero(size());
        for (std::size_t k = 0; k < at.p.size(); ++k) mean += at.p[k] * design(i, j, k);
        *gradient += design(i, j, static_cast<std::size_t>(mark)) - mean;
        if (information == nullptr) continue;
        for (std::size_t k = 0; k < at.p.size(); ++k) {
          const Eigen::VectorXd d = design(i, j, k) - mean;
          *information += at.p[k] * d * d.transpose();
        }
      }
    return logLikelihood;
  }

 private:
  [[nodiscard]] static double constrained(const Eigen::VectorXd& x, std::size_t from, std::size_t count,
                                          std::size_t which) {
    if (which + 1 < count) return x[static_cast<Index>(from + which)];
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < count; ++i) sum += x[static_cast<Index>(from + i)];
    return -sum;
  }

  static void add(Eigen::VectorXd& row, std::size_t from, std::size_t count, std::size_t which,
                  double weight) {
    if (which + 1 < count) {
      row[static_cast<Index>(from + which)] += weight;
      return;
    }
    for (std::size_t i = 0; i + 1 < count; ++i) row[static_cast<Index>(from + i)] -= weight;
  }

  [[nodiscard]] Eigen::VectorXd design(std::size_t i, std::size_t j, std::size_t category) const {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size());
    const double k = static_cast<double>(category);
    row[static_cast<Index>(i)] = k;
    add(row, persons_.size(), raters_.size(), j, -k);
    for (std::size_t step = 0; step < category; ++step)
      add(row, persons_.size() + raters_.size() - 1, thresholds_, step, -1.0);
    return row;
  }

  const Plan& plan_;
  std::size_t thresholds_;
  std::vector<std::size_t> persons_;
  std::vector<std::size_t> raters_;
};

/// Two marks of one person bound the severities of the two raters and the thresholds: see boundsOn().
struct Bound {
  std::size_t rater;
  int from;  ///< threshold that the mark of `rater` has passed
  std::size_t other;
  int to;  ///< threshold that the mark of `other` has not passed

  friend auto operator<=>(const Bound&, const Bound&) = default;
};

/// Every pair of marks of one person, the harshest bounds only.
std::set<Bound> tightestBounds(const Plan& plan, const JointModel& model) {
  std::map<std::tuple<std::size_t, std::size_t, int>, int> lowest;  // rater, other, from -> to
  for (const std::size_t n : model.persons()) {
    for (std::size_t j = 0; j < model.raters().size(); ++j) {
      for (std::size_t k = 0; k < model.raters().size(); ++k) {
        if (!plan.used(n, model.raters()[j]) || !plan.used(n, model.raters()[k])) {
          continue;
        }
        const int from = *plan.ratings_[n][model.raters()[j]];
        const int to = *plan.ratings_[n][model.raters()[k]] + 1;
        if (from >= 1 && to <= plan.highest_) {
          const auto [found, isNew] = lowest.emplace(std::tuple{j, k, from}, to);
          found->second = std::min(found->second, to);
        }
      }
    }
  }
  std::set<Bound> bounds;
  for (const auto& [key, to] : lowest) {
    const auto& [rater, other, from] = key;
    bounds.insert({rater, from, other, to});
  }
  return bounds;
}

/// Where the likelihood keeps rising for ever, if it does: severities, then thresholds, the first of each
/// held at 0. Every category is used and nobody is extreme.
///
/// The likelihood rises or stays level along a change of abilities a, severities b and thresholds t exactly
/// when no rating becomes less likely far out: t_m <= a_n - b_r <= t_(m+1) for every mark m of a rater r on a
/// person n (for m = 0 only the right, for the highest only the left side). Some a_n fits between the bounds
/// of person n exactly when b_r + t_m <= b_s + t_(l+1) for any two of the marks m and l, of raters r and s.
/// The maximum exists and is the only one when b = 0, t = 0 alone satisfies these.
std::optional<std::vector<double>> endlessRise(const Plan& plan, const JointModel& model) {
  const std::size_t raters = model.raters().size();
  std::vector<SparseRow> rows;
  for (const Bound& bound : tightestBounds(plan, model)) {
    std::map<std::size_t, int> row;
    const auto add = [&](std::size_t unknown, int coefficient) {
      if (unknown > 0) {
        row[unknown - 1] += coefficient;
      }
    };
    const auto threshold = [&](int which) {
      return which == 1 ? 0 : raters + static_cast<std::size_t>(which) - 2;
    };
    add(bound.rater, 1);
    add(bound.other, -1);
    add(threshold(bound.from), 1);
    add(threshold(bound.to), -1);
    std::erase_if(row, [](const auto& entry) { return entry.second == 0; });
    if (!row.empty()) {
      rows.emplace_back(row.begin(), row.end());
    }
  }
  return directionWithin(rows, raters + static_cast<std::size_t>(plan.highest_) - 2);
}

/// "rater 3 and the thresholds": the raters that leave the others behind, and whether thresholds part.
std::string endlessNames(const std::vector<double>& direction, const JointModel& model) {
  const std::size_t raters = model.raters().size();
  std::vector<double> severities{0.0};
  severities.insert(severities.end(), direction.begin(), direction.begin() + std::ssize(model.raters()) - 1);
  const auto alike = [&](double severity) {
    return std::count(severities.begin(), severities.end(), severity);
  };
  const double usual = *std::max_element(severities.begin(), severities.end(),
                                         [&](double a, double b) { return alike(a) < alike(b); });
  std::vector<std::string> names;
  for (std::size_t j = 0; j < raters; ++j) {
    if (severities[j] != usual) {
      names.push_back("rater " + std::to_string(model.raters()[j] + 1));
    }
  }
  if (std::any_of(direction.begin() + std::ssize(model.raters()) - 1, direction.end(),
                  [](double threshold) { return threshold != 0.0; })) {
    names.emplace_back("the thresholds");
  }
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return out;
}

/// Newton with step halving; the log-likelihood is concave and has one maximum. Empty when rounding keeps the
/// iteration from settling.
std::optional<int> maximise(const JointModel& model, Eigen::VectorXd& x) {
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;
  double value = model.evaluate(x, &gradient, &information);
  for (int iteration = 1; iteration <= kMaxIterations; ++iteration) {
    const Eigen::LDLT<Eigen::MatrixXd> solver(information);
    if (solver.info() != Eigen::Success) return std::nullopt;
    Eigen::VectorXd step = solver.solve(gradient);
    if (!step.allFinite()) return std::nullopt;
    double next = model.evaluate(x + step, nullptr, nullptr);
    for (int halving = 0; halving < 40 && !(next >= value - 1e-12 * std::abs(value)); ++halving) {
      step *= 0.5;
      next = model.evaluate(x + step, nullptr, nullptr);
    }
    x += step;
    value = model.evaluate(x, &gradient, &information);
    if (step.cwiseAbs().maxCoeff() < kConverged) return iteration;
  }
  return std::nullopt;
}

struct FitSums {
  double squares = 0.0;
  double variances = 0.0;
  double standardized = 0.0;
  double n = 0.0;
};

void report(const JointModel& model, const Plan& plan, const Eigen::VectorXd& x, RaschResult& out) {
  out.thresholds = model.tau(x);
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  out.logLikelihood = model.evaluate(x, &gradient, &information);
  const Eigen::MatrixXd covariance = information.inverse();
  std::vector<FitSums> raterSums(plan.raters.size());
  for (std::size_t i = 0; i < model.persons().size(); ++i) {
    FitSums sums;
    RaschPerson& person = out.persons[model.persons()[i]];
    for (std::size_t j = 0; j < model.raters().size(); ++j) {
      const std::size_t r = model.raters()[j];
      if (!plan.used(model.persons()[i], r)) continue;
      const Category at = categoryAt(model.ability(x, i) - model.severity(x, j), out.thresholds);
      const double d = static_cast<double>(*plan.ratings_[model.persons()[i]][r]) - at.mean;
      for (FitSums* to : {&sums, &raterSums[r]}) {
        to->squares += d * d;
        to->variances += at.variance;
        to->standardized += d * d / at.variance;
        to->n += 1.0;
      }
    }
    person.ability = model.ability(x, i);
    person.error = 1.0 / std::sqrt(sums.variances);
    person.jointError = std::sqrt(covariance(static_cast<Index>(i), static_cast<Index>(i)));
    person.fairAverage = categoryAt(*person.ability, out.thresholds).mean;
    person.infit = sums.squares / sums.variances;
    person.outfit = sums.standardized / sums.n;
  }
  for (std::size_t j = 0; j < model.raters().size(); ++j) {
    const FitSums& sums = raterSums[model.raters()[j]];
    RaschRater& rater = out.raters[model.raters()[j]];
    rater.severity = model.severity(x, j);
    rater.error = 1.0 / std::sqrt(sums.variances);
    rater.infit = sums.squares / sums.variances;
    rater.outfit = sums.standardized / sums.n;
  }
}

}  // namespace

Outcome<RaschResult> manyFacetRasch(const Ratings& ratings, int highest) {
  using Undefined = Outcome<RaschResult>;
  TORSIO_EXPECTS(highest >= 1);
  std::vector<bool> seen(static_cast<std::size_t>(highest) + 1, false);
  for (std::size_t n = 0; n < ratings.size(); ++n) {
    TORSIO_EXPECTS(ratings[n].size() == ratings.front().size());
    for (const std::optional<int>& mark : ratings[n])
      if (mark && (*mark < 0 || *mark > highest))
        throw Error(ErrorCode::kBadData, "a rating lies outside the categories", Text("person %1", n + 1),
                    Text("Give categories from 0 to %1.", highest));
  }
  const Plan plan(ratings, highest);
  for (std::size_t n = 0; n < plan.persons.size(); ++n)
    for (std::size_t r = 0; r < plan.raters.size(); ++r)
      if (plan.used(n, r)) seen[static_cast<std::size_t>(*ratings[n][r])] = true;
  if (!plan.connected())
    return Undefined::undefined("the rating plan falls into parts that share no person and no rater");
  const JointModel model(plan, highest);
  if (model.persons().size() < 2 || model.raters().size() < 2)
    return Undefined::undefined("fewer than two persons or raters have ratings that are not extreme");
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (!seen[k])
      return Undefined::undefined(
          filledIn("category %1 is never used: collapse categories first", {std::to_string(k)}));
  if (const auto direction = endlessRise(plan, model)) {
    return Undefined::undefined(
        filledIn("the likelihood has no finite maximum: nothing in the ratings bounds %1",
                 {endlessNames(*direction, model)}));
  }
  Eigen::VectorXd x = Eigen::VectorXd::Zero(model.size());
  const std::optional<int> iterations = maximise(model, x);
  if (!iterations) {
    return Undefined::undefined("the estimates lie too far apart to be computed");
  }
  RaschResult out;
  out.iterations = *iterations;
  for (const RaschStatus status : plan.persons) {
    out.persons.emplace_back();
    out.persons.back().status = status;
  }
  for (const RaschStatus status : plan.raters) {
    out.raters.emplace_back();
    out.raters.back().status = status;
  }
  report(model, plan, x, out);
  return out;
}

}  // namespace torsio
