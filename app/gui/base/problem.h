// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>

#include <QString>

#include "app/gui/base/translated_text.h"

namespace torsio::gui {

/// A problem as a function that returns its text in the present language, so that it follows a change of
/// language. GUI thread.
using Problem = std::function<TranslatedError()>;

/// Text for an unexpected exception; its what() goes to the details.
struct Surprise {
  std::function<QString()> happened;
  std::function<QString()> remedy;
};

/// Converts an exception: an Error with its own text, anything else as `surprise`.
[[nodiscard]] Problem problemOf(const std::exception_ptr& thrown, const Surprise& surprise);

}  // namespace torsio::gui
