// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetricsF>
#include <QString>
#include <QStringList>

namespace torsio {

/// Splits a text where a line may break: words, parts of words after a hyphen, and Chinese characters with
/// their punctuation. A part keeps its trailing space.
[[nodiscard]] QStringList breakableParts(const QString& text);

/// Returns the width of the longest part, the minimum column width. Up to `together` Chinese characters stay
/// on one line.
[[nodiscard]] double widestPart(const QString& text, const QFontMetricsF& metrics, qsizetype together = 4);

/// Wraps the text to lines of at most `width`, as far as its parts allow.
[[nodiscard]] QStringList wrappedLines(const QString& text, double width, const QFontMetricsF& metrics);

}  // namespace torsio
