// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/run_dependence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace torsio {

namespace {

constexpr double kMaxCorrelation = 0.9;

/// One attempt of a person.
struct Placed {
  bool failed = false;
  std::size_t session = 0;
};

/// Pairs of attempts of one kind, over all people.
struct Pairs {
  double excess = 0.0;  ///< of pairs that both failed, above what pairs of different sessions give
  double spread = 0.0;  ///< variance that each pair would have
  void add(const Pairs& others) {
    excess += others.excess;
    spread += others.spread;
  }
  [[nodiscard]] double correlation() const { return spread > 0.0 ? excess / spread : 0.0; }
};

/// How many pairs of a person there are, and how many both failed.
struct Count {
  double pairs = 0.0;
  double both = 0.0;
  double differ = 0.0;
  void add(const Placed& a, const Placed& b) {
    pairs += 1.0;
    both += a.failed && b.failed ? 1.0 : 0.0;
    differ += a.failed != b.failed ? 1.0 : 0.0;
  }
};

struct Totals {
  Pairs successive;  ///< of one session; those of two sessions if there are none
  Pairs between;     ///< successive, of two sessions
  Pairs apart;       ///< of one session, not successive
  double apartPairs = 0.0;
  std::vector<double> apartBy{};  ///< pairs of `apart` by distance
  void add(const Totals& others) {
    successive.add(others.successive);
    between.add(others.between);
    apart.add(others.apart);
    apartPairs += others.apartPairs;
    apartBy.resize(std::max(apartBy.size(), others.apartBy.size()));
    for (std::size_t k = 0; k < others.apartBy.size(); ++k) {
      apartBy[k] += others.apartBy[k];
    }
  }
};

std::vector<Placed> placed(const SessionOutcomes& sessions) {
  std::vector<Placed> all;
  for (std::size_t session = 0; session < sessions.size(); ++session) {
    for (const bool failed : sessions[session]) {
      all.push_back({failed, session});
    }
  }
  return all;
}

void addPerson(const SessionOutcomes& sessions, Totals& totals) {
  const std::vector<Placed> all = placed(sessions);
  Count different;
  Count successive;
  Count between;
  Count apart;
  std::vector<double> distances(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const bool same = all[i].session == all[j].session;
      Count& count = j == i + 1 ? (same ? successive : between) : (same ? apart : different);
      count.add(all[i], all[j]);
      distances[j - i] += same && j > i + 1 ? 1.0 : 0.0;
    }
  }
  if (different.pairs == 0.0) {
    return;  // one session tells nothing about sessions
  }
  const double square = different.both / different.pairs;          // of the person's failure rate
  const double spread = 0.5 * different.differ / different.pairs;  // rate times 1 - rate
  const auto add = [&](const Count& count, Pairs& pairs) {
    pairs.excess += count.both - count.pairs * square;
    pairs.spread += count.pairs * spread;
  };
  add(successive, totals.successive);
  add(between, totals.between);
  add(apart, totals.apart);
  totals.apartBy.resize(std::max(totals.apartBy.size(), distances.size()));
  for (std::size_t k = 0; k < distances.size(); ++k) {
    totals.apartBy[k] += distances[k];
    totals.apartPairs += distances[k];
  }
}

double bounded(double correlation) {
  return std::clamp(correlation, 0.0, kMaxCorrelation);
}

/// Solves for both correlations: that of attempts at distance k of a session is session + (1 - session)
/// lag^k.
AttemptDependence solved(const Totals& totals, std::int64_t perSession) {
  AttemptDependence out{.perSession = perSession};
  if (totals.apartPairs == 0.0) {
    out.lag = bounded((totals.successive.spread > 0.0 ? totals.successive : totals.between).correlation());
    return out;
  }
  constexpr int kRounds = 200;
  for (int round = 0; round < kRounds; ++round) {
    out.lag = bounded((totals.successive.correlation() - out.session) / (1.0 - out.session));
    double carried = 0.0;  // mean of lag^k
    for (std::size_t k = 2; k < totals.apartBy.size(); ++k) {
      carried += totals.apartBy[k] / totals.apartPairs * std::pow(out.lag, static_cast<double>(k));
    }
    const double session = bounded((totals.apart.correlation() - carried) / (1.0 - carried));
    out.session += 0.5 * (session - out.session);
  }
  return out;
}

/// Raises both correlations to their upper bounds of 95 %: errors of the jackknife, whole people left out in
/// up to kBlocks blocks.
void addMargin(std::span<const SessionOutcomes> people, AttemptDependence& dependence) {
  constexpr std::size_t kBlocks = 50;
  constexpr double kOneSided = 1.645;
  const std::size_t blocks = std::min(people.size(), kBlocks);
  std::vector<Totals> ofBlock(blocks);
  for (std::size_t i = 0; i < people.size(); ++i) {
    addPerson(people[i], ofBlock[i % blocks]);
  }
  std::vector<AttemptDependence> without;
  for (std::size_t left = 0; left < blocks; ++left) {
    Totals totals;
    for (std::size_t block = 0; block < blocks; ++block) {
      if (block != left) {
        totals.add(ofBlock[block]);
      }
    }
    without.push_back(solved(totals, dependence.perSession));
  }
  const auto raised = [&](double AttemptDependence::*correlation) {
    double mean = 0.0;
    for (const AttemptDependence& one : without) {
      mean += one.*correlation / static_cast<double>(blocks);
    }
    double squares = 0.0;
    for (const AttemptDependence& one : without) {
      squares += (one.*correlation - mean) * (one.*correlation - mean);
    }
    const double error = std::sqrt(squares * static_cast<double>(blocks - 1) / static_cast<double>(blocks));
    return bounded(dependence.*correlation + kOneSided * error);
  };
  const double session = raised(&AttemptDependence::session);
  dependence.lag = raised(&AttemptDependence::lag);
  dependence.session = session;
}

std::int64_t runsOfSession(std::span<const SessionOutcomes> people) {
  std::int64_t runs = 0;
  std::int64_t squares = 0;
  for (const SessionOutcomes& person : people) {
    for (const std::vector<bool>& session : person) {
      runs += std::ssize(session);
      squares += std::ssize(session) * std::ssize(session);
    }
  }
  return runs == 0 ? 0 : (squares + runs - 1) / runs;
}

}  // namespace

EstimatedDependence estimateDependence(std::span<const SessionOutcomes> people) {
  EstimatedDependence out{
      .dependence = {}, .attempts = 0, .people = 0, .runsOfSession = runsOfSession(people)};
  Totals totals;
  for (const SessionOutcomes& person : people) {
    std::int64_t own = 0;
    for (const std::vector<bool>& session : person) {
      own += std::ssize(session);
    }
    out.attempts += own;
    out.people += own > 0 ? 1 : 0;
    addPerson(person, totals);
  }
  if (out.attempts >= kMinDependenceAttempts && out.people >= kMinDependencePeople &&
      totals.successive.spread + totals.between.spread > 0.0) {
    out.dependence = solved(totals, out.runsOfSession);
    addMargin(people, *out.dependence);
  }
  return out;
}

}  // namespace torsio
