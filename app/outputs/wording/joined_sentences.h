// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace torsio {

/// Sentences one after the other, of whatever language: a blank between them, none after a stop of Chinese,
/// which brings its own room. Empty ones are left out. Any thread.
[[nodiscard]] QString joinedSentences(const QStringList& sentences);

}  // namespace torsio
