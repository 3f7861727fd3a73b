// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "assessment/attempt/trial_listing.h"

namespace torsio {

/// Keeps a bookmark of the actor at a moment of a run that the caller has found to be the actor's own, inside
/// the caller's transaction. Returns its id. Throws Error{kBadParameter} for a
/// moment outside the recording.
RemarkId keepBookmark(SessionContext& session, const TrialListing& trial, double at_s,
                      const std::string& text);

}  // namespace torsio
