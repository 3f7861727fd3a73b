// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/sheet_state.h"

namespace torsio {

SheetState sheetStateOf(bool withdrawn, bool submitted, bool drafted) noexcept {
  if (withdrawn) {
    return SheetState::kWithdrawn;
  }
  if (submitted) {
    return SheetState::kSubmitted;
  }
  return drafted ? SheetState::kDraft : SheetState::kOpen;
}

bool isOutstanding(SheetState state) noexcept {
  return state == SheetState::kOpen || state == SheetState::kDraft;
}

}  // namespace torsio
