// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/report/report_names.h"

#include "app/services/study/frozen_data.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

CohortId cohortNamed(Connection& connection, const std::string& name) {
  for (const Cohort& cohort : StudyRepository(connection).cohorts()) {
    if (name.empty() || cohort.name == name) {
      return cohort.id;
    }
  }
  refuseParameter(Text::verbatim("the record has no such cohort"), Text(name),
                  Text::verbatim("Give the name of a cohort as the window shows it"));
}

CampaignId campaignNamed(Connection& connection, const std::string& name) {
  EvaluationRepository repository(connection);
  for (const auto& [id, known] : repository.campaigns()) {
    if (name.empty() ? repository.hasMarks(id) : known == name) {
      return id;
    }
  }
  if (name.empty()) {
    return {};
  }
  refuseParameter(Text::verbatim("the record has no such evaluation of models"), Text(name),
                  Text::verbatim("Give its name as the window shows it"));
}

namespace {

FreezeId frozenNamed(SessionContext& session, const CohortId& cohort, const std::string& name) {
  if (name.empty()) {
    return {};
  }
  for (const FrozenRow& row : frozenData(session, cohort)) {
    if (row.name == name) {
      return row.id;
    }
  }
  refuseParameter(Text::verbatim("the cohort has no such frozen data set"), Text(name),
                  Text::verbatim("Give its name as the window shows it"));
}

}  // namespace

ReportRequest reportNamed(SessionContext& session, const ReportNames& names) {
  session.require(Operation::kReportExportCoded);
  const CohortId cohort = cohortNamed(session.connection(), names.cohort);
  return {.cohortId = cohort,
          .campaignId = campaignNamed(session.connection(), names.campaign),
          .frozenId = frozenNamed(session, cohort, names.frozen)};
}

}  // namespace torsio
