// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rating_plan.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "assessment/statistics/cone.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

std::vector<std::size_t> estimated(const std::vector<RaschStatus>& status) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < status.size(); ++i) {
    if (status[i] == RaschStatus::kEstimated) {
      out.push_back(i);
    }
  }
  return out;
}

/// Bound on two raters' severities and the thresholds from two marks of one person: see boundsOn().
struct Bound {
  std::size_t rater;
  int from;  ///< threshold that the mark of `rater` exceeds
  std::size_t other;
  int to;  ///< threshold that the mark of `other` does not exceed

  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 reads a pointer into <=>
  friend auto operator<=>(const Bound&, const Bound&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Bounds from every pair of marks of one person, keeping only the tightest.
std::set<Bound> tightestBounds(const RatingPlan& plan) {
  const std::vector<std::size_t> raters = plan.estimatedRaters();
  std::map<std::tuple<std::size_t, std::size_t, int>, int> lowest;  // rater, other, from -> to
  for (const std::size_t n : plan.estimatedPersons()) {
    for (std::size_t j = 0; j < raters.size(); ++j) {
      for (std::size_t k = 0; k < raters.size(); ++k) {
        if (!plan.used(n, raters[j]) || !plan.used(n, raters[k])) {
          continue;
        }
        const int from = plan.mark(n, raters[j]);
        const int to = plan.mark(n, raters[k]) + 1;
        if (from >= 1 && to <= plan.highest()) {
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

/// Returns a direction along which the likelihood rises for ever, if there is one: severities, then
/// thresholds, the first of each held at 0. Requires that every category is used and nobody is extreme.
///
/// The likelihood does not fall along a change of abilities a, severities b and thresholds t exactly if no
/// rating becomes less likely far out: t_m <= a_n - b_r <= t_(m+1) for every mark m of a rater r on a person
/// n (for m = 0 only the right, for the highest only the left side). Some a_n fits between the bounds of
/// person n exactly if b_r + t_m <= b_s + t_(l+1) for any two of the marks m and l, of raters r and s. The
/// maximum exists and is unique if only b = 0, t = 0 satisfies these.
std::optional<std::vector<double>> endlessRise(const RatingPlan& plan) {
  const std::size_t raters = plan.estimatedRaters().size();
  std::vector<SparseRow> rows;
  for (const Bound& bound : tightestBounds(plan)) {
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
  return directionWithin(rows, raters + static_cast<std::size_t>(plan.highest()) - 2);
}

/// Quick sufficient test that nothing can grow without bound, true in every plan of some size; if false, only
/// the system of endlessRise() decides.
///
/// A rater who gave somebody a higher mark than another rater did cannot have a larger severity than that
/// rater along such a change (thresholds are ordered, as every category is used). If this leads from each
/// rater to every other, all severities are equal, and then so are the thresholds between any two marks of
/// one person.
bool crossEachOther(const RatingPlan& plan) {
  const std::vector<std::size_t> raters = plan.estimatedRaters();
  std::vector<std::vector<bool>> above(raters.size(), std::vector<bool>(raters.size(), false));
  std::vector<bool> joined(static_cast<std::size_t>(plan.highest()),
                           false);  // threshold c with c + 1; from 1
  for (const std::size_t n : plan.estimatedPersons()) {
    int least = plan.highest();
    int most = 0;
    for (std::size_t j = 0; j < raters.size(); ++j) {
      if (!plan.used(n, raters[j])) {
        continue;
      }
      const int mark = plan.mark(n, raters[j]);
      least = std::min(least, mark);
      most = std::max(most, mark);
      for (std::size_t k = 0; k < raters.size(); ++k) {
        if (plan.used(n, raters[k]) && mark > plan.mark(n, raters[k])) {
          above[j][k] = true;
        }
      }
    }
    for (int c = least + 1; c < most; ++c) {
      joined[static_cast<std::size_t>(c)] = true;
    }
  }
  const auto reaches = [&](bool forwards) {
    std::vector<bool> met(raters.size(), false);
    std::vector<std::size_t> open{0};
    met[0] = true;
    while (!open.empty()) {
      const std::size_t j = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < raters.size(); ++k) {
        if (!met[k] && (forwards ? above[j][k] : above[k][j])) {
          met[k] = true;
          open.push_back(k);
        }
      }
    }
    return std::find(met.begin(), met.end(), false) == met.end();
  };
  return std::find(joined.begin() + 1, joined.end(), false) == joined.end() && reaches(true) &&
         reaches(false);
}

/// Returns the parameters that diverge in a direction.
UnboundedParameters divergingIn(const std::vector<double>& direction,
                                const std::vector<std::size_t>& raters) {
  std::vector<double> severities{0.0};
  severities.insert(severities.end(), direction.begin(), direction.begin() + std::ssize(raters) - 1);
  const auto alike = [&](double severity) {
    return std::count(severities.begin(), severities.end(), severity);
  };
  const double usual = *std::max_element(severities.begin(), severities.end(),
                                         [&](double a, double b) { return alike(a) < alike(b); });
  UnboundedParameters out;
  for (std::size_t j = 0; j < raters.size(); ++j) {
    if (severities[j] != usual) {
      out.raters.push_back(raters[j]);
    }
  }
  out.thresholds = std::any_of(direction.begin() + std::ssize(raters) - 1, direction.end(),
                               [](double threshold) { return threshold != 0.0; });
  return out;
}

}  // namespace

RatingPlan::RatingPlan(const CategoryRatings& ratings, int highest)
    : ratings_(ratings),
      highest_(highest),
      persons_(ratings.size(), RaschStatus::kEstimated),
      raters_(ratings.empty() ? 0 : ratings.front().size(), RaschStatus::kEstimated) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t n = 0; n < persons_.size(); ++n) {
      changed = judge(persons_[n], personRatings(n), true) || changed;
    }
    for (std::size_t r = 0; r < raters_.size(); ++r) {
      changed = judge(raters_[r], raterRatings(r), false) || changed;
    }
  }
}

std::vector<std::size_t> RatingPlan::estimatedPersons() const {
  return estimated(persons_);
}

std::vector<std::size_t> RatingPlan::estimatedRaters() const {
  return estimated(raters_);
}

bool RatingPlan::used(std::size_t person, std::size_t rater) const {
  return ratings_[person][rater] && persons_[person] == RaschStatus::kEstimated &&
         raters_[rater] == RaschStatus::kEstimated;
}

int RatingPlan::mark(std::size_t person, std::size_t rater) const {
  TORSIO_EXPECTS(ratings_[person][rater].has_value());
  return *ratings_[person][rater];
}

bool RatingPlan::connected() const {
  std::vector<std::size_t> root(persons_.size() + raters_.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) {
      i = root[i];
    }
    return i;
  };
  for (std::size_t n = 0; n < persons_.size(); ++n) {
    for (std::size_t r = 0; r < raters_.size(); ++r) {
      if (used(n, r)) {
        root[find(n)] = find(persons_.size() + r);
      }
    }
  }
  std::optional<std::size_t> part;
  for (std::size_t i = 0; i < root.size(); ++i) {
    const RaschStatus status = i < persons_.size() ? persons_[i] : raters_[i - persons_.size()];
    if (status != RaschStatus::kEstimated) {
      continue;
    }
    if (part && *part != find(i)) {
      return false;
    }
    part = find(i);
  }
  return true;
}

std::optional<UnboundedParameters> RatingPlan::unbounded() const {
  if (crossEachOther(*this)) {
    return std::nullopt;
  }
  const std::optional<std::vector<double>> direction = endlessRise(*this);
  return direction ? std::optional(divergingIn(*direction, estimatedRaters())) : std::nullopt;
}

std::vector<int> RatingPlan::personRatings(std::size_t n) const {
  std::vector<int> out;
  for (std::size_t r = 0; r < raters_.size(); ++r) {
    if (ratings_[n][r] && raters_[r] == RaschStatus::kEstimated) {
      out.push_back(*ratings_[n][r]);
    }
  }
  return out;
}
std::vector<int> RatingPlan::raterRatings(std::size_t r) const {
  std::vector<int> out;
  for (std::size_t n = 0; n < persons_.size(); ++n) {
    if (ratings_[n][r] && persons_[n] == RaschStatus::kEstimated) {
      out.push_back(*ratings_[n][r]);
    }
  }
  return out;
}
bool RatingPlan::judge(RaschStatus& status, const std::vector<int>& marks, bool person) const {
  if (status != RaschStatus::kEstimated) {
    return false;
  }
  if (marks.empty()) {
    status = RaschStatus::kNoRatings;
    return true;
  }
  const auto [low, high] = std::minmax_element(marks.begin(), marks.end());
  // A rater who gives only the lowest category is infinitely severe.
  if (*high == 0) {
    status = person ? RaschStatus::kExtremeLow : RaschStatus::kExtremeHigh;
  }
  if (*low == highest_) {
    status = person ? RaschStatus::kExtremeHigh : RaschStatus::kExtremeLow;
  }
  return status != RaschStatus::kEstimated;
}

}  // namespace torsio
