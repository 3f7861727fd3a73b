// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

/// State of the sheet of an assignment.
enum class SheetState {
  kOpen,       ///< assigned, nothing entered
  kDraft,      ///< begun, not submitted
  kSubmitted,  ///< sealed in at least one version
  kWithdrawn,  ///< assignment withdrawn from the rater
};

/// Derives the state from the three stored facts. Withdrawal takes precedence over submission, submission
/// over the draft.
[[nodiscard]] SheetState sheetStateOf(bool withdrawn, bool submitted, bool drafted) noexcept;

/// True while a submission is expected: open or draft.
[[nodiscard]] bool isOutstanding(SheetState state) noexcept;

}  // namespace torsio
