// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/services/access/move_notice.h"
#include "app/services/access/session_context.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/text.h"

namespace torsio {

class Connection;

/// Returns where the record went when it was moved to another database; empty: it is the living one.
[[nodiscard]] std::string movedTo(Connection& connection);

/// A move that has begun. Until it is finished or undone (settleMove()), the record takes nothing new.
struct BegunMove {
  std::string locator{};  ///< of the other database, without a password; empty: there is none
  TrailHead head{};       ///< of this record's trail right before copying: a complete copy contains it
};
[[nodiscard]] BegunMove begunMove(Connection& connection);
/// Marks the record before it is copied; the newest entry of its trail is that of the move. Call it in the
/// transaction of that entry. kDatabaseRestore.
void noteMoving(SessionContext& session, const std::string& locator);
/// Ends a begun move: the record went to `place`.
void finishMove(Connection& connection, const std::string& place, std::int64_t utc_us);
/// Removes the mark of a begun move: from the copy, or because it was given up.
void clearMoving(Connection& connection, std::int64_t utc_us);

/// Ends a move that noteMoving() began, when the copy is whole: the services go on refusing what would add to
/// the record, at every station. kDatabaseRestore.
void noteMoved(SessionContext& session);

}  // namespace torsio
