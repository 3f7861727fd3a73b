// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/domain/ids.h"

namespace torsio {

/// Whose cards and links an earlier version stored in a form that opens nothing any more: on a prepared
/// server both, in a file links.
struct OutdatedAccess {
  std::vector<UserId> cards{};
  std::vector<UserId> links{};
};

}  // namespace torsio
