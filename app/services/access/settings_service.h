// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/idle_guard.h"
#include "app/services/access/session_context.h"

namespace torsio {

class Connection;

/// Sets a choice of the centre, the same for all its stations; services read the one that they need
/// themselves. Audited with the old and the new value. kSettingsEdit. Throws Error{kBadParameter} for a name
/// that is not made of lower-case letters, digits and underscores, or a value that is too long.
void setCentreSetting(SessionContext& session, const std::string& name, const std::string& value,
                      const std::string& reason = {});

/// The name that stands at sign-in, on transcripts and in reports made from now on. Audited. kSettingsEdit.
/// Throws Error{kBadParameter} for an empty name.
void setCentreName(SessionContext& session, const std::string& name);

/// Bounds of the idle limits in minutes: short enough to protect a record, long enough to read a page.
inline constexpr int kShortestIdleLock_min = 2;
inline constexpr int kLongestIdleLock_min = 60;

/// After how many minutes without a key or the mouse the window warns and locks, at every station of the
/// centre. For the shell, before anybody signs in: without permission. The usual ones where nothing sensible
/// is set.
[[nodiscard]] IdleLimits centreIdleLimits(Connection& connection);
/// Audited. kSettingsEdit. Throws Error{kBadParameter} unless 1 <= warn < lock and the lock lies within its
/// bounds.
void setCentreIdleLimits(SessionContext& session, int warn_min, int lock_min);

/// Whether runs with mouse and keyboard may be graded ("graded_with_mouse"). Audited. kSettingsEdit.
void setGradedWithMouse(SessionContext& session, bool graded);
/// Whether a sound tells that a limit is reached ("sound_at_limit"); off where nothing is set: in a room with
/// several stations it disturbs the others. Audited. kSettingsEdit.
void setSoundAtLimit(SessionContext& session, bool sound);

}  // namespace torsio
