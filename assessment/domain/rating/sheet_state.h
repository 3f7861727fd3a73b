// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

/// How far the sheet of one assignment has come.
enum class SheetState {
  kOpen,       ///< asked for, nothing written
  kDraft,      ///< begun, not sealed
  kSubmitted,  ///< sealed in at least one version
  kWithdrawn,  ///< taken back from its rater
};

/// Gives the state of a sheet from the three facts that the record holds of it. Withdrawal counts before
/// submission, submission before the draft.
[[nodiscard]] SheetState sheetStateOf(bool withdrawn, bool submitted, bool drafted) noexcept;

/// Says whether somebody is still waited for: the sheet is open or a draft.
[[nodiscard]] bool isOutstanding(SheetState state) noexcept;

}  // namespace torsio
