// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/people/roster_import.h"

namespace torsio {

/// Imports the text of a roster with the suggested columns.
inline RosterOutcome commitRoster(SessionContext& session, const std::string& text,
                                  RosterKind kind = RosterKind::kTrainees,
                                  RosterMode mode = RosterMode::kCommit) {
  const RosterFile file = parseRoster(text, "roster.csv");
  const RosterColumns columns = suggestColumns(file, kind);
  const RosterPreview preview = previewRoster(session, file, kind, columns);
  return importRoster(session, file, kind, columns, preview.fingerprint, mode);
}

}  // namespace torsio
