// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>

#include <QString>

#include "app/gui/base/translated_text.h"

namespace torsio::gui {

/// A problem that can be told again when the window changes its language: each call says it in the present
/// one. Holds what happened, not words. GUI thread.
using Problem = std::function<TranslatedError()>;

/// How something is told that was never meant to be thrown; what() goes to the details.
struct Surprise {
  std::function<QString()> happened;
  std::function<QString()> remedy;
};

/// Of what was thrown: an Error as toQString() says it, anything else as `surprise`.
[[nodiscard]] Problem problemOf(const std::exception_ptr& thrown, const Surprise& surprise);

}  // namespace torsio::gui
