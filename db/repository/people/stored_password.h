// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "assessment/domain/people/account.h"

namespace torsio {

class Connection;

// A password is stored as an Argon2id hash ("$argon2id$..."). A prepared server stores
// "server1$NONCE$CODE$argon2id$v=19$m=...,t=...,p=1$SALT" instead: CODE depends on the hash, on NONCE and on
// a pepper that only the owner of the tables can read, so that nobody can try words on what a station may
// read. A station computes the hash and lets the server compare it (server_functions.h).

/// Returns a salted hash with its parameters as one text. Slow: call it off the GUI thread. Throws Error
/// (kInternal) without memory.
[[nodiscard]] std::string hashPassword(const std::string& password, PasswordCost cost);

/// Returns the hash of a password with the salt and the parameters of a stored one, of either form; empty if
/// the stored one has another form. Slow, like hashPassword().
[[nodiscard]] std::string hashLike(const std::string& stored, const std::string& password);

/// True if the password fits what is stored, of either form. For the form of a server, this connection must
/// be able to read the pepper: that of a file, or of the owner.
[[nodiscard]] bool passwordMatches(Connection& connection, const std::string& stored,
                                   const std::string& password);

/// How what keptOfProof() returns begins. Earlier versions kept the proof itself.
inline constexpr std::string_view kKeptProof = "kept1$";

/// Returns what a record keeps of the proof of a card or a link: what it holds does not prove anything.
[[nodiscard]] std::string keptOfProof(const std::string& proof);

/// True if this is the form of a server.
[[nodiscard]] bool isHiddenPassword(const std::string& stored);

/// True for a PostgreSQL server whose functions are there.
[[nodiscard]] bool isPrepared(Connection& connection);

/// Returns what a prepared server stores for an Argon2id hash; anything else, and on other records,
/// unchanged.
[[nodiscard]] std::string hiddenPassword(Connection& connection, const std::string& hash);

}  // namespace torsio
