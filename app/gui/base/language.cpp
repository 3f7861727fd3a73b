// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/language.h"

#include <QApplication>
#include <QLocale>
#include <QWidget>

#include "sim/core/contracts.h"

/// Names the resources, which the linker would otherwise drop from a static library.
static void initTranslations() {
  Q_INIT_RESOURCE(torsio_translations);
}

namespace torsio::gui {

namespace {

/// Texts of Qt's own dialogs, for machines without Qt's translation package.
[[maybe_unused]] const char* const kDialogWords[] = {
    QT_TRANSLATE_NOOP("QPlatformTheme", "OK"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Cancel"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Close"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Save"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Open"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "&Yes"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "&No"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Discard"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Apply"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Help"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Reset"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Retry"),
    QT_TRANSLATE_NOOP("QWidgetTextControl", "&Undo"),
    QT_TRANSLATE_NOOP("QWidgetTextControl", "&Redo"),
    QT_TRANSLATE_NOOP("QWidgetTextControl", "Cu&t"),
    QT_TRANSLATE_NOOP("QWidgetTextControl", "&Copy"),
    QT_TRANSLATE_NOOP("QWidgetTextControl", "&Paste"),
    QT_TRANSLATE_NOOP("QWidgetTextControl", "Delete"),
    QT_TRANSLATE_NOOP("QWidgetTextControl", "Select All"),
};

}  // namespace

QString languageCode(Language language) {
  return language == Language::kSimplifiedChinese ? QStringLiteral("zh_CN") : QStringLiteral("en");
}

std::optional<Language> languageOf(const QString& code) {
  for (const Language language : {Language::kEnglish, Language::kSimplifiedChinese}) {
    if (languageCode(language) == code) {
      return language;
    }
  }
  return std::nullopt;
}

QString languageName(Language language) {
  return language == Language::kSimplifiedChinese ? QStringLiteral("\u7b80\u4f53\u4e2d\u6587")
                                                  : QStringLiteral("English");
}

Language presentLanguage() {
  return QLocale().language() == QLocale::Chinese ? Language::kSimplifiedChinese : Language::kEnglish;
}

LanguageSwitch::LanguageSwitch(QObject* parent) : QObject(parent) {
  initTranslations();
  install();
}

LanguageSwitch::~LanguageSwitch() {
  QCoreApplication::removeTranslator(&texts_);
}

void LanguageSwitch::choose(Language language) {
  if (language == present_) {
    return;
  }
  present_ = language;
  install();
}

void LanguageSwitch::install() {
  // Sets the locale first: widgets format numbers and dates on the translator's event.
  QLocale::setDefault(present_ == Language::kEnglish ? QLocale(QLocale::English, QLocale::UnitedKingdom)
                                                     : QLocale(QLocale::Chinese, QLocale::China));
  for (QWidget* window : QApplication::topLevelWidgets()) {
    window->setLocale(QLocale());
  }
  QCoreApplication::removeTranslator(&texts_);
  // English also has a file, for its plurals.
  const bool loaded =
      texts_.load(QStringLiteral(":/torsio/translations/torsio_%1.qm").arg(languageCode(present_)));
  TORSIO_EXPECTS(loaded);
  QCoreApplication::installTranslator(&texts_);
}

}  // namespace torsio::gui
