// SPDX-License-Identifier: GPL-3.0-or-later
// Protocol deviations of app/services/study/cohort_service.h.
#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "app/services/study/cohort_service.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

void checkDeviation(const NewDeviation& deviation) {
  const auto kind = fromStoredText<DeviationKind>(deviation.kind);
  if (!kind || *kind >= DeviationKind::kTrainedBeforeScoring) {
    refuse(Text::tr("this kind of deviation is not known"), deviation.kind,
           Text::tr("Choose one from the list"));
  }
  if (kind == DeviationKind::kOther && deviation.description.empty()) {
    refuse(Text::tr("\"other\" needs a description"), Text::tr("deviation"),
           Text::tr("Say in a few words what happened"));
  }
}

}  // namespace

DeviationId reportDeviation(SessionContext& session, const NewDeviation& deviation) {
  session.require(Operation::kStudySetup);
  checkDeviation(deviation);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort cohort = study.cohort(deviation.cohortId);
  const std::vector<Enrolment> enrolled = study.enrolments(cohort.id);
  if (!deviation.enrolmentId.empty() &&
      std::none_of(enrolled.begin(), enrolled.end(),
                   [&](const Enrolment& one) { return one.id == deviation.enrolmentId; })) {
    refuse(Text::tr("nobody is enrolled here under this number"), deviation.enrolmentId,
           Text::tr("Choose one from the list"));
  }
  const std::int64_t now_us = session.now_us();
  const DeviationId id = session.ids().newUuid();
  study.addDeviation({id, cohort.id, deviation.enrolmentId, deviation.kind, deviation.description,
                      deviation.happenedUtc_us == 0 ? now_us : deviation.happenedUtc_us,
                      session.actor().userId, now_us, cohort.demonstration});
  // The description is free text that may contain names, so it is not audited.
  session.note({.action = AuditAction::kDeviationReport,
                .objectKind = AuditObject::kDeviation,
                .objectId = id,
                .newJson =
                    nlohmann::json{
                        {"kind", deviation.kind}, {"cohort", cohort.id}, {"enrolment", deviation.enrolmentId}}
                        .dump()});
  transaction.commit();
  return id;
}

void reportDeviations(SessionContext& session, std::span<const NewDeviation> deviations) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  for (const NewDeviation& one : deviations) {
    static_cast<void>(reportDeviation(session, one));
  }
  transaction.commit();
}

void correctDeviations(SessionContext& session, const CohortId& cohortId,
                       std::span<const DeviationId> deviationIds, const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (reason.empty()) {
    refuse(Text::tr("a correction needs a reason"), Text::tr("deviation"), Text::tr("Say what was wrong"));
  }
  const std::set<DeviationId> wrong(deviationIds.begin(), deviationIds.end());
  std::vector<NewDeviation> corrections;
  for (const ProtocolDeviation& one : StudyRepository(session.connection()).deviations(cohortId)) {
    if (wrong.contains(one.id)) {
      corrections.push_back({.cohortId = cohortId,
                             .enrolmentId = one.enrolmentId,
                             .kind = std::string(storedText(DeviationKind::kOther)),
                             .description = "entered in error: \"" + one.kind +
                                            (one.description.empty() ? "" : ": " + one.description) +
                                            "\": " + reason,
                             .happenedUtc_us = one.happenedUtc_us});
    }
  }
  if (corrections.size() != wrong.size() || wrong.empty()) {
    refuse(Text::tr("this deviation is not of the cohort"), cohortId, Text::tr("Read the list again"));
  }
  reportDeviations(session, corrections);
}

std::vector<ProtocolDeviation> deviations(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kPersonViewCoded);
  return StudyRepository(session.connection()).deviations(cohortId);
}

}  // namespace torsio
