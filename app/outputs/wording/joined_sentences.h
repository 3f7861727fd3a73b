// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace torsio {

/// Joins sentences of any language: with a space, or without one after Chinese punctuation, which includes
/// its own space. Skips empty ones. Any thread.
[[nodiscard]] QString joinedSentences(const QStringList& sentences);

}  // namespace torsio
