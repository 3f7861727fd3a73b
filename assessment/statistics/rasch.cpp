// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rasch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "assessment/statistics/rating_plan.h"
#include "sim/base/error.h"
#include "sim/base/text.h"

namespace torsio {

namespace {

using Eigen::Index;

constexpr int kMostRaschRounds = 200;
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

/// What the ratings say about the parameters: abilities by themselves, and beside them the few severities and
/// thresholds. The square of the abilities is diagonal, so that thousands of persons stay cheap.
struct Information {
  Eigen::VectorXd persons;  // diagonal
  Eigen::MatrixXd across;   // persons x border
  Eigen::MatrixXd border;

  /// Information of the border alone, after the persons.
  [[nodiscard]] Eigen::LDLT<Eigen::MatrixXd> reduced() const {
    return Eigen::LDLT<Eigen::MatrixXd>(border -
                                        across.transpose() * persons.cwiseInverse().asDiagonal() * across);
  }
};

/// Free parameters: abilities, then severities and thresholds without their last, which makes the sums 0.
class JointModel {
 public:
  explicit JointModel(const RatingPlan& plan)
      : plan_(plan),
        thresholds_(static_cast<std::size_t>(plan.highest())),
        persons_(plan.estimatedPersons()),
        raters_(plan.estimatedRaters()) {
    // Severities and thresholds from the free ones: the last of either is minus the sum of the others.
    const auto r = static_cast<Index>(raters_.size());
    const auto k = static_cast<Index>(thresholds_);
    free_ = Eigen::MatrixXd::Zero(r + k, r + k - 2);
    free_.topLeftCorner(r - 1, r - 1).setIdentity();
    free_.block(r - 1, 0, 1, r - 1).setConstant(-1.0);
    free_.block(r, r - 1, k - 1, k - 1).setIdentity();
    free_.block(r + k - 1, r - 1, 1, k - 1).setConstant(-1.0);
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
    for (std::size_t k = 0; k < thresholds_; ++k) {
      out.push_back(constrained(x, persons_.size() + raters_.size() - 1, thresholds_, k));
    }
    return out;
  }

  /// Computes the log-likelihood; with `gradient` also that and the information.
  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* gradient, Information* information) const {
    const std::vector<double> thresholds = tau(x);
    const auto n = static_cast<Index>(persons_.size());
    const auto r = static_cast<Index>(raters_.size());
    const auto k = static_cast<Index>(thresholds_);
    double logLikelihood = 0.0;
    Eigen::VectorXd slopes = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd border = Eigen::VectorXd::Zero(r + k);
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd across = Eigen::MatrixXd::Zero(n, r + k);
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(r + k, r + k);
    Eigen::MatrixXd above(k, r);  // probability of a category above each threshold, a column a mark
    Eigen::VectorXd passed = Eigen::VectorXd::Zero(k);  // the sum of all of these
    Eigen::VectorXd joint(k);                           // their covariance with the category
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(k, k);
    for (Index i = 0; i < n; ++i) {
      above.setZero();
      for (Index j = 0; j < r; ++j) {
        const std::size_t person = persons_[static_cast<std::size_t>(i)];
        const std::size_t rater = raters_[static_cast<std::size_t>(j)];
        if (!plan_.used(person, rater)) {
          continue;
        }
        const int mark = plan_.mark(person, rater);
        const Category at = categoryAt(
            ability(x, static_cast<std::size_t>(i)) - severity(x, static_cast<std::size_t>(j)), thresholds);
        logLikelihood += std::log(at.p[static_cast<std::size_t>(mark)]);
        if (gradient == nullptr) {
          continue;
        }
        const double rest = static_cast<double>(mark) - at.mean;
        slopes[i] += rest;
        border[j] -= rest;
        double tail = 0.0;
        double weighted = 0.0;
        for (Index s = k; s-- > 0;) {
          const double p = at.p[static_cast<std::size_t>(s) + 1];
          tail += p;
          weighted += static_cast<double>(s + 1) * p;
          above(s, j) = tail;
          passed[s] += tail;
          joint[s] = weighted - at.mean * tail;
          border[r + s] -= (mark > s ? 1.0 : 0.0) - tail;
        }
        diagonal[i] += at.variance;
        across(i, j) -= at.variance;
        across.row(i).tail(k) -= joint.transpose();
        square(j, j) += at.variance;
        square.row(j).tail(k) += joint.transpose();
      }
      if (gradient != nullptr) {
        products.selfadjointView<Eigen::Upper>().rankUpdate(above);
      }
    }
    if (gradient != nullptr) {
      for (Index s = 0; s < k; ++s) {
        for (Index u = s; u < k; ++u) {  // a category above the higher threshold is above the lower one
          square(r + s, r + u) = passed[u] - products(s, u);
        }
      }
      square.triangularView<Eigen::StrictlyLower>() = square.transpose();
      gradient->resize(size());
      *gradient << slopes, free_.transpose() * border;
      information->persons = std::move(diagonal);
      information->across = across * free_;
      information->border = free_.transpose() * square * free_;
    }
    return logLikelihood;
  }

 private:
  [[nodiscard]] static double constrained(const Eigen::VectorXd& x, std::size_t from, std::size_t count,
                                          std::size_t which) {
    if (which + 1 < count) {
      return x[static_cast<Index>(from + which)];
    }
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < count; ++i) {
      sum += x[static_cast<Index>(from + i)];
    }
    return -sum;
  }

  const RatingPlan& plan_;
  std::size_t thresholds_;
  std::vector<std::size_t> persons_;
  std::vector<std::size_t> raters_;
  Eigen::MatrixXd free_;  // all severities and thresholds x the free ones
};

/// Newton's step.
std::optional<Eigen::VectorXd> stepOf(const Information& information, const Eigen::VectorXd& gradient) {
  const Eigen::LDLT<Eigen::MatrixXd> solver = information.reduced();
  if (solver.info() != Eigen::Success) {
    return std::nullopt;
  }
  const Index n = information.persons.size();
  const Eigen::VectorXd own = gradient.head(n).cwiseQuotient(information.persons);
  Eigen::VectorXd step(gradient.size());
  const Eigen::VectorXd border =
      solver.solve(gradient.tail(gradient.size() - n) - information.across.transpose() * own);
  step << own - (information.across * border).cwiseQuotient(information.persons), border;
  return step.allFinite() ? std::optional(step) : std::nullopt;
}

/// Newton with step halving; the log-likelihood is concave and has one maximum. Empty when rounding keeps the
/// iteration from settling.
std::optional<int> maximise(const JointModel& model, Eigen::VectorXd& x) {
  Eigen::VectorXd gradient;
  Information information;
  double value = model.evaluate(x, &gradient, &information);
  for (int iteration = 1; iteration <= kMostRaschRounds; ++iteration) {
    std::optional<Eigen::VectorXd> step = stepOf(information, gradient);
    if (!step) {
      return std::nullopt;
    }
    double next = model.evaluate(x + *step, &gradient, &information);
    bool halved = false;
    for (int halving = 0; halving < 40 && !(next >= value - 1e-12 * std::abs(value)); ++halving) {
      *step *= 0.5;
      halved = true;
      next = model.evaluate(x + *step, nullptr, nullptr);
    }
    x += *step;
    value = halved ? model.evaluate(x, &gradient, &information) : next;
    if (step->cwiseAbs().maxCoeff() < kConverged) {
      return iteration;
    }
  }
  return std::nullopt;
}

struct FitSums {
  double squares = 0.0;
  double variances = 0.0;
  double standardized = 0.0;
  double n = 0.0;
};

void report(const JointModel& model, const RatingPlan& plan, const Eigen::VectorXd& x, RaschResult& out) {
  out.thresholds = model.tau(x);
  Information information;
  Eigen::VectorXd gradient;
  out.logLikelihood = model.evaluate(x, &gradient, &information);
  // Variance of an ability: its own, and what the border adds.
  const Eigen::MatrixXd own = information.persons.cwiseInverse().asDiagonal() * information.across;
  const Eigen::VectorXd variance =
      information.persons.cwiseInverse() +
      own.cwiseProduct(information.reduced().solve(own.transpose()).transpose()).rowwise().sum();
  std::vector<FitSums> raterSums(plan.raters().size());
  for (std::size_t i = 0; i < model.persons().size(); ++i) {
    FitSums sums;
    RaschPerson& person = out.persons[model.persons()[i]];
    for (std::size_t j = 0; j < model.raters().size(); ++j) {
      const std::size_t r = model.raters()[j];
      if (!plan.used(model.persons()[i], r)) {
        continue;
      }
      const Category at = categoryAt(model.ability(x, i) - model.severity(x, j), out.thresholds);
      const double d = static_cast<double>(plan.mark(model.persons()[i], r)) - at.mean;
      for (FitSums* to : {&sums, &raterSums[r]}) {
        to->squares += d * d;
        to->variances += at.variance;
        to->standardized += d * d / at.variance;
        to->n += 1.0;
      }
    }
    person.ability = model.ability(x, i);
    person.error = 1.0 / std::sqrt(sums.variances);
    person.jointError = std::sqrt(variance[static_cast<Index>(i)]);
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

/// Throws Error{kBadData} for a category that the scale does not have.
void requireCategories(const CategoryRatings& ratings, int highest) {
  for (std::size_t n = 0; n < ratings.size(); ++n) {
    TORSIO_EXPECTS(ratings[n].size() == ratings.front().size());
    for (const std::optional<int>& mark : ratings[n]) {
      if (mark && (*mark < 0 || *mark > highest)) {
        throw Error(ErrorCode::kBadData, Text::verbatim("a rating lies outside the categories"),
                    Text::verbatim("person %1", n + 1),
                    Text::verbatim("Give categories from 0 to %1.", highest));
      }
    }
  }
}

/// Why the model has no estimate for these ratings; empty when it has one.
std::optional<Text> obstacle(const RatingPlan& plan) {
  if (!plan.connected()) {
    return Text::tr("the rating plan falls into parts that share no person and no rater");
  }
  const std::vector<std::size_t> persons = plan.estimatedPersons();
  const std::vector<std::size_t> raters = plan.estimatedRaters();
  if (persons.size() < 2 || raters.size() < 2) {
    return Text::tr("fewer than two persons or raters have ratings that are not extreme");
  }
  std::vector<bool> seen(static_cast<std::size_t>(plan.highest()) + 1, false);
  for (const std::size_t n : persons) {
    for (const std::size_t r : raters) {
      if (plan.used(n, r)) {
        seen[static_cast<std::size_t>(plan.mark(n, r))] = true;
      }
    }
  }
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (!seen[k]) {
      return Text::tr("category %1 is never used: collapse categories first", k);
    }
  }
  if (const std::optional<std::string> loose = plan.unbounded()) {
    return Text::tr("the likelihood has no finite maximum: nothing in the ratings bounds %1", *loose);
  }
  return std::nullopt;
}

}  // namespace

Outcome<RaschResult> manyFacetRasch(const CategoryRatings& ratings, int highest) {
  using Undefined = Outcome<RaschResult>;
  TORSIO_EXPECTS(highest >= 1);
  requireCategories(ratings, highest);
  const RatingPlan plan(ratings, highest);
  if (const std::optional<Text> reason = obstacle(plan)) {
    return Undefined::undefined(*reason);
  }
  const JointModel model(plan);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(model.size());
  const std::optional<int> iterations = maximise(model, x);
  if (!iterations) {
    return Undefined::undefined(Text::tr("the estimates lie too far apart to be computed"));
  }
  RaschResult out;
  out.iterations = *iterations;
  for (const RaschStatus status : plan.persons()) {
    out.persons.emplace_back();
    out.persons.back().status = status;
  }
  for (const RaschStatus status : plan.raters()) {
    out.raters.emplace_back();
    out.raters.back().status = status;
  }
  report(model, plan, x, out);
  return out;
}

}  // namespace torsio
