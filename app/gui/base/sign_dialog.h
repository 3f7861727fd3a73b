// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "assessment/domain/people/signature.h"

class QWidget;

namespace torsio::gui {

class ShellContext;

/// What a signature says, in the user's language.
[[nodiscard]] QString labelOf(SignatureMeaning meaning);

/// Before something is signed: asks for the actor's own password where it is due, until it is right or the
/// actor gives up. `meaning`: what the signature says, in the user's language. True: it may be signed. GUI
/// thread; a check takes about half a second.
[[nodiscard]] bool readyToSign(QWidget* parent, ShellContext& shell, const QString& meaning);

}  // namespace torsio::gui
