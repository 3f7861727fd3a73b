// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/audit_service.h"

#include <nlohmann/json.hpp>

#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"
#include "db/migrations/schema_check.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/system/audit_verification.h"

namespace torsio {

std::vector<AuditEntry> auditEntries(SessionContext& session, const AuditFilter& filter) {
  session.require(Operation::kAuditView);
  return AuditRepository(session.connection()).entries(filter);
}

std::int64_t auditEntryCount(SessionContext& session, std::int64_t fromUtc_us, std::int64_t toUtc_us) {
  session.require(Operation::kAuditView);
  return AuditRepository(session.connection()).count(fromUtc_us, toUtc_us);
}

std::map<std::string, std::string> auditActors(SessionContext& session) {
  session.require(Operation::kAuditView);
  std::map<std::string, std::string> logins;
  for (const UserAccount& user : AccessRepository(session.connection()).users()) {
    logins.emplace(user.id, user.login);
  }
  // Simulated raters have no account: the entries of their marks refer to the person.
  for (const Rater& rater : PeopleRepository(session.connection()).raters()) {
    logins.emplace(rater.person.id, rater.person.code);
  }
  return logins;
}

std::map<std::string, std::string> auditSubjectCodes(SessionContext& session, std::int64_t fromSequence) {
  session.require(Operation::kAuditView);
  return auditSubjects(session.connection(), fromSequence);
}

std::vector<AuditFinding> verifyAudit(SessionContext& session) {
  session.require(Operation::kAuditView);
  std::vector<AuditFinding> findings = verifyAuditTrail(session.connection());
  for (const SchemaFinding& finding : schemaFindings(session.connection())) {
    findings.push_back({0, "schema", finding.part, finding.what});
  }
  session.note(AuditAction::kAuditVerify, AuditObject::kAuditEntry, {}, {{"findings", findings.size()}});
  return findings;
}

std::string headWords(std::int64_t length, const std::string& hash, std::int64_t utc_us) {
  return "torsio-head 1 " + std::to_string(length) + " " + (hash.empty() ? "-" : hash) + " " +
         std::to_string(utc_us);
}

std::string plainHead(Connection& connection, std::int64_t now_us) {
  const TrailHead head = AuditRepository(connection).head();
  return headWords(head.length, head.hash, now_us) + " - -";
}

}  // namespace torsio
