// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace torsio {

/// A function of a prepared server. It runs with the owner's rights.
struct ServerFunction {
  std::string_view name;
  std::string_view arguments;  ///< in CREATE FUNCTION syntax
  std::string_view result;
  std::string_view language;
  std::string_view body;   ///< empty: eraseBody()
  bool ofStations = true;  ///< the station role may call it, also through its row policies
};

/// The functions, each after those that it uses. They find out who has signed in from the token in
/// `torsio.session`, which open_session() gives in return for a password, a code or a link, and decide what
/// needs two people as app/services/access/two_people.h does.
[[nodiscard]] std::span<const ServerFunction> serverFunctions();

/// Returns the body of erase_person, which does what erasePerson() does.
[[nodiscard]] std::string eraseBody();

}  // namespace torsio
