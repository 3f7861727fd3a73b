// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/generalizability.h"

#include <algorithm>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/reliability.h"

namespace torsio {

namespace {

double squaredAbout(const std::vector<double>& means, double grand) {
  double sum = 0.0;
  for (const double mean : means) {
    sum += (mean - grand) * (mean - grand);
  }
  return sum;
}

void finish(GStudy& study) {
  for (GComponent& component : study.components) {
    component.meanSquare = component.sumOfSquares / component.df;
  }
}

void setVariance(GStudy& study, const std::string& effect, double variance) {
  for (GComponent& component : study.components) {
    if (component.effect == effect) {
      component.variance = variance;
    }
  }
  study.negativeComponent = study.negativeComponent || variance < 0.0;
}

double positive(const GStudy& study, const std::string& effect) {
  return std::max(0.0, study.at(effect).variance);
}

Outcome<DStudy> coefficients(double persons, double relative, double absolute) {
  if (persons + relative <= 0.0) {
    return Outcome<DStudy>::undefined(Text::tr("neither persons nor errors vary"));
  }
  DStudy out;
  out.relativeError = relative;
  out.absoluteError = absolute;
  out.generalizability = persons / (persons + relative);
  out.dependability = persons / (persons + absolute);
  return out;
}

/// Means of a persons x raters x occasions block over every subset of facets.
struct CrossedMeans {
  std::vector<double> p, r, o;
  NumberTable pr, po, ro;
  double grand = 0.0;
};

CrossedMeans crossedMeans(const std::vector<NumberTable>& x) {
  const std::size_t np = x.front().rows();
  const std::size_t nr = x.front().columns();
  const std::size_t no = x.size();
  CrossedMeans m{std::vector<double>(np, 0.0),
                 std::vector<double>(nr, 0.0),
                 std::vector<double>(no, 0.0),
                 NumberTable(np, nr),
                 NumberTable(np, no),
                 NumberTable(nr, no),
                 0.0};
  const double dp = static_cast<double>(np);
  const double dr = static_cast<double>(nr);
  const double dO = static_cast<double>(no);
  for (std::size_t o = 0; o < no; ++o) {
    for (std::size_t p = 0; p < np; ++p) {
      for (std::size_t r = 0; r < nr; ++r) {
        const double value = x[o].at(p, r);
        m.p[p] += value / (dr * dO);
        m.r[r] += value / (dp * dO);
        m.o[o] += value / (dp * dr);
        m.pr.at(p, r) += value / dO;
        m.po.at(p, o) += value / dr;
        m.ro.at(r, o) += value / dp;
      }
    }
  }
  m.grand = meanOf(m.p);
  return m;
}

double interaction(const NumberTable& cells, const std::vector<double>& a, const std::vector<double>& b,
                   double grand) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double d = cells.at(i, j) - a[i] - b[j] + grand;
      sum += d * d;
    }
  }
  return sum;
}

bool sameShape(const std::vector<NumberTable>& tables) {
  return std::all_of(tables.begin(), tables.end(), [&](const NumberTable& table) {
    return table.rows() == tables.front().rows() && table.columns() == tables.front().columns();
  });
}

}  // namespace

const GComponent& GStudy::at(const std::string& effect) const {
  const auto found = std::find_if(components.begin(), components.end(),
                                  [&](const GComponent& component) { return component.effect == effect; });
  TORSIO_EXPECTS(found != components.end());
  return *found;
}

Outcome<GStudy> gStudyPR(const NumberTable& x) {
  return gStudyPRWithin({x});
}

Outcome<GStudy> gStudyPRWithin(const std::vector<NumberTable>& groups) {
  GStudy out;
  out.components = {{"p"}, {"r"}, {"pr"}};
  std::vector<std::vector<double>> rows;
  double strata = 0.0;
  double between = 0.0;  // squares of persons within their groups
  for (const NumberTable& x : groups) {
    if (const std::optional<Text> reason = beyondArithmetic(x.values())) {
      return Outcome<GStudy>::undefined(*reason);
    }
    if (x.rows() < 2 || x.columns() < 2) {
      continue;
    }
    std::vector<double> p;
    for (std::size_t i = 0; i < x.rows(); ++i) {
      rows.push_back(x.row(i));
      p.push_back(meanOf(rows.back()));
    }
    between += static_cast<double>(x.columns()) * squaredAbout(p, meanOf(p));
    strata += 1.0;
  }
  if (rows.empty()) {
    return Outcome<GStudy>::undefined(Text::tr("a study needs at least two persons and two raters"));
  }
  const NumberTable all(rows);
  const double np = static_cast<double>(all.rows());
  const double nr = static_cast<double>(all.columns());
  std::vector<double> p;
  std::vector<double> r;
  for (std::size_t i = 0; i < all.rows(); ++i) {
    p.push_back(meanOf(all.row(i)));
  }
  for (std::size_t j = 0; j < all.columns(); ++j) {
    r.push_back(meanOf(all.column(j)));
  }
  const double grand = meanOf(p);
  const double squares[] = {between, np * squaredAbout(r, grand), interaction(all, p, r, grand)};
  const double df[] = {np - strata, nr - 1.0, (np - 1.0) * (nr - 1.0)};
  for (std::size_t i = 0; i < out.components.size(); ++i) {
    out.components[i].sumOfSquares = squares[i];
    out.components[i].df = df[i];
  }
  finish(out);
  out.personsPerRater = np;
  const double e = out.at("pr").meanSquare;
  setVariance(out, "pr", e);
  setVariance(out, "p", (out.at("p").meanSquare - e) / nr);
  setVariance(out, "r", (out.at("r").meanSquare - e) / np);
  return out;
}

std::optional<Interval> dependabilityInterval(const GStudy& study, double raters, double confidence) {
  TORSIO_EXPECTS(raters >= 1.0 && study.personsPerRater > 0.0);
  const GComponent& p = study.at("p");
  const GComponent& r = study.at("r");
  const GComponent& error = study.at("pr");
  const auto single = agreementInterval({.raters = r.df + 1.0,
                                         .targetsPerRater = study.personsPerRater,
                                         .targets_ms = p.meanSquare,
                                         .targets_df = p.df,
                                         .raters_ms = r.meanSquare,
                                         .raters_df = r.df,
                                         .error_ms = error.meanSquare,
                                         .error_df = error.df},
                                        confidence);
  if (!single) {
    return std::nullopt;
  }
  return Interval{spearmanBrown(single->first.lower, raters), spearmanBrown(single->first.upper, raters)};
}

Outcome<DStudy> dStudyPR(const GStudy& study, double raters) {
  TORSIO_EXPECTS(raters >= 1.0);
  const double relative = positive(study, "pr") / raters;
  return coefficients(positive(study, "p"), relative, relative + positive(study, "r") / raters);
}

Outcome<GStudy> gStudyPRO(const std::vector<NumberTable>& byOccasion) {
  if (byOccasion.size() < 2 || byOccasion.front().rows() < 2 || byOccasion.front().columns() < 2) {
    return Outcome<GStudy>::undefined(
        Text::tr("a study needs at least two persons, two raters and two occasions"));
  }
  TORSIO_EXPECTS(sameShape(byOccasion));
  const CrossedMeans m = crossedMeans(byOccasion);
  const double np = static_cast<double>(m.p.size());
  const double nr = static_cast<double>(m.r.size());
  const double no = static_cast<double>(m.o.size());
  double residual = 0.0;
  for (std::size_t o = 0; o < m.o.size(); ++o) {
    for (std::size_t p = 0; p < m.p.size(); ++p) {
      for (std::size_t r = 0; r < m.r.size(); ++r) {
        const double d = byOccasion[o].at(p, r) - m.pr.at(p, r) - m.po.at(p, o) - m.ro.at(r, o) + m.p[p] +
                         m.r[r] + m.o[o] - m.grand;
        residual += d * d;
      }
    }
  }
  GStudy out;
  out.components = {{"p", nr * no * squaredAbout(m.p, m.grand), np - 1.0},
                    {"r", np * no * squaredAbout(m.r, m.grand), nr - 1.0},
                    {"o", np * nr * squaredAbout(m.o, m.grand), no - 1.0},
                    {"pr", no * interaction(m.pr, m.p, m.r, m.grand), (np - 1.0) * (nr - 1.0)},
                    {"po", nr * interaction(m.po, m.p, m.o, m.grand), (np - 1.0) * (no - 1.0)},
                    {"ro", np * interaction(m.ro, m.r, m.o, m.grand), (nr - 1.0) * (no - 1.0)},
                    {"pro", residual, (np - 1.0) * (nr - 1.0) * (no - 1.0)}};
  finish(out);
  const double e = out.at("pro").meanSquare;
  const double pr = out.at("pr").meanSquare;
  const double po = out.at("po").meanSquare;
  const double ro = out.at("ro").meanSquare;
  setVariance(out, "pro", e);
  setVariance(out, "pr", (pr - e) / no);
  setVariance(out, "po", (po - e) / nr);
  setVariance(out, "ro", (ro - e) / np);
  setVariance(out, "p", (out.at("p").meanSquare - pr - po + e) / (nr * no));
  setVariance(out, "r", (out.at("r").meanSquare - pr - ro + e) / (np * no));
  setVariance(out, "o", (out.at("o").meanSquare - po - ro + e) / (np * nr));
  return out;
}

Outcome<DStudy> dStudyPRO(const GStudy& study, double raters, double occasions) {
  TORSIO_EXPECTS(raters >= 1.0 && occasions >= 1.0);
  const double relative = positive(study, "pr") / raters + positive(study, "po") / occasions +
                          positive(study, "pro") / (raters * occasions);
  const double absolute = relative + positive(study, "r") / raters + positive(study, "o") / occasions +
                          positive(study, "ro") / (raters * occasions);
  return coefficients(positive(study, "p"), relative, absolute);
}

Outcome<GStudy> gStudyPRinT(const std::vector<NumberTable>& byTask) {
  if (byTask.size() < 2 || byTask.front().rows() < 2 || byTask.front().columns() < 2) {
    return Outcome<GStudy>::undefined(
        Text::tr("a study needs at least two persons, two tasks and two raters a task"));
  }
  TORSIO_EXPECTS(sameShape(byTask));
  const std::size_t persons = byTask.front().rows();
  const std::size_t raters = byTask.front().columns();
  const double np = static_cast<double>(persons);
  const double nt = static_cast<double>(byTask.size());
  const double nr = static_cast<double>(raters);
  std::vector<double> p(persons, 0.0);
  std::vector<double> t;
  NumberTable pt(persons, byTask.size());
  double raterSquares = 0.0;
  double residual = 0.0;
  for (std::size_t task = 0; task < byTask.size(); ++task) {
    const NumberTable& x = byTask[task];
    std::vector<double> personMeans;
    std::vector<double> raterMeans;
    for (std::size_t i = 0; i < persons; ++i) {
      personMeans.push_back(meanOf(x.row(i)));
      pt.at(i, task) = personMeans.back();
      p[i] += personMeans.back() / nt;
    }
    for (std::size_t j = 0; j < raters; ++j) {
      raterMeans.push_back(meanOf(x.column(j)));
    }
    const double taskMean = meanOf(personMeans);
    t.push_back(taskMean);
    raterSquares += np * squaredAbout(raterMeans, taskMean);
    residual += interaction(x, personMeans, raterMeans, taskMean);
  }
  const double grand = meanOf(t);
  GStudy out;
  out.components = {{"p", nt * nr * squaredAbout(p, grand), np - 1.0},
                    {"t", np * nr * squaredAbout(t, grand), nt - 1.0},
                    {"r:t", raterSquares, nt * (nr - 1.0)},
                    {"pt", nr * interaction(pt, p, t, grand), (np - 1.0) * (nt - 1.0)},
                    {"pr:t", residual, (np - 1.0) * nt * (nr - 1.0)}};
  finish(out);
  const double e = out.at("pr:t").meanSquare;
  const double rt = out.at("r:t").meanSquare;
  const double pTask = out.at("pt").meanSquare;
  setVariance(out, "pr:t", e);
  setVariance(out, "pt", (pTask - e) / nr);
  setVariance(out, "r:t", (rt - e) / np);
  setVariance(out, "t", (out.at("t").meanSquare - pTask - rt + e) / (np * nr));
  setVariance(out, "p", (out.at("p").meanSquare - pTask) / (nt * nr));
  return out;
}

Outcome<DStudy> dStudyPRinT(const GStudy& study, double tasks, double ratersPerTask) {
  TORSIO_EXPECTS(tasks >= 1.0 && ratersPerTask >= 1.0);
  const double relative = positive(study, "pt") / tasks + positive(study, "pr:t") / (tasks * ratersPerTask);
  const double absolute =
      relative + positive(study, "t") / tasks + positive(study, "r:t") / (tasks * ratersPerTask);
  return coefficients(positive(study, "p"), relative, absolute);
}

}  // namespace torsio
