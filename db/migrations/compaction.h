// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

class Connection;

/// Empties the write-ahead log into the file, so that what was erased is not left in the log. While others
/// read or write, it is left to the next time. Nothing for a server. Outside a transaction.
void truncateLog(Connection& connection);

/// Gives the room of removed rows back to the disk, and empties the log. While others read or write, it is
/// left as it is. Nothing for a server, which does it by itself. Outside a transaction.
void compactDatabase(Connection& connection);

}  // namespace torsio
