// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/kept_digests.h"

#include "app/recording/trial_summary.h"
#include "assessment/metrics/trial_metrics.h"
#include "db/repository/study/study_repository.h"
#include "sim/base/error.h"
#include "sim/scene/scene_file.h"

namespace torsio {

double DigestTolerances::of(const std::string& sceneId, const std::string& patternId,
                            const std::string& moduleId,
                            const std::optional<StoredCurriculumVersion>& curriculum) {
  if (curriculum && !moduleId.empty())
    for (const StoredModule& module : curriculum->modules)
      if (module.id == moduleId) return module.tolerance_rad;
  const auto [known, isNew] = patterns_.try_emplace({sceneId, patternId}, TrialTargets{}.tolerance_rad);
  if (!isNew) return known->second;
  try {
    for (const PatternDescription& description : readSceneFile(assets_, sceneId).patterns)
      if (description.pattern.id == patternId) known->second = description.pattern.tolerance_rad;
  } catch (const Error&) {
    // A scene of another installation: the usual tolerance of two degrees counts.
  }
  return known->second;
}

std::optional<StoredCurriculumVersion> curriculumOfCohort(Connection& connection,
                                                          const std::string& cohortId) {
  for (const StoredCohort& cohort : StudyRepository(connection).cohorts())
    if (cohort.id == cohortId && !cohort.curriculumVersionId.empty())
      return CurriculumRepository(connection).version(cohort.curriculumVersionId);
  return std::nullopt;
}

std::string modelName(const std::string& parametersJson) {
  try {
    const std::optional<Formulation> formulation = sceneRequestFor(parametersJson).formulation;
    return formulation == Formulation::kPaper ? "paper" : "Saint-Venant";
  } catch (const Error&) {
    return "not known";  // parameters of a later version: the recording counts all the same
  }
}

StoredTrialDigest keptDigest(const TrialDigest& digest, double tolerance_rad, std::int64_t now_us) {
  StoredTrialDigest kept{.trialId = digest.trialId,
                         .formulaVersion = kTrialDigestVersion,
                         .tolerance_rad = tolerance_rad,
                         .contentHash = digest.contentHash,
                         .model = digest.model,
                         .minutes = digest.minutes,
                         .meanAbsoluteError_deg = digest.meanAbsoluteError_deg,
                         .peakTorque_Nm = digest.peakTorque_Nm,
                         .peakForce_N = digest.peakForce_N,
                         .computedUtc_us = now_us};
  kept.attempts.reserve(digest.attempts.size());
  for (const TwistAttempt& attempt : digest.attempts)
    kept.attempts.emplace_back(attempt.error_deg, attempt.onTarget);
  return kept;
}

TrialDigest digestFrom(const StoredTrialDigest& kept, const TrialListing& listing) {
  const TrialSummary& summary = listing.summary.value();
  TrialDigest digest;
  digest.trialId = listing.trialId;
  digest.trainee = listing.traineeCode;
  digest.phase = listing.phaseLabel;
  digest.model = kept.model;
  digest.minutes = kept.minutes;
  digest.samples = summary.samples;
  digest.refusedSamples = summary.refusedSamples;
  digest.lateTicks = summary.lateTicks;
  digest.interrupted = summary.outcome == TrialOutcome::kInterrupted;
  digest.contentHash = summary.contentHash;
  digest.meanAbsoluteError_deg = kept.meanAbsoluteError_deg;
  digest.peakTorque_Nm = kept.peakTorque_Nm;
  digest.peakForce_N = kept.peakForce_N;
  digest.attempts.reserve(kept.attempts.size());
  for (const auto& [error_deg, onTarget] : kept.attempts) {
    digest.attempts.push_back({error_deg, onTarget});
    digest.twistsOnTarget += onTarget ? 1 : 0;
  }
  digest.twists = static_cast<std::int64_t>(digest.attempts.size());
  return digest;
}

void keepDigestOf(Connection& connection, const Trial& trial, std::span<const Sample> samples,
                  const TrialContext& context, DigestTolerances& tolerances, std::int64_t now_us) {
  if (connection.readOnly() || context.enrolmentId.empty() || trial.summary.contentHash.empty()) return;
  DigestRepository digests(connection);
  const double tolerance_rad =
      tolerances.of(trial.header.sceneId, trial.header.patternId, context.moduleId,
                    curriculumOfCohort(connection, digests.cohortOf(context.enrolmentId)));
  TrialDigest digest = trialDigest(trial, samples, tolerance_rad);
  digest.model = modelName(trial.header.parametersJson);
  const StoredTrialDigest kept = keptDigest(digest, tolerance_rad, now_us);
  digests.add({&kept, 1});
}

}  // namespace torsio
