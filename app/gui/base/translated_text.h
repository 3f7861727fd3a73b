// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <QString>

#include "assessment/domain/ids.h"
#include "sim/core/error.h"
#include "sim/core/text.h"

namespace torsio::gui {

/// Converts UTF-8 unchanged: names, codes, user input. For translatable terms of the record use
/// `toQString(Text(term))`. Thread-safe.
[[nodiscard]] QString toQString(const std::string& utf8);
/// Converts an id unchanged.
template <typename Tag>
[[nodiscard]] QString toQString(const Id<Tag>& id) {
  return toQString(id.text());
}
/// Converts a path to this system's notation. Thread-safe.
[[nodiscard]] QString toQString(const std::filesystem::path& path);
/// Converts text to a path, the inverse of toQString(path); QString::toStdString() is the inverse of
/// toQString(utf8).
[[nodiscard]] std::filesystem::path toPath(const QString& text);

/// Translates a text of the services into the window's language: looks the pattern up in the context "Text",
/// then inserts the arguments, also translated. Missing translations stay English. GUI thread.
[[nodiscard]] QString toQString(const Text& text);

/// Capitalises a sentence: errors and findings begin in lower case, because they also appear within lines of
/// the command line.
[[nodiscard]] QString capitalised(QString sentence);

/// Translates the texts and joins them, one per line. GUI thread.
[[nodiscard]] QString translatedLines(const std::vector<Text>& texts);

/// An error in the window's language.
struct TranslatedError {
  QString happened;  ///< capitalised, no full stop
  QString remedy;    ///< empty if there is none
  QString details;   ///< location, and the English original if the sentence has no translation
};

/// Translates an error. A sentence without translation is replaced by the meaning of its ErrorCode, with the
/// original in the details. GUI thread.
[[nodiscard]] TranslatedError translated(const Error& error);
/// Translates an error into one line, "What happened. What to do". GUI thread.
[[nodiscard]] QString translatedLine(const Error& error);

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

/// Returns problem and remedy in one line, for screens before sign-in, which have no problem panel.
[[nodiscard]] QString problemSentence(const std::exception_ptr& problem);

}  // namespace torsio::gui
