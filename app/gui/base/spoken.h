// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "sim/base/error.h"
#include "sim/base/text.h"

namespace torsio::gui {

/// What services say, in the language of the window: the pattern is looked up in the context "Services" of
/// the translation, then the arguments, spoken themselves, enter. What the translation lacks stays English.
/// GUI thread.
[[nodiscard]] QString spoken(const Text& text);

/// One a line.
[[nodiscard]] QString spokenLines(const std::vector<Text>& texts);

/// A refusal in the language of the window.
struct SpokenError {
  QString happened;  ///< begins with a capital, no full stop
  QString remedy;    ///< "" when there is none
  QString details;   ///< where; and the English original when the language lacks the sentence
};

/// A sentence that the language lacks is replaced by what its ErrorCode means; the original is in the
/// details.
[[nodiscard]] SpokenError spoken(const Error& error);
/// "What happened. What to do", in one line.
[[nodiscard]] QString spokenLine(const Error& error);

}  // namespace torsio::gui
