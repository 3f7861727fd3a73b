// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/mixed_anova.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

using Eigen::Index;

struct Cells {
  double n = 0.0;                          // trainees
  double m = 0.0;                          // occasions
  std::vector<double> sizes;               // of the groups
  std::vector<std::vector<double>> means;  // group x occasion
  std::vector<double> groupMeans;
  double ssGroup = 0.0;
  double ssSubjects = 0.0;
  double ssTimeWeighted = 0.0;
  double ssTimeUnweighted = 0.0;
  double ssInteraction = 0.0;
  double ssError = 0.0;
  Eigen::MatrixXd products;  // residual products within groups and trainees, occasion x occasion
  double noise = 0.0;        // sum of squares that rounding of the scores alone may cause
};

void addWithinGroup(const NumberTable& x, std::size_t g, Cells& out) {
  for (std::size_t i = 0; i < x.rows(); ++i) {
    const std::vector<double> row = x.row(i);
    const double subject = meanOf(row);
    const double shift = subject - out.groupMeans[g];
    out.ssSubjects += out.m * shift * shift;
    Eigen::VectorXd left(static_cast<Index>(row.size()));
    for (std::size_t t = 0; t < row.size(); ++t) {
      const double residual = row[t] - subject - out.means[g][t] + out.groupMeans[g];
      left[static_cast<Index>(t)] = residual;
      out.ssError += residual * residual;
    }
    out.products += left * left.transpose();
    out.noise += roundingSquares(row);
  }
}

Cells cellsOf(const std::vector<NumberTable>& groups) {
  Cells out;
  const std::size_t m = groups.front().columns();
  out.m = static_cast<double>(m);
  out.products = Eigen::MatrixXd::Zero(static_cast<Index>(m), static_cast<Index>(m));
  for (const NumberTable& x : groups) {
    TORSIO_EXPECTS(x.columns() == m);
    out.sizes.push_back(static_cast<double>(x.rows()));
    out.n += out.sizes.back();
    out.means.emplace_back();
    for (std::size_t t = 0; t < m; ++t) {
      out.means.back().push_back(meanOf(x.column(t)));
    }
    out.groupMeans.push_back(meanOf(out.means.back()));
  }
  const std::size_t k = groups.size();
  double grand = 0.0;
  double reciprocals = 0.0;
  for (std::size_t g = 0; g < k; ++g) {
    grand += out.sizes[g] / out.n * out.groupMeans[g];
    reciprocals += 1.0 / out.sizes[g];
  }
  const double plainGrand = meanOf(out.groupMeans);
  std::vector<double> timeMeans;
  for (std::size_t t = 0; t < m; ++t) {
    double weighted = 0.0;
    double plain = 0.0;
    for (std::size_t g = 0; g < k; ++g) {
      weighted += out.sizes[g] / out.n * out.means[g][t];
      plain += out.means[g][t] / static_cast<double>(k);
    }
    timeMeans.push_back(weighted);
    out.ssTimeWeighted += out.n * (weighted - grand) * (weighted - grand);
    out.ssTimeUnweighted +=
        static_cast<double>(k * k) / reciprocals * (plain - plainGrand) * (plain - plainGrand);
  }
  for (std::size_t g = 0; g < k; ++g) {
    out.ssGroup += out.m * out.sizes[g] * (out.groupMeans[g] - grand) * (out.groupMeans[g] - grand);
    for (std::size_t t = 0; t < m; ++t) {
      const double d = out.means[g][t] - out.groupMeans[g] - timeMeans[t] + grand;
      out.ssInteraction += out.sizes[g] * d * d;
    }
    addWithinGroup(groups[g], g, out);
  }
  return out;
}

Sphericity sphericityOf(const Cells& cells) {
  const double k = static_cast<double>(cells.sizes.size());
  const double dfe = cells.n - k;
  const double p = cells.m - 1.0;
  const Index m = cells.products.rows();
  const Eigen::MatrixXd s = cells.products / dfe;  // of contrasts: its rows sum to zero
  Sphericity out;
  out.greenhouseGeisser = s.trace() * s.trace() / (p * s.squaredNorm());
  const double pe = p * out.greenhouseGeisser;
  if (dfe > pe) {  // otherwise the estimates grow without bound, and 1 is used
    out.huynhFeldt = ((cells.n - k + 1.0) * pe - 2.0) / (p * (dfe - pe));
    out.huynhFeldtOriginal = (cells.n * pe - 2.0) / (p * (dfe - pe));
  }
  if (p < 2.0) {
    return out;
  }
  // The determinant over the contrasts is the product of the eigenvalues other than the zero of the centring.
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(s).eigenvalues();
  double logDeterminant = 0.0;
  for (Index i = 1; i < m; ++i) {
    logDeterminant += std::log(std::max(values[i], 1e-300));
  }
  const double logW = logDeterminant - p * std::log(s.trace() / p);
  out.mauchlyW = std::exp(logW);
  const double scale = dfe - (2.0 * p * p + p + 2.0) / (6.0 * p);
  out.mauchlyChiSquared = -scale * logW;
  out.mauchlyDf = 0.5 * p * (p + 1.0) - 1.0;
  // Anderson (2003), section 10.7.4: the second term of the expansion of the distribution.
  const double second = (p + 2.0) * (p - 1.0) * (p - 2.0) * (2.0 * p * p * p + 6.0 * p * p + 3.0 * p + 2.0) /
                        (288.0 * p * p * scale * scale);
  const double chiSquared = std::max(0.0, out.mauchlyChiSquared);
  const double first = chiSquaredUpper(chiSquared, out.mauchlyDf);
  out.mauchlyP =
      std::clamp(first + second * (chiSquaredUpper(chiSquared, out.mauchlyDf + 4.0) - first), 0.0, 1.0);
  return out;
}

AnovaEffect effect(double ss, double df, double ssError, double dfError, double otherError) {
  AnovaEffect out;
  out.ss = ss;
  out.df = df;
  out.ssError = ssError;
  out.dfError = dfError;
  out.f = ss / df / (ssError / dfError);
  out.p = fUpper(out.f, df, dfError);
  out.partialEtaSquared = ss / (ss + ssError);
  out.generalizedEtaSquared = ss / (ss + ssError + otherError);
  return out;
}

void correct(const Sphericity& sphericity, AnovaEffect& within) {
  const double gg = sphericity.greenhouseGeisser;
  const double hf = std::clamp(sphericity.huynhFeldt, gg, 1.0);
  within.pGreenhouseGeisser = fUpper(within.f, gg * within.df, gg * within.dfError);
  within.pHuynhFeldt = fUpper(within.f, hf * within.df, hf * within.dfError);
}

}  // namespace

Outcome<MixedAnova> mixedAnova(const std::vector<NumberTable>& given) {
  using Undefined = Outcome<MixedAnova>;
  std::vector<NumberTable> groups;
  for (const NumberTable& group : given) {
    if (const std::optional<Text> reason = beyondArithmetic(group.values())) {
      return Undefined::undefined(*reason);
    }
    if (group.rows() > 0) {
      groups.push_back(group);
    }
  }
  if (groups.empty()) {
    return Undefined::undefined(Text::tr("nobody has a score at every occasion"));
  }
  if (groups.front().columns() < 2) {
    return Undefined::undefined(Text::tr("there are fewer than two occasions"));
  }
  const Cells cells = cellsOf(groups);
  const double k = static_cast<double>(groups.size());
  const double dfSubjects = cells.n - k;
  if (dfSubjects < cells.m - 1.0) {
    return Undefined::undefined(Text::tr("there are too few trainees for the number of occasions"));
  }
  if (!(cells.ssError > cells.noise) || !(cells.ssSubjects > cells.noise)) {
    return Undefined::undefined(Text::tr("there is no residual variation"));
  }
  const double dfTime = cells.m - 1.0;
  const double dfError = dfSubjects * dfTime;
  MixedAnova out;
  out.sphericity = sphericityOf(cells);
  out.time = effect(cells.ssTimeUnweighted, dfTime, cells.ssError, dfError, cells.ssSubjects);
  out.timeTypeII = effect(cells.ssTimeWeighted, dfTime, cells.ssError, dfError, cells.ssSubjects);
  correct(out.sphericity, out.time);
  correct(out.sphericity, out.timeTypeII);
  if (groups.size() > 1) {
    out.group = effect(cells.ssGroup, k - 1.0, cells.ssSubjects, dfSubjects, cells.ssError);
    out.interaction =
        effect(cells.ssInteraction, (k - 1.0) * dfTime, cells.ssError, dfError, cells.ssSubjects);
    correct(out.sphericity, *out.interaction);
  }
  return out;
}

}  // namespace torsio
