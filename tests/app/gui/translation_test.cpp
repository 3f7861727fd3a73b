// SPDX-License-Identifier: GPL-3.0-or-later
// Every sentence of the window has a Chinese one, and a switch of the language reaches everything that is
// seen.
#include <QDate>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/shell/first_run_panel.h"
#include "app/gui/shell/sign_in_panel.h"

namespace torsio::gui {
namespace {

struct Message {
  QString source;
  QString translation;
  bool finished = true;
};

std::vector<Message> chineseMessages() {
  QFile file(QStringLiteral(TORSIO_SOURCE_DIR "/assets/translations/torsio_zh_CN.ts"));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  std::vector<Message> messages;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    if (xml.name() == QLatin1String("message")) {
      messages.emplace_back();
    }
    if (xml.name() == QLatin1String("source")) {
      messages.back().source = xml.readElementText();
    }
    if (xml.name() == QLatin1String("translation")) {
      messages.back().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
      messages.back().translation = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return messages;
}

QStringList placesIn(const QString& text) {
  static const QRegularExpression kPlace(QStringLiteral("%(\\d|L\\d|n)"));
  QStringList places;
  for (auto match = kPlace.globalMatch(text); match.hasNext();) {
    places << match.next().captured();
  }
  places.sort();
  places.removeDuplicates();
  return places;
}

TEST(ChineseTranslation, IsCompleteAndFillsTheSamePlaces) {
  const std::vector<Message> messages = chineseMessages();

  EXPECT_GT(messages.size(), 300U);
  for (const Message& message : messages) {
    EXPECT_TRUE(message.finished) << message.source.toStdString();
    EXPECT_FALSE(message.translation.isEmpty()) << message.source.toStdString();
    QStringList wanted = placesIn(message.source);
    wanted.removeAll(QStringLiteral("%n"));  // a Chinese sentence may say "one" without a figure
    QStringList given = placesIn(message.translation);
    given.removeAll(QStringLiteral("%n"));
    EXPECT_EQ(given, wanted) << message.source.toStdString();
  }
}

/// Texts of labels and buttons that are shown.
QStringList shownTexts(const QWidget& widget) {
  QStringList texts;
  for (const QLabel* label : widget.findChildren<QLabel*>()) {
    if (label->isVisibleTo(&widget)) {
      texts << label->text();
    }
  }
  for (const QAbstractButton* button : widget.findChildren<QAbstractButton*>()) {
    if (button->isVisibleTo(&widget)) {
      texts << button->text();
    }
  }
  texts.removeAll(QString());
  texts.removeAll(QStringLiteral("Torsio"));
  return texts;
}

template <typename Panel>
void switchReaches(Panel& panel) {
  panel.show();
  LanguageSwitch language;
  const QStringList english = shownTexts(panel);
  language.choose(Language::kSimplifiedChinese);
  QGuiApplication::processEvents();
  const QStringList chinese = shownTexts(panel);
  ASSERT_EQ(chinese.size(), english.size());
  for (int i = 0; i < english.size(); ++i) {
    EXPECT_NE(chinese[i], english[i]) << english[i].toStdString();
  }

  language.choose(Language::kEnglish);
  QGuiApplication::processEvents();
  EXPECT_EQ(shownTexts(panel), english);
}

TEST(LanguageSwitch, ReachesEverySentenceOfTheSignIn) {
  SignInPanel panel;
  switchReaches(panel);
}

TEST(LanguageSwitch, ReachesEverySentenceOfTheFirstRun) {
  FirstRunPanel panel(QStringLiteral("/tmp/a.sqlite"));
  switchReaches(panel);
}

TEST(LanguageSwitch, GoesWithNumbersAndDates) {
  QWidget window;  // opened before the choice, as the main window is
  auto* inside = new QLabel(&window);
  LanguageSwitch language;
  EXPECT_EQ(inside->locale(), QLocale(QLocale::English, QLocale::UnitedKingdom));
  const QDate day(2026, 1, 5);
  language.choose(Language::kSimplifiedChinese);
  EXPECT_EQ(inside->locale().language(), QLocale::Chinese);
  EXPECT_EQ(QLocale().language(), QLocale::Chinese);
  EXPECT_TRUE(QLocale().toString(day, QLocale::LongFormat).contains(QChar(0x5E74)));  // "year"
  language.choose(Language::kEnglish);
  EXPECT_TRUE(QLocale().toString(day, QLocale::LongFormat).contains(QStringLiteral("January")));
}

TEST(LanguageSwitch, KnowsItsLanguagesByCodeAndByTheirOwnNames) {
  for (const Language language : {Language::kEnglish, Language::kSimplifiedChinese}) {
    EXPECT_EQ(languageOf(languageCode(language)), language);
    EXPECT_FALSE(languageName(language).isEmpty());
  }
  EXPECT_EQ(languageOf(QStringLiteral("tlh")), std::nullopt);
}

}  // namespace
}  // namespace torsio::gui
