// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/people/audit_terms.h"

#include <optional>
#include <string>

namespace torsio {

namespace {

template <typename TermValue>
Text labelOf(std::string_view stored) {
  const std::optional<TermValue> known = fromStoredText<TermValue>(stored);
  return known ? Text(labelOf(*known)) : Text(std::string(stored));
}

}  // namespace

Text auditActionLabel(std::string_view storedAction) {
  return labelOf<AuditAction>(storedAction);
}

Text auditObjectLabel(std::string_view storedObject) {
  return labelOf<AuditObject>(storedObject);
}

}  // namespace torsio
