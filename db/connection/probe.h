// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

class Connection;

/// Asks the database for an answer, one round trip. Throws DbError{kUnreachable} if the server does not
/// answer or has closed the connection.
void probe(Connection& connection);

}  // namespace torsio
