// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/reporting/trial_digests.h"

#include <algorithm>

#include "app/session/trial_summary.h"
#include "assessment/metrics/trial_metrics.h"
#include "db/repository/study_repository.h"
#include "db/repository/trial_repository.h"
#include "sim/base/error.h"
#include "sim/record/sample_codec.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

constexpr std::int64_t kEveryTrial = 10'000'000;
constexpr std::size_t kProgressEvery = 16;

std::string modelName(const Trial& trial) {
  try {
    const std::optional<Formulation> formulation = sceneRequestFor(trial.header.parametersJson).formulation;
    return formulation == Formulation::kPaper ? "paper" : "Saint-Venant";
  } catch (const Error&) {
    return "not known";  // parameters of a later version: the recording counts all the same
  }
}

/// Positions of the groups of a cohort's enrolments.
std::map<std::string, std::size_t> groupOfEnrolment(StudyRepository& study, const std::string& cohortId) {
  const std::vector<StoredGroup> groups = study.groups(cohortId);
  std::map<std::string, std::size_t> out;
  for (const StoredEnrolment& enrolment : study.enrolments(cohortId)) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const StoredGroup& g) { return g.code == enrolment.groupCode; });
    if (group != groups.end()) out[enrolment.id] = static_cast<std::size_t>(group - groups.begin());
  }
  return out;
}

std::optional<StoredCurriculumVersion> curriculumOf(Connection& connection, const std::string& cohortId) {
  for (const StoredCohort& cohort : StudyRepository(connection).cohorts())
    if (cohort.id == cohortId && !cohort.curriculumVersionId.empty())
      return CurriculumRepository(connection).version(cohort.curriculumVersionId);
  return std::nullopt;
}

}  // namespace

double TrialDigests::tolerance_rad(const std::string& sceneId, const std::string& patternId,
                                   const std::string& moduleId,
                                   const std::optional<StoredCurriculumVersion>& curriculum) {
  if (curriculum && !moduleId.empty())
    for (const StoredModule& module : curriculum->modules)
      if (module.id == moduleId) return module.tolerance_rad;
  const auto [known, isNew] =
      patternTolerances_.try_emplace({sceneId, patternId}, TrialTargets{}.tolerance_rad);
  if (!isNew) return known->second;
  try {
    for (const PatternDescription& description : readSceneFile(assets_, sceneId).patterns)
      if (description.pattern.id == patternId) known->second = description.pattern.tolerance_rad;
  } catch (const Error&) {
    // A scene of another installation: the usual tolerance of two degrees counts.
  }
  return known->second;
}

std::vector<TrialDigest> TrialDigests::ofCohort(Workplace& workplace, const std::string& cohortId,
                                                const ProgressCallback& progress) {
  workplace.require(Operation::kResultsCompute);
  StudyRepository study(workplace.connection());
  TrialRepository trials(workplace.connection());
  const std::map<std::string, std::size_t> groups = groupOfEnrolment(study, cohortId);
  const std::optional<StoredCurriculumVersion> curriculum = curriculumOf(workplace.connection(), cohortId);
  TrialFilter filter;
  filter.limit = kEveryTrial;
  std::vector<TrialListing> listed = trials.list(filter);
  std::erase_if(listed, [&](const TrialListing& trial) {
    return !trial.summary || trial.summary->contentHash.empty() || !groups.contains(trial.enrolmentId);
  });
  std::reverse(listed.begin(), listed.end());
  std::vector<TrialDigest> out;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (progress && i % kProgressEvery == 0)
      progress({Text("Reading recording %1 of %2", i + 1, listed.size()),
                static_cast<double>(i) / static_cast<double>(listed.size()), -1.0});
    const TrialListing& listing = listed[i];
    auto known = known_.find(listing.summary->contentHash);
    if (known == known_.end()) {
      const Trial trial = trials.load(listing.trialId);
      TrialDigest digest =
          trialDigest(trial, decodeTrial(trial),
                      tolerance_rad(listing.sceneId, listing.patternId, listing.moduleId, curriculum));
      digest.model = modelName(trial);
      known = known_.emplace(listing.summary->contentHash, std::move(digest)).first;
    }
    out.push_back(known->second);
    out.back().group = groups.at(listing.enrolmentId);
    out.back().trainee = listing.traineeCode;
  }
  return out;
}

}  // namespace torsio
