// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/access/audit_service.h"

#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/system/audit_verification.h"

namespace torsio {

std::vector<AuditEntry> auditEntries(SessionContext& workplace, const AuditFilter& filter) {
  workplace.require(Operation::kAuditView);
  return AuditRepository(workplace.connection()).entries(filter);
}

std::int64_t auditEntryCount(SessionContext& workplace, std::int64_t fromUtc_us) {
  workplace.require(Operation::kAuditView);
  return AuditRepository(workplace.connection()).count(fromUtc_us);
}

std::map<std::string, std::string> auditActors(SessionContext& workplace) {
  workplace.require(Operation::kAuditView);
  std::map<std::string, std::string> logins;
  for (const StoredUser& user : AccessRepository(workplace.connection()).users()) {
    logins.emplace(user.id, user.login);
  }
  // Simulated raters have no account: their marks stand under the person.
  for (const StoredRater& rater : PeopleRepository(workplace.connection()).raters()) {
    logins.emplace(rater.person.id, rater.person.code);
  }
  return logins;
}

std::vector<AuditFinding> verifyAudit(SessionContext& workplace) {
  workplace.require(Operation::kAuditView);
  std::vector<AuditFinding> findings = verifyAuditTrail(workplace.connection());
  workplace.note({.action = "audit.verify",
                  .objectKind = "audit_entry",
                  .newJson = R"({"findings":)" + std::to_string(findings.size()) + "}"});
  return findings;
}

}  // namespace torsio
