// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/occasion_service.h"

#include <nlohmann/json.hpp>

#include "db/connection/connection.h"
#include "db/repository/study/occasion_repository.h"
#include "sim/core/refusal.h"

namespace torsio {

Occasions knownOccasions(SessionContext& session) {
  session.require(Operation::kPersonViewCoded);
  return OccasionRepository(session.connection()).all();
}

Occasion addOccasion(SessionContext& session, const std::string& label) {
  session.require(Operation::kCurriculumEdit);
  if (label.empty()) {
    refuseParameter(Text::tr("the occasion has no name"), Text::tr("occasion"), Text::tr("Enter one"));
  }
  Transaction transaction(session.connection());
  OccasionRepository repository(session.connection());
  const Occasions known = repository.all();
  for (const Occasion& other : known) {
    if (other.label == label) {
      refuseParameter(Text::tr("another occasion has this name"), label, Text::tr("Choose another name"));
    }
  }
  std::size_t number = known.size() + 1;
  while (known.contains("occasion-" + std::to_string(number))) {
    ++number;
  }
  const Occasion added{"occasion-" + std::to_string(number), label, {}};
  repository.add(added);
  session.note({.action = AuditAction::kOccasionAdd,
                .objectKind = AuditObject::kOccasion,
                .objectId = added.code,
                .newJson = nlohmann::json{{"label", label}}.dump()});
  transaction.commit();
  return added;
}

}  // namespace torsio
