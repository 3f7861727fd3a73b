// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/translated_text.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "app/report/wording.h"

namespace torsio::gui {

namespace {

/// Names and codes that come out of the record, the paper's instrument and the design of the allocation as
/// plain words, and how a text joins others.
[[maybe_unused]] const char* const kPlainTerms[] = {
    QT_TRANSLATE_NOOP("Services", "Effectiveness"),
    QT_TRANSLATE_NOOP("Services", "Force feedback"),
    QT_TRANSLATE_NOOP("Services", "Real-time performance"),
    QT_TRANSLATE_NOOP("Services", "System stability"),
    QT_TRANSLATE_NOOP("Services", "Deformation efficiency"),
    QT_TRANSLATE_NOOP("Services", "Fidelity"),
    QT_TRANSLATE_NOOP("Services", "Image fluency"),
    QT_TRANSLATE_NOOP("Services", "Telepresence"),
    QT_TRANSLATE_NOOP("Services", "Texture"),
    QT_TRANSLATE_NOOP("Services", "interns"),
    QT_TRANSLATE_NOOP("Services", "deputy chief physicians"),
    QT_TRANSLATE_NOOP("Services", "chief physicians"),
    QT_TRANSLATE_NOOP("Services", "deputy chief physician"),
    QT_TRANSLATE_NOOP("Services", "chief physician"),
    QT_TRANSLATE_NOOP("Services", "intern"),
    QT_TRANSLATE_NOOP("Services", "female"),
    QT_TRANSLATE_NOOP("Services", "male"),
    QT_TRANSLATE_NOOP("Services", "other"),
    QT_TRANSLATE_NOOP("Services", "first-year graduate"),
    QT_TRANSLATE_NOOP("Services", "master's student"),
    QT_TRANSLATE_NOOP("Services", "doctoral student"),
    QT_TRANSLATE_NOOP("Services", "sex"),
    QT_TRANSLATE_NOOP("Services", "level"),
    QT_TRANSLATE_NOOP("Services", "experience"),
    QT_TRANSLATE_NOOP("Services", "handedness"),
    QT_TRANSLATE_NOOP("Services", "complete permutation"),
    QT_TRANSLATE_NOOP("Services", "permuted blocks"),
    QT_TRANSLATE_NOOP("Services", "stratified blocks"),
    QT_TRANSLATE_NOOP("Services", "minimisation"),
    QT_TRANSLATE_NOOP("Services", "mt19937_64, bounded by rejection, Fisher-Yates from the back"),
    QT_TRANSLATE_NOOP("Services", "late"),
    QT_TRANSLATE_NOOP("Services", "absent"),
    QT_TRANSLATE_NOOP("Services", "device failed"),
    QT_TRANSLATE_NOOP("Services", "swapped"),
    QT_TRANSLATE_NOOP("Services", "phase cut short"),
    QT_TRANSLATE_NOOP("Services", "phase too long"),
    QT_TRANSLATE_NOOP("Services", "rest too long"),
    QT_TRANSLATE_NOOP("Services", "available-case"),
    QT_TRANSLATE_NOOP("Services", "list-wise"),
    QT_TRANSLATE_NOOP("Services", "renormalised"),
    QT_TRANSLATE_NOOP("Services", "few raters"),
    QT_TRANSLATE_NOOP("Services", "Demonstration centre (simulated)"),
    QT_TRANSLATE_NOOP("Services", "paper"),
    QT_TRANSLATE_NOOP("Services", "Right forearm"),
    QT_TRANSLATE_NOOP("Services", "Stomach"),
    QT_TRANSLATE_NOOP("Services", "Small intestine, loop"),
    QT_TRANSLATE_NOOP("Services", "synthetic, drawn by torsio_make_organs from ANSUR II means"),
    QT_TRANSLATE_NOOP("Services", "synthetic, drawn by torsio_make_organs from published dimensions"),
    QT_TRANSLATE_NOOP("Services", "Simulated trainees after section 6 of the paper"),
    QT_TRANSLATE_NOOP("Services", "%1, %2"),
    QT_TRANSLATE_NOOP("Services", "%1; %2"),
    QT_TRANSLATE_NOOP("Services", "%1 (%2)"),
};

QString patternInLanguage(const std::string& pattern) {
  return QCoreApplication::translate("Services", pattern.c_str());
}

bool windowIsEnglish() {
  const QLocale::Language language = QLocale().language();
  return language == QLocale::English || language == QLocale::C;
}

/// Whether the language of the window has the sentence. Pure values (a path, a code) need no words.
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
      return QCoreApplication::translate("Services", "This cannot be done like this");
    case ErrorCode::kFileMissing:
      return QCoreApplication::translate("Services", "A file or folder is missing");
    case ErrorCode::kFileUnreadable:
      return QCoreApplication::translate("Services", "A file cannot be read");
    case ErrorCode::kFileUnwritable:
      return QCoreApplication::translate("Services", "A file cannot be written");
    case ErrorCode::kBadMesh:
      return QCoreApplication::translate("Services", "The shape of the organ cannot be used");
    case ErrorCode::kBadParameter:
      return QCoreApplication::translate("Services", "A value is not allowed here");
    case ErrorCode::kBadData:
      return QCoreApplication::translate("Services", "The data do not fit together");
    case ErrorCode::kDatabase:
      return QCoreApplication::translate("Services", "The database refused the operation");
    case ErrorCode::kNewerSchema:
      return QCoreApplication::translate("Services", "The database was written by a newer version");
    case ErrorCode::kPermission:
      return QCoreApplication::translate("Services", "Your role may not do this");
    case ErrorCode::kDevice:
      return QCoreApplication::translate("Services", "The haptic device has a problem");
    case ErrorCode::kVerifyFailed:
      return QCoreApplication::translate("Services", "A check found a difference");
    case ErrorCode::kFolded:
      return QCoreApplication::translate("Services", "The organ would be folded");
    case ErrorCode::kInternal:
      break;
  }
  return QCoreApplication::translate("Services", "Something unexpected happened");
}

/// Errors begin in lower case: they also stand within lines of the command line.
QString capitalised(QString sentence) {
  if (!sentence.isEmpty()) {
    sentence[0] = sentence[0].toUpper();
  }
  return sentence;
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
  return worded(text, patternInLanguage);
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
  return QCoreApplication::translate("Services", "%1. %2").arg(said.happened, said.remedy);
}

}  // namespace torsio::gui
