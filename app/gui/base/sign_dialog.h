// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/domain/people/signature.h"

class QWidget;

namespace torsio::gui {

class ShellContext;

/// Asks for the actor's password before signing if required, until it is correct or the actor cancels. True:
/// may be signed. GUI thread; a check takes about half a second.
[[nodiscard]] bool readyToSign(QWidget* parent, ShellContext& shell, SignatureMeaning meaning);

}  // namespace torsio::gui
