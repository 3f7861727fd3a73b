// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/translated_text.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "app/outputs/wording/wording.h"
#include "app/services/base/log.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

/// Names and codes of the record, the paper's instrument and the allocation design, which have no
/// placeholders.
[[maybe_unused]] const char* const kPlainTerms[] = {
    QT_TRANSLATE_NOOP("Text", "Effectiveness"),
    QT_TRANSLATE_NOOP("Text", "Force feedback"),
    QT_TRANSLATE_NOOP("Text", "Real-time performance"),
    QT_TRANSLATE_NOOP("Text", "System stability"),
    QT_TRANSLATE_NOOP("Text", "Deformation efficiency"),
    QT_TRANSLATE_NOOP("Text", "Fidelity"),
    QT_TRANSLATE_NOOP("Text", "Image fluency"),
    QT_TRANSLATE_NOOP("Text", "Telepresence"),
    QT_TRANSLATE_NOOP("Text", "Texture"),
    QT_TRANSLATE_NOOP("Text", "interns"),
    QT_TRANSLATE_NOOP("Text", "deputy chief physicians"),
    QT_TRANSLATE_NOOP("Text", "chief physicians"),
    QT_TRANSLATE_NOOP("Text", "first-year graduate"),
    QT_TRANSLATE_NOOP("Text", "master's student"),
    QT_TRANSLATE_NOOP("Text", "doctoral student"),
    QT_TRANSLATE_NOOP("Text", "level"),
    QT_TRANSLATE_NOOP("Text", "complete permutation"),
    QT_TRANSLATE_NOOP("Text", "permuted blocks"),
    QT_TRANSLATE_NOOP("Text", "stratified blocks"),
    QT_TRANSLATE_NOOP("Text", "minimisation"),
    QT_TRANSLATE_NOOP("Text", "mt19937_64, bounded by rejection, Fisher-Yates from the back"),
    QT_TRANSLATE_NOOP("Text", "available-case"),
    QT_TRANSLATE_NOOP("Text", "list-wise"),
    QT_TRANSLATE_NOOP("Text", "renormalised"),
    QT_TRANSLATE_NOOP("Text", "few raters"),
    QT_TRANSLATE_NOOP("Text", "Demonstration centre (simulated)"),
    QT_TRANSLATE_NOOP("Text", "paper"),
    QT_TRANSLATE_NOOP("Text", "synthetic, drawn by torsio_make_organs from ANSUR II means"),
    QT_TRANSLATE_NOOP("Text", "synthetic, drawn by torsio_make_organs from published dimensions"),
    QT_TRANSLATE_NOOP("Text", "Simulated trainees after section 6 of the paper"),
    QT_TRANSLATE_NOOP("Text", "Simulated trainees who untwist organs that come twisted"),
    QT_TRANSLATE_NOOP("Text", "untwisting"),
    QT_TRANSLATE_NOOP("Text", "Skills lab (demonstration)"),
    QT_TRANSLATE_NOOP("Text", "Paper protocol: three arms (demonstration)"),
    QT_TRANSLATE_NOOP("Text", "Volvulus and torsion: untwist it (demonstration)"),
    QT_TRANSLATE_NOOP("Text", "Twist on the arm (demonstration)"),
    QT_TRANSLATE_NOOP("Text", "Overall mark on the real arm (demonstration)"),
    QT_TRANSLATE_NOOP("Text", "proposed model (Kriging + membrane)"),
    QT_TRANSLATE_NOOP("Text", "finite elements"),
    QT_TRANSLATE_NOOP("Text", "mass-spring"),
    QT_TRANSLATE_NOOP("Text", "demonstration"),
    QT_TRANSLATE_NOOP("Text", "Right forearm: Pronation, 60 degrees"),  // exercise of the demonstration
};

QString patternInLanguage(const std::string& pattern) {
  return QCoreApplication::translate("Text", pattern.c_str());
}

bool windowIsEnglish() {
  const QLocale::Language language = QLocale().language();
  return language == QLocale::English || language == QLocale::C;
}

/// Returns whether the window's language has the sentence. Values alone (a path, a code) need no translation.
bool known(const Text& text) {
  const QString own = toQString(text.pattern());
  if (own.isEmpty() || windowIsEnglish()) {
    return true;
  }
  return patternInLanguage(text.pattern()) != own;
}

QString meaningOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::kUsage:
      return QCoreApplication::translate("Text", "This action is not possible");
    case ErrorCode::kFileMissing:
      return QCoreApplication::translate("Text", "A file or folder is missing");
    case ErrorCode::kFileUnreadable:
      return QCoreApplication::translate("Text", "A file cannot be read");
    case ErrorCode::kFileUnwritable:
      return QCoreApplication::translate("Text", "A file cannot be written");
    case ErrorCode::kBadMesh:
      return QCoreApplication::translate("Text", "The shape of the organ cannot be used");
    case ErrorCode::kBadParameter:
      return QCoreApplication::translate("Text", "A value is not allowed here");
    case ErrorCode::kBadData:
      return QCoreApplication::translate("Text", "The data do not fit together");
    case ErrorCode::kDatabase:
      return QCoreApplication::translate("Text", "The database refused the operation");
    case ErrorCode::kNewerSchema:
      return QCoreApplication::translate("Text", "The database was written by a newer version");
    case ErrorCode::kPermission:
      return QCoreApplication::translate("Text", "Your role does not allow this");
    case ErrorCode::kDevice:
      return QCoreApplication::translate("Text", "The haptic device has a problem");
    case ErrorCode::kVerifyFailed:
      return QCoreApplication::translate("Text", "A check found a difference");
    case ErrorCode::kFolded:
      return QCoreApplication::translate("Text", "The organ would be folded");
    case ErrorCode::kInternal:
      break;
  }
  return QCoreApplication::translate("Text", "Something unexpected happened");
}

}  // namespace

QString toQString(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

QString toQString(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

std::filesystem::path toPath(const QString& text) {
  return {text.toStdString()};
}

QString toQString(const Text& text) {
  return worded(text, patternInLanguage, QLocale());
}

QString capitalised(QString sentence) {
  if (!sentence.isEmpty()) {
    sentence[0] = sentence[0].toUpper();
  }
  return sentence;
}

QString translatedLines(const std::vector<Text>& texts) {
  QStringList lines;
  for (const Text& text : texts) {
    lines << toQString(text);
  }
  return lines.join(QLatin1Char('\n'));
}

TranslatedError translated(const Error& error) {
  if (known(error.happenedText()) && known(error.remedyText())) {
    return {capitalised(toQString(error.happenedText())), toQString(error.remedyText()),
            toQString(error.whereText())};
  }
  QStringList original;
  for (const std::string& part : {error.where(), error.happened(), error.remedy()}) {
    if (!part.empty()) {
      original << toQString(part);
    }
  }
  return {meaningOf(error.code()), {}, original.join(QLatin1Char('\n'))};
}

QString translatedLine(const Error& error) {
  const TranslatedError said = translated(error);
  if (said.remedy.isEmpty()) {
    return said.happened;
  }
  return QCoreApplication::translate("Text", "%1. %2").arg(said.happened, said.remedy);
}

Problem problemOf(const std::exception_ptr& thrown, const Surprise& surprise) {
  writeLog(LogLevel::kWarning, causeForLog(thrown));
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    return [error] { return translated(error); };
  } catch (const std::exception& error) {
    return [surprise, details = QString::fromUtf8(error.what())] {
      return TranslatedError{surprise.happened(), surprise.remedy(), details};
    };
  }
}

QString problemSentence(const std::exception_ptr& problem) {
  try {
    std::rethrow_exception(problem);
  } catch (const Error& error) {
    return translatedLine(error);
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
}

}  // namespace torsio::gui
