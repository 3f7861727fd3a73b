// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/error.h"

namespace torsio {

/// Refuses data that break one of their rules: throws Error{kBadData}. `what`: one sentence without a full
/// stop; `where`: which record, file or line, or ""; `remedy`: one imperative sentence or "". Any thread.
[[noreturn]] inline void refuse(const Text& what, const Text& where, const Text& remedy) {
  throw Error(ErrorCode::kBadData, what, where, remedy);
}

/// Refuses a value outside what is allowed: throws Error{kBadParameter}; otherwise as refuse().
[[noreturn]] inline void refuseParameter(const Text& what, const Text& where, const Text& remedy) {
  throw Error(ErrorCode::kBadParameter, what, where, remedy);
}

}  // namespace torsio
