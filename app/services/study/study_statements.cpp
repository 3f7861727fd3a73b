// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/study_statements.h"

#include <string>

#include <nlohmann/json.hpp>

#include "db/connection/connection.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

std::string statementIn(const StudyStatements& statements, StudyItem item) {
  const auto found = statements.find(item);
  return found == statements.end() ? std::string() : found->second;
}

}  // namespace

StudyStatements studyStatements(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kPersonViewCoded);
  StudyRepository study(session.connection());
  return study.statements(study.cohort(cohortId).id);
}

void setStudyStatements(SessionContext& session, const CohortId& cohortId,
                        const StudyStatements& statements) {
  session.require(Operation::kStudySetup);
  for (const auto& [item, statement] : statements) {
    if (statement.size() > kLongestStatement) {
      refuseParameter(Text::tr("this statement is too long"), Text(labelOf(item)),
                      Text::tr("Shorten it, and refer to the protocol"));
    }
  }
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort cohort = study.cohort(cohortId);
  const StudyStatements before = study.statements(cohort.id);
  for (const Term<StudyItem>& term : kStudyItems) {
    const std::string was = statementIn(before, term.value);
    const std::string is = statementIn(statements, term.value);
    if (was == is) {
      continue;
    }
    study.addStatement({.cohortId = cohort.id,
                        .item = term.value,
                        .statement = is,
                        .statedBy = session.actor().userId,
                        .statedUtc_us = session.now_us()});
    const std::string name(term.stored);
    session.noteChange(AuditAction::kCohortStatement, AuditObject::kCohort, cohort.id, {{name, was}},
                       {{name, is}});
  }
  transaction.commit();
}

}  // namespace torsio
