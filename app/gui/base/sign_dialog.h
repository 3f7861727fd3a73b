// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/domain/people/signature.h"

class QWidget;

namespace torsio::gui {

class ShellContext;

/// Before something is signed: asks for the actor's own password where it is due, until it is right or the
/// actor gives up. True: it may be signed. GUI thread; a check takes about half a second.
[[nodiscard]] bool readyToSign(QWidget* parent, ShellContext& shell, SignatureMeaning meaning);

}  // namespace torsio::gui
