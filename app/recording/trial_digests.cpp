// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/trial_digests.h"

#include <algorithm>
#include <map>

#include "app/recording/competence.h"
#include "app/recording/detorsion_rules.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/metrics/metric_cards.h"
#include "assessment/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/ids.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr std::int64_t kEveryTrial = 10'000'000;
constexpr std::size_t kProgressEvery = 16;
constexpr std::size_t kKeepEvery = 256;

/// Positions of the groups of a cohort's enrolments.
std::map<std::string, std::size_t> groupOfEnrolment(StudyRepository& study, const CohortId& cohortId) {
  const std::vector<StudyGroup> groups = study.groups(cohortId);
  std::map<std::string, std::size_t> out;
  for (const Enrolment& enrolment : study.enrolments(cohortId)) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const StudyGroup& g) { return g.code == enrolment.groupCode; });
    if (group != groups.end()) {
      out[enrolment.id] = static_cast<std::size_t>(group - groups.begin());
    }
  }
  return out;
}

/// The finished trials of those enrolments, oldest first.
std::vector<TrialListing> finishedTrials(TrialRepository& trials,
                                         const std::map<std::string, std::size_t>& groups) {
  TrialFilter filter;
  filter.limit = kEveryTrial;
  std::vector<TrialListing> listed = trials.list(filter);
  std::erase_if(listed, [&](const TrialListing& trial) {
    return !trial.summary || trial.summary->contentHash.empty() || !groups.contains(trial.enrolmentId);
  });
  std::reverse(listed.begin(), listed.end());
  return listed;
}

using Kept = std::map<std::string, std::vector<TrialDigest>>;

/// What was kept of the trials of a cohort by the present formulas, by trial.
Kept keptOf(Connection& connection, const CohortId& cohortId) {
  Kept kept;
  for (auto& [trialId, digest] : DigestRepository(connection).ofCohort(cohortId, kMetricsVersion)) {
    kept[trialId].push_back(std::move(digest));
  }
  return kept;
}

/// Digests that are new, stored some hundred at a time: little is lost when the work is given up.
class Fresh {
 public:
  explicit Fresh(Connection& connection) : connection_(connection) {}
  Fresh(const Fresh&) = delete;
  Fresh& operator=(const Fresh&) = delete;

  void add(TrialDigest digest) {
    waiting_.push_back(std::move(digest));
    if (waiting_.size() >= kKeepEvery) {
      keep();
    }
  }
  void keep() {
    if (!waiting_.empty() && !connection_.readOnly()) {
      DigestRepository(connection_).add(waiting_);
    }
    waiting_.clear();
  }

 private:
  Connection& connection_;
  std::vector<TrialDigest> waiting_;
};

}  // namespace

std::vector<TrialSummaryRow> TrialDigests::ofCohort(SessionContext& session, const CohortId& cohortId,
                                                    const ProgressCallback& progress) {
  session.require(Operation::kResultsCompute);
  Connection& connection = session.connection();
  StudyRepository study(connection);
  TrialRepository trials(connection);
  const std::map<std::string, std::size_t> groups = groupOfEnrolment(study, cohortId);
  const std::vector<TrialListing> listed = finishedTrials(trials, groups);
  Kept kept = keptOf(connection, cohortId);
  Fresh fresh(connection);
  std::vector<TrialSummaryRow> out;
  out.reserve(listed.size());
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const TrialListing& listing = listed[i];
    const AttemptRules rules = rules_.of(connection, listing.sceneId, listing.patternId, listing.moduleId);
    if (const TrialDigest* known = findDigest(kept[listing.trialId], listing.summary->contentHash, rules)) {
      out.push_back(summaryRow(listing, *known));
    } else {
      if (progress && measured_ % kProgressEvery == 0) {
        progress({Text::tr("Reading recording %1 of %2", i + 1, listed.size()),
                  static_cast<double>(i) / static_cast<double>(listed.size()), -1.0});
      }
      const Trial trial = trials.load(listing.trialId);
      const AttemptMeasures measures =
          measureAttempt(trial.header, decodeTrial(trial), recordedRules(rules, trial.header));
      TrialDigest digest = keptDigest(trial, measures, rules, session.now_us());
      ++measured_;
      out.push_back(summaryRow(listing, digest));
      fresh.add(std::move(digest));
    }
    out.back().group = groups.at(listing.enrolmentId);
  }
  fresh.keep();
  return out;
}

std::vector<CohortCompetence> TrialDigests::competenceOf(SessionContext& session,
                                                         const CurriculumVersionId& versionId,
                                                         const std::vector<CohortTrainee>& trainees) {
  session.require(Operation::kResultsCompute);
  return competenceOfCohort(session.connection(), versionId, trainees, rules_, session.now_us());
}

}  // namespace torsio
