// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <QString>

#include "assessment/domain/ids.h"
#include "sim/core/error.h"
#include "sim/core/text.h"

namespace torsio::gui {

/// Text of a std::string (UTF-8) as it stands: names, codes, what people wrote. A term of the record that has
/// a translation is given as `toQString(Text(term))`. Any thread.
[[nodiscard]] QString toQString(const std::string& utf8);
/// Gives the text of an id as it is.
template <typename Tag>
[[nodiscard]] QString toQString(const Id<Tag>& id) {
  return toQString(id.text());
}
/// Text of a path, in the notation of this system. Any thread.
[[nodiscard]] QString toQString(const std::filesystem::path& path);
/// Path that a text names. The reverse of toQString(path); QString::toStdString() reverses toQString(utf8).
[[nodiscard]] std::filesystem::path toPath(const QString& text);

/// Translates what services say into the language of the window: the pattern is looked up in the context
/// "Text" of the translation, then the arguments, translated themselves, enter. What the translation
/// lacks stays English. GUI thread.
[[nodiscard]] QString toQString(const Text& text);

/// Errors and findings begin in lower case, as they also stand within lines of the command line; alone on a
/// screen they begin with a capital.
[[nodiscard]] QString capitalised(QString sentence);

/// Translates each text; joined, one a line. GUI thread.
[[nodiscard]] QString translatedLines(const std::vector<Text>& texts);

/// A refusal in the language of the window.
struct TranslatedError {
  QString happened;  ///< begins with a capital, no full stop
  QString remedy;    ///< "" when there is none
  QString details;   ///< where; and the English original when the language lacks the sentence
};

/// Translates a refusal. A sentence that the language lacks is replaced by what its ErrorCode means; the
/// original is in the details. GUI thread.
[[nodiscard]] TranslatedError translated(const Error& error);
/// Translates a refusal into one line, "What happened. What to do". GUI thread.
[[nodiscard]] QString translatedLine(const Error& error);

}  // namespace torsio::gui
