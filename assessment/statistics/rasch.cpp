// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rasch.h"

#include <algorithm>
#include <cmath>

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

/// Free parameters: abilities, then severities and thresholds without their last, which makes the sums 0.
class JointModel {
 public:
  explicit JointModel(const RatingPlan& plan)
      : plan_(plan),
        thresholds_(static_cast<std::size_t>(plan.highest())),
        persons_(plan.estimatedPersons()),
        raters_(plan.estimatedRaters()) {}

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

  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* gradient, Eigen::MatrixXd* information) const {
    const std::vector<double> thresholds = tau(x);
    double logLikelihood = 0.0;
    if (gradient != nullptr) {
      gradient->setZero(size());
    }
    if (information != nullptr) {
      information->setZero(size(), size());
    }
    for (std::size_t i = 0; i < persons_.size(); ++i) {
      for (std::size_t j = 0; j < raters_.size(); ++j) {
        if (!plan_.used(persons_[i], raters_[j])) {
          continue;
        }
        const int mark = plan_.mark(persons_[i], raters_[j]);
        const Category at = categoryAt(ability(x, i) - severity(x, j), thresholds);
        logLikelihood += std::log(at.p[static_cast<std::size_t>(mark)]);
        if (gradient == nullptr) {
          continue;
        }
        // Each category k has the log weight s_k . x with a design row s_k; gradient and information are the
        // mean and covariance of these rows.
        Eigen::VectorXd mean = Eigen::VectorXd::Zero(size());
        for (std::size_t k = 0; k < at.p.size(); ++k) {
          mean += at.p[k] * design(i, j, k);
        }
        *gradient += design(i, j, static_cast<std::size_t>(mark)) - mean;
        if (information == nullptr) {
          continue;
        }
        for (std::size_t k = 0; k < at.p.size(); ++k) {
          const Eigen::VectorXd d = design(i, j, k) - mean;
          *information += at.p[k] * d * d.transpose();
        }
      }
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

  static void add(Eigen::VectorXd& row, std::size_t from, std::size_t count, std::size_t which,
                  double weight) {
    if (which + 1 < count) {
      row[static_cast<Index>(from + which)] += weight;
      return;
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
      row[static_cast<Index>(from + i)] -= weight;
    }
  }

  [[nodiscard]] Eigen::VectorXd design(std::size_t i, std::size_t j, std::size_t category) const {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size());
    const double k = static_cast<double>(category);
    row[static_cast<Index>(i)] = k;
    add(row, persons_.size(), raters_.size(), j, -k);
    for (std::size_t step = 0; step < category; ++step) {
      add(row, persons_.size() + raters_.size() - 1, thresholds_, step, -1.0);
    }
    return row;
  }

  const RatingPlan& plan_;
  std::size_t thresholds_;
  std::vector<std::size_t> persons_;
  std::vector<std::size_t> raters_;
};

/// Newton with step halving; the log-likelihood is concave and has one maximum. Empty when rounding keeps the
/// iteration from settling.
std::optional<int> maximise(const JointModel& model, Eigen::VectorXd& x) {
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;
  double value = model.evaluate(x, &gradient, &information);
  for (int iteration = 1; iteration <= kMostRaschRounds; ++iteration) {
    const Eigen::LDLT<Eigen::MatrixXd> solver(information);
    if (solver.info() != Eigen::Success) {
      return std::nullopt;
    }
    Eigen::VectorXd step = solver.solve(gradient);
    if (!step.allFinite()) {
      return std::nullopt;
    }
    double next = model.evaluate(x + step, nullptr, nullptr);
    for (int halving = 0; halving < 40 && !(next >= value - 1e-12 * std::abs(value)); ++halving) {
      step *= 0.5;
      next = model.evaluate(x + step, nullptr, nullptr);
    }
    x += step;
    value = model.evaluate(x, &gradient, &information);
    if (step.cwiseAbs().maxCoeff() < kConverged) {
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
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  out.logLikelihood = model.evaluate(x, &gradient, &information);
  const Eigen::MatrixXd covariance = information.inverse();
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
