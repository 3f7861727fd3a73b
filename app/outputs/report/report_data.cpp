// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/report/report_data.h"

#include <algorithm>
#include <map>

#include "app/services/access/centre_settings.h"
#include "app/services/scoring/cohort_inputs.h"
#include "app/services/scoring/scoring_service.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/frozen_data.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/results/number_format.h"
#include "assessment/scoring/demonstration_marks.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/signature_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/site_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/text.h"
#include "sim/scene/scene.h"

namespace torsio {

namespace {

void addFreeze(SessionContext& session, const ReportRequest& request, CohortInputs& inputs) {
  if (request.frozenId.empty()) {
    return;
  }
  for (const FrozenRow& row : frozenData(session, request.cohortId)) {
    if (row.id != request.frozenId) {
      continue;
    }
    CohortFreeze freeze{.name = row.name,
                        .contentHash = row.contentHash,
                        .frozenUtc_us = row.createdUtc_us,
                        .frozenBy = row.createdBy,
                        .sheetsAsked = row.sheets.asked,
                        .sheetsSubmitted = row.sheets.submitted,
                        .whyIncomplete = row.whyIncomplete,
                        .askedBy = row.askedBy};
    const FrozenCheck check = compareWithFrozen(session, row.id);
    freeze.unchanged = check.same;
    inputs.freeze = std::move(freeze);
    for (const Text& difference : check.differences) {
      inputs.provenance.emplace_back(Text::tr("Changed since the freeze"), difference);
    }
    return;
  }
  throw Error(ErrorCode::kBadParameter, Text::tr("there is no such frozen data set"), request.frozenId,
              Text::tr("Choose one of the list"));
}

/// Readers without the right to see marks get them, under codes, once the marks can no longer be influenced
/// (docs/decisions/0007).
bool showsSingleMarks(SessionContext& session, const ReportRequest& request, const CohortInputs& inputs) {
  if (session.may(Operation::kMarkViewCoded)) {
    return true;
  }
  return request.identity == ReportIdentity::kCoded && inputs.freeze && inputs.freeze->unchanged &&
         SheetRepository(session.connection()).openAssignments(request.cohortId) == 0;
}

/// Adds a description of the design, and whether the allocation could be replayed.
void addAllocation(SessionContext& session, const CohortId& cohortId, CohortInputs& inputs) {
  if (!session.may(Operation::kAllocationView)) {
    return;
  }
  const std::vector<AllocationDesignRow> designs = allocationDesigns(session, cohortId);
  if (designs.empty()) {
    return;
  }
  const AllocationDesignRow& last = designs.back();
  std::vector<Text> factors;
  for (const AllocationFactor& factor : last.design.factors) {
    factors.emplace_back(factor.name);
  }
  std::string blocks;
  for (const std::size_t size : last.design.blockSizes) {
    blocks += (blocks.empty() ? "" : ", ") + std::to_string(size);
  }
  inputs.allocation.design = {
      {Text::tr("Method"), Text(last.stored.algorithm)},
      {Text::tr("Strata or margins"), factors.empty() ? Text::tr("none") : listed(factors)},
      {Text::tr("Block sizes"), blocks.empty() ? Text::tr("none") : Text(blocks)},
      {Text::tr("Locked"), formatUtc(last.stored.lockedUtc_us)},
      {Text::tr("People allocated"), std::to_string(last.records)},
      {Text::tr("Moved by hand, with a reason"), std::to_string(last.overrides)},
      {Text::tr("Earlier designs"), std::to_string(designs.size() - 1)}};
  if (last.stored.seed.empty()) {
    return;
  }
  const AllocationCheck check = checkAllocation(session, last.stored.id);
  inputs.allocation.replayed = check.sound;
  inputs.allocation.replayDiffers = !check.sound;
  if (!check.sound) {
    inputs.allocation.design.emplace_back(Text::tr("Check of the draw"), check.finding);
  }
}

/// Replaces "T-07" by "T-07 Li Na" everywhere.
void nameTrainees(SessionContext& session, CohortInputs& inputs) {
  session.require(Operation::kPersonViewIdentity);
  PeopleRepository people(session.connection());
  std::map<std::string, std::string> nameOf;  // by person
  for (const Identity& identity : people.identities()) {
    nameOf[identity.personId] = identity.fullName;
  }
  std::map<std::string, std::string> shown;  // by code
  for (const Trainee& trainee : people.trainees()) {
    if (const auto name = nameOf.find(trainee.person.id); name != nameOf.end() && !name->second.empty()) {
      shown[trainee.person.code] = trainee.person.code + " " + name->second;
    }
  }
  const auto rename = [&](std::string& code) {
    if (const auto found = shown.find(code); found != shown.end()) {
      code = found->second;
    }
  };
  for (CohortTrainee& trainee : inputs.trainees) {
    rename(trainee.code);
  }
  for (TraineeScore& score : inputs.scores) {
    rename(score.trainee);
  }
  for (TrainingMark& mark : inputs.trainingMarks) {
    rename(mark.trainee);
  }
  for (CriterionMark& mark : inputs.criterionMarks) {
    rename(mark.trainee);
  }
  for (TrialSummaryRow& trial : inputs.trials) {
    rename(trial.trainee);
  }
  for (CohortCompetence& one : inputs.competence) {
    rename(one.trainee);
  }
  for (CohortDose& dose : inputs.doses) {
    rename(dose.trainee);
  }
  for (CohortDeviation& deviation : inputs.deviations) {
    rename(deviation.trainee);
  }
  for (const Rater& rater : people.raters()) {
    if (const auto name = nameOf.find(rater.person.id); name != nameOf.end() && !name->second.empty()) {
      shown[rater.person.code] = rater.person.code + " " + name->second;
    }
  }
  for (CohortSignature& signature : inputs.signatures) {
    rename(signature.trainee);
    rename(signature.signer);
  }
}

/// Adds warnings about the centre's own organs used in trials of the cohort, and what was confirmed at the
/// import of recordings of other equipment.
void addRecordedWarnings(Connection& connection, const CohortId& cohortId, CohortInputs& inputs) {
  const auto addOnce = [&inputs](const Phrase& title, const Text& value) {
    const std::pair<Text, Text> fact(title, value);
    if (std::find(inputs.provenance.begin(), inputs.provenance.end(), fact) == inputs.provenance.end()) {
      inputs.provenance.push_back(fact);
    }
  };
  for (const std::string& parameters : TrialRepository(connection).warnedParameters(cohortId)) {
    for (const OrganWarning& warning : recordedOrganWarnings(parameters)) {
      addOnce(Text::tr("Warning about the organ of a recording"), coded(warning));
    }
    for (const Text& confirmed : recordedConfirmations(parameters)) {
      addOnce(Text::tr("Confirmed at the import of recordings"), confirmed);
    }
  }
}

/// Adds whether double confirmation was required, and the signatures.
void addSafeguards(SessionContext& session, const FreezeId& frozenId, const TrainingResult& training,
                   CohortInputs& inputs) {
  Connection& connection = session.connection();
  const std::vector<std::pair<Text, Text>> settings = settingsInReport(connection);
  inputs.provenance.insert(inputs.provenance.end(), settings.begin(), settings.end());
  SignatureRepository signatures(connection);
  const std::map<std::string, Signature> signedMarks = signatures.all(SignedKind::kTrainingMark);
  const std::vector<SubmittedMark>& marks = training.submitted;
  const std::vector<Text> texts = occasionTexts(training.occasions);
  const auto textOf = [&](const std::string& code) -> Text {
    const std::optional<std::size_t> place = training.occasions.positionOf(code);
    return place ? texts.at(*place) : Text(code);
  };
  for (const SubmittedMark& mark : marks) {
    const auto found = signedMarks.find(mark.id);
    if (found == signedMarks.end()) {
      ++inputs.unsignedMarks;
      continue;
    }
    const Signature& one = found->second;
    inputs.signatures.push_back({.signer = mark.raterCode,
                                 .trainee = mark.traineeCode,
                                 .occasion = textOf(mark.occasionCode),
                                 .version = mark.version,
                                 .meaning = labelOf(one.meaning),
                                 .reason = one.reason,
                                 .signedUtc_us = one.signedUtc_us});
  }
  if (!marks.empty()) {
    inputs.provenance.emplace_back(Text::tr("Marks signed with a password"),
                                   Text::tr("%1 of %2", inputs.signatures.size(), marks.size()));
  }
  const std::map<std::string, Signature> frozen = signatures.all(SignedKind::kFrozenDataset);
  if (const auto found = frozen.find(frozenId); found != frozen.end()) {
    const Signature& one = found->second;
    inputs.provenance.emplace_back(
        Text::tr("Signature of the frozen data set"),
        Text::tr("%1, %2", Text(labelOf(one.meaning)), formatUtc(one.signedUtc_us)));
  }
}

}  // namespace

std::vector<ReportableCampaign> reportableCampaigns(SessionContext& session) {
  session.require(Operation::kResultsCompute);
  EvaluationRepository repository(session.connection());
  std::vector<ReportableCampaign> campaigns;
  for (const auto& [id, name] : repository.campaigns()) {
    campaigns.push_back({id, name, repository.hasMarks(id)});
  }
  return campaigns;
}

CohortInputs reportInputs(SessionContext& session, const ReportRequest& request, TrialDigests& digests,
                          const ProgressCallback& progress) {
  session.require(Operation::kResultsCompute);
  Connection& connection = session.connection();
  const Cohort cohort = StudyRepository(connection).cohort(request.cohortId);
  if (progress) {
    progress({Text::tr("Reading marks"), 0.0, -1.0});
  }
  CampaignResult campaign;
  if (!request.campaignId.empty()) {
    campaign = readCampaign(connection, request.campaignId);
  }
  const TrainingResult training = readTraining(connection, cohort.id);
  CohortInputs inputs = cohortInputs(connection, cohort.id, campaign, training);
  inputs.title = cohort.name;
  inputs.createdUtc_us = session.now_us();
  const TrailHead head = AuditRepository(connection).head();
  inputs.auditEntries = head.length;
  inputs.auditHead = head.hash;
  inputs.demonstration = cohort.demonstration || campaign.campaign.demonstration;
  inputs.identity = request.identity;
  if (!cohort.description.empty()) {
    inputs.facts.emplace_back(Text::tr("Cohort"), cohort.description);
  }
  if (!campaign.campaign.name.empty()) {
    inputs.facts.emplace_back(Text::tr("Evaluation of models"), campaign.campaign.name);
  }
  inputs.facts.emplace_back(Text::tr("Made"), formatUtc(inputs.createdUtc_us));
  if (inputs.demonstration) {
    inputs.simulated = {
        Text::tr(
            "The trainees' movements come from a scripted hand with a seed; the simulator, the recorder and "
            "every computation are the real ones."),
        demonstrationTrainingRule(), demonstrationEvaluationRule()};
  }
  for (const Site& site : SiteRepository(connection).sites()) {
    inputs.sites.push_back(site.code);
    for (CohortTrainee& trainee : inputs.trainees) {  // their codes are qualified: NJ/T-07
      if (trainee.code.starts_with(site.code + "/")) {
        trainee.site = site.code;
      }
    }
  }
  addAllocation(session, cohort.id, inputs);
  addFreeze(session, request, inputs);
  addRecordedWarnings(connection, cohort.id, inputs);
  addSafeguards(session, request.frozenId, training, inputs);
  inputs.singleMarks = showsSingleMarks(session, request, inputs);
  inputs.trials = digests.ofCohort(session, cohort.id, progress);
  inputs.competence = digests.competenceOf(session, cohort.curriculumVersionId, inputs.trainees);
  if (request.identity == ReportIdentity::kNamed) {
    nameTrainees(session, inputs);
  }
  return inputs;
}

}  // namespace torsio
