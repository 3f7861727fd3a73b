// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetricsF>
#include <QString>
#include <QStringList>

namespace torsio {

/// The parts of a text between which a line may end: words, parts of words after a hyphen, and in Chinese
/// each character with its marks. A part keeps the space behind it.
[[nodiscard]] QStringList breakableParts(const QString& text);

/// Width of the longest part: the narrowest that a column may become. Chinese is not broken after every
/// character: up to `together` of them stay on a line.
[[nodiscard]] double widestPart(const QString& text, const QFontMetricsF& metrics, qsizetype together = 4);

/// The text in lines of at most `width`, as long as its parts allow.
[[nodiscard]] QStringList wrappedLines(const QString& text, double width, const QFontMetricsF& metrics);

}  // namespace torsio
