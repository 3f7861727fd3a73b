// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "sim/core/text.h"

namespace torsio {

/// Who takes care of a record without the window: somebody who signs in, or the account of the operating
/// system that owns it.
struct Maintainer {
  std::string login{};                      ///< empty: the system
  std::function<std::string()> password{};  ///< asked once, when the record is open
  std::string secondLogin{};  ///< of another administrator, for what needs two people; empty: nobody
  std::function<std::string()> secondPassword{};
  std::string systemAccount{};                              ///< empty, and no login: nobody, who may nothing
  std::function<bool(const std::string& file)> ownsFile{};  ///< of that account; for SQLite
  std::function<void(const Text&)> tell{};                  ///< hears what was mended; may be empty
};

}  // namespace torsio
