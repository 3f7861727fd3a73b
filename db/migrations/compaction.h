// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

class Connection;

/// Checkpoints and truncates the write-ahead log, so that erased data do not survive in it. Postponed while
/// others read or write. No effect on a server. Outside a transaction.
void truncateLog(Connection& connection);

/// Returns the space of removed rows to the disk and truncates the log. Skipped while others read or write.
/// No effect on a server, which does it by itself. Outside a transaction.
void compactDatabase(Connection& connection);

}  // namespace torsio
