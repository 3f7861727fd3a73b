// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "assessment/attempt/trial_listing.h"

namespace torsio {

/// Stores a bookmark of the actor in a run, in the caller's transaction; the caller has checked that the run
/// is the actor's. Returns its id. Throws Error{kBadParameter} for a time outside the recording.
RemarkId keepBookmark(SessionContext& session, const TrialListing& trial, double at_s,
                      const std::string& text);

}  // namespace torsio
