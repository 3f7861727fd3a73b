// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rasch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Dense>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/rating_plan.h"
#include "assessment/statistics/rating_scale.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using Eigen::Index;

constexpr int kMaxRaschRounds = 200;
constexpr double kConverged = 1e-12;  // largest Newton step, logits

/// Fisher information in blocks: abilities, and a border of severities and thresholds. The block of abilities
/// is diagonal, so that thousands of persons stay cheap.
struct Information {
  Eigen::VectorXd persons;  // diagonal
  Eigen::MatrixXd across;   // persons x border
  Eigen::MatrixXd border;

  /// Information of the border after eliminating the persons.
  [[nodiscard]] Eigen::LDLT<Eigen::MatrixXd> reduced() const {
    return Eigen::LDLT<Eigen::MatrixXd>(border -
                                        across.transpose() * persons.cwiseInverse().asDiagonal() * across);
  }
};

/// First and second derivatives of the log-likelihood, accumulated mark by mark and person by person.
class Sums {
 public:
  Sums(Index persons, Index raters, Index thresholds)
      : slopes_(Eigen::VectorXd::Zero(persons)),
        diagonal_(Eigen::VectorXd::Zero(persons)),
        across_(Eigen::MatrixXd::Zero(raters + thresholds, persons)),
        border_(Eigen::VectorXd::Zero(raters + thresholds)),
        corner_(Eigen::VectorXd::Zero(raters)),
        side_(Eigen::MatrixXd::Zero(thresholds, raters)),
        above_(Eigen::MatrixXd::Zero(thresholds, raters)),
        joint_(Eigen::VectorXd::Zero(thresholds)),
        passed_(Eigen::VectorXd::Zero(thresholds)),
        products_(Eigen::MatrixXd::Zero(thresholds, thresholds)) {}

  void add(Index person, Index rater, int mark, const CategoryOdds& at) {
    const Index raters = corner_.size();
    const double rest = static_cast<double>(mark) - at.mean;
    slopes_[person] += rest;
    border_[rater] -= rest;
    diagonal_[person] += at.variance;
    corner_[rater] += at.variance;
    across_(rater, person) -= at.variance;
    auto above = above_.col(rater);  // probability of a category above each threshold
    double tail = 0.0;
    double joint = 0.0;  // its covariance with the category
    for (Index s = passed_.size(); s-- > 0;) {
      const double p = at.p[static_cast<std::size_t>(s) + 1];
      tail += p;
      joint += (static_cast<double>(s + 1) - at.mean) * p;
      above[s] = tail;
      joint_[s] = joint;
    }
    passed_ += above;
    border_.tail(passed_.size()) += above;
    border_.segment(raters, mark).array() -= 1.0;
    across_.col(person).tail(passed_.size()) -= joint_;
    side_.col(rater) += joint_;
  }

  void closePerson() {
    products_.selfadjointView<Eigen::Upper>().rankUpdate(above_);
    above_.setZero();
  }

  /// Transforms to the free parameters; call once.
  void finish(const Eigen::MatrixXd& free, Eigen::VectorXd& gradient, Information& information) {
    const Index r = corner_.size();
    const Index k = passed_.size();
    Eigen::MatrixXd square(r + k, r + k);
    square.topLeftCorner(r, r) = corner_.asDiagonal();
    square.bottomLeftCorner(k, r) = side_;
    for (Index s = 0; s < k; ++s) {
      for (Index u = s; u < k; ++u) {  // a category above the higher threshold is also above the lower one
        square(r + u, r + s) = passed_[u] - products_(s, u);
      }
    }
    square.triangularView<Eigen::StrictlyUpper>() = square.transpose();
    gradient.resize(slopes_.size() + free.cols());
    gradient << slopes_, free.transpose() * border_;
    information.persons = std::move(diagonal_);
    information.across = across_.transpose() * free;
    information.border = free.transpose() * square * free;
  }

 private:
  Eigen::VectorXd slopes_;
  Eigen::VectorXd diagonal_;
  Eigen::MatrixXd across_;  // border x persons
  Eigen::VectorXd border_;
  Eigen::VectorXd corner_;  // raters by themselves
  Eigen::MatrixXd side_;    // thresholds x raters
  Eigen::MatrixXd
      above_;  // probability of a category above each threshold, one column per mark of this person
  Eigen::VectorXd joint_;     // covariances of one mark
  Eigen::VectorXd passed_;    // their sum over the marks
  Eigen::MatrixXd products_;  // sum of their products
};

/// Free parameters: abilities, then severities and thresholds without the last of each (sum-to-zero
/// constraints).
class JointModel {
 public:
  explicit JointModel(const RatingPlan& plan)
      : plan_(plan),
        thresholds_(static_cast<std::size_t>(plan.highest())),
        persons_(plan.estimatedPersons()),
        raters_(plan.estimatedRaters()) {
    // The last severity and the last threshold are minus the sum of the others.
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

  /// Computes the log-likelihood; with `gradient`, also the gradient and the information.
  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* gradient, Information* information) const {
    const RatingScale scale(tau(x));
    Sums sums(static_cast<Index>(persons_.size()), static_cast<Index>(raters_.size()),
              static_cast<Index>(thresholds_));
    double logLikelihood = 0.0;
    CategoryOdds at;
    for (std::size_t i = 0; i < persons_.size(); ++i) {
      for (std::size_t j = 0; j < raters_.size(); ++j) {
        if (!plan_.used(persons_[i], raters_[j])) {
          continue;
        }
        const int mark = plan_.mark(persons_[i], raters_[j]);
        scale.at(ability(x, i) - severity(x, j), at);
        logLikelihood += std::log(at.p[static_cast<std::size_t>(mark)]);
        if (gradient != nullptr) {
          sums.add(static_cast<Index>(i), static_cast<Index>(j), mark, at);
        }
      }
      if (gradient != nullptr) {
        sums.closePerson();
      }
    }
    if (gradient != nullptr) {
      sums.finish(free_, *gradient, *information);
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

struct Maximum {
  Eigen::VectorXd x;
  Information information;
  double logLikelihood = 0.0;
  int iterations = 0;
};

/// Maximises by Newton with step halving; the log-likelihood is concave with one maximum. Empty if rounding
/// prevents convergence.
std::optional<Maximum> maximise(const JointModel& model) {
  Maximum at{Eigen::VectorXd::Zero(model.size()), {}, 0.0, 0};
  Eigen::VectorXd gradient;
  at.logLikelihood = model.evaluate(at.x, &gradient, &at.information);
  while (++at.iterations <= kMaxRaschRounds) {
    std::optional<Eigen::VectorXd> step = stepOf(at.information, gradient);
    if (!step) {
      return std::nullopt;
    }
    if (step->cwiseAbs().maxCoeff() < kConverged) {
      at.x += *step;  // changes neither likelihood nor information
      return at;
    }
    double next = model.evaluate(at.x + *step, &gradient, &at.information);
    bool halved = false;
    for (int halving = 0; halving < 40 && !(next >= at.logLikelihood - 1e-12 * std::abs(at.logLikelihood));
         ++halving) {
      *step *= 0.5;
      halved = true;
      next = model.evaluate(at.x + *step, nullptr, nullptr);
    }
    at.x += *step;
    at.logLikelihood = halved ? model.evaluate(at.x, &gradient, &at.information) : next;
  }
  return std::nullopt;
}

struct FitSums {
  double squares = 0.0;
  double variances = 0.0;
  double standardized = 0.0;
  double n = 0.0;
};

void report(const JointModel& model, const RatingPlan& plan, const Maximum& found, RaschResult& out) {
  const Eigen::VectorXd& x = found.x;
  const Information& information = found.information;
  out.thresholds = model.tau(x);
  out.logLikelihood = found.logLikelihood;
  out.iterations = found.iterations;
  const RatingScale scale(out.thresholds);
  CategoryOdds at;
  // Variance of an ability: its own, plus the contribution of the border.
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
      scale.at(model.ability(x, i) - model.severity(x, j), at);
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
    scale.at(*person.ability, at);
    person.fairAverage = at.mean;
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

/// Throws Error{kBadData} for a category outside the scale.
void requireCategories(const CategoryRatings& ratings, int highest) {
  for (std::size_t n = 0; n < ratings.size(); ++n) {
    TORSIO_EXPECTS(ratings[n].size() == ratings.front().size());
    for (const std::optional<int>& mark : ratings[n]) {
      if (mark && (*mark < 0 || *mark > highest)) {
        refuse(Text::verbatim("a rating is outside the categories"), Text::verbatim("person %1", n + 1),
               Text::verbatim("Give categories from 0 to %1.", highest));
      }
    }
  }
}

/// Names parameters: "rater 2, rater 3 and the thresholds". `codes`: as for manyFacetRasch.
Text namesOf(const UnboundedParameters& parameters, std::span<const std::string> codes) {
  std::vector<Text> names;
  for (const std::size_t rater : parameters.raters) {
    names.push_back(codes.empty() ? Text(Text::tr("rater %1", rater + 1)) : Text(codes[rater]));
  }
  if (parameters.thresholds) {
    names.emplace_back(Text::tr("the thresholds"));
  }
  if (names.size() < 2) {
    return listed(names);
  }
  const Text last = names.back();
  names.pop_back();
  return Text::tr("%1 and %2", listed(names), last);
}

/// Returns why the model cannot be estimated from these ratings; empty if it can.
std::optional<Text> obstacle(const RatingPlan& plan, std::span<const std::string> codes) {
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
  if (const std::optional<UnboundedParameters> loose = plan.unbounded()) {
    return Text::tr("the likelihood has no finite maximum: nothing in the ratings bounds %1",
                    namesOf(*loose, codes));
  }
  return std::nullopt;
}

}  // namespace

Outcome<RaschResult> manyFacetRasch(const CategoryRatings& ratings, int highest,
                                    std::span<const std::string> codes) {
  using Undefined = Outcome<RaschResult>;
  TORSIO_EXPECTS(highest >= 1);
  requireCategories(ratings, highest);
  TORSIO_EXPECTS(codes.empty() || ratings.empty() || codes.size() == ratings.front().size());
  const RatingPlan plan(ratings, highest);
  if (const std::optional<Text> reason = obstacle(plan, codes)) {
    return Undefined::undefined(*reason);
  }
  const JointModel model(plan);
  const std::optional<Maximum> found = maximise(model);
  if (!found) {
    return Undefined::undefined(Text::tr("the estimates lie too far apart to be computed"));
  }
  RaschResult out;
  for (const RaschStatus status : plan.persons()) {
    out.persons.emplace_back();
    out.persons.back().status = status;
  }
  for (const RaschStatus status : plan.raters()) {
    out.raters.emplace_back();
    out.raters.back().status = status;
  }
  report(model, plan, *found, out);
  return out;
}

namespace {

constexpr std::size_t kJackknifeGroups = 50;
constexpr std::size_t kJackknifeRatings = 5'000;
constexpr std::size_t kMinGroups = 3;

/// Returns the severities without the persons of one group, or none if the rest has no estimate for
/// everybody; categories that only they used are left out.
std::vector<double> severitiesWithout(const CategoryRatings& ratings, std::size_t group, std::size_t groups) {
  CategoryRatings kept;
  std::map<int, int> places;
  for (std::size_t i = 0; i < ratings.size(); ++i) {
    if (i % groups != group) {
      kept.push_back(ratings[i]);
      for (const std::optional<int>& rating : kept.back()) {
        if (rating) {
          places[*rating] = 0;
        }
      }
    }
  }
  int next = 0;
  for (auto& [category, place] : places) {
    place = next++;
  }
  for (auto& row : kept) {
    for (std::optional<int>& rating : row) {
      rating = rating ? std::optional(places.at(*rating)) : std::nullopt;
    }
  }
  std::vector<double> out;
  if (next < 2) {
    return out;
  }
  if (const Outcome<RaschResult> found = manyFacetRasch(kept, next - 1)) {
    for (const RaschRater& rater : found->raters) {
      if (!rater.severity) {
        return {};
      }
      out.push_back(*rater.severity);
    }
  }
  return out;
}

/// Returns the severities of each jackknife sample: samples x raters.
std::vector<std::vector<double>> jackknife(const CategoryRatings& ratings, std::size_t groups) {
  std::vector<std::vector<double>> out;
  for (std::size_t g = 0; g < groups; ++g) {
    if (std::vector<double> sample = severitiesWithout(ratings, g, groups); !sample.empty()) {
      out.push_back(std::move(sample));
    }
  }
  return out;
}

}  // namespace

std::vector<std::optional<CorrectedSeverity>> correctedSeverities(const CategoryRatings& ratings,
                                                                  const RaschResult& result,
                                                                  double confidence) {
  std::size_t given = 0;
  std::size_t persons = 0;
  for (std::size_t i = 0; i < ratings.size(); ++i) {
    if (result.persons[i].ability) {
      ++persons;
      given += static_cast<std::size_t>(std::count_if(ratings[i].begin(), ratings[i].end(),
                                                      [](const auto& rating) { return rating.has_value(); }));
    }
  }
  std::vector<std::optional<CorrectedSeverity>> out(result.raters.size());
  const double each = persons > 0 ? static_cast<double>(given) / static_cast<double>(persons) : 0.0;
  if (each <= 1.0) {
    return out;
  }
  const double factor = (each - 1.0) / each;
  const bool resampled = given <= kJackknifeRatings;
  const std::vector<std::vector<double>> samples =
      resampled ? jackknife(ratings, std::min(kJackknifeGroups, ratings.size()))
                : std::vector<std::vector<double>>{};
  if (resampled && samples.size() < kMinGroups) {
    return out;
  }
  const double n = static_cast<double>(samples.size());
  const double quantile =
      resampled ? tQuantile(0.5 * (1.0 + confidence), n - 1.0) : normalQuantile(0.5 * (1.0 + confidence));
  for (std::size_t r = 0; r < out.size(); ++r) {
    const RaschRater& rater = result.raters[r];
    if (!rater.severity || !rater.error) {
      continue;
    }
    CorrectedSeverity own{*rater.severity * factor, *rater.error * std::sqrt(factor), {}};
    if (resampled) {
      std::vector<double> of;
      for (const std::vector<double>& sample : samples) {
        of.push_back(factor * sample[r]);
      }
      own.error = std::sqrt((n - 1.0) / n * sumOfSquares(of));
    }
    own.interval = {own.severity - quantile * own.error, own.severity + quantile * own.error};
    out[r] = own;
  }
  return out;
}

}  // namespace torsio
