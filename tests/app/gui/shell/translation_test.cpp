// SPDX-License-Identifier: GPL-3.0-or-later
// Every sentence of window, services and report has a Chinese translation, and a change of language reaches
// everything visible.
#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include <QCoreApplication>
#include <QDate>
#include <QDirIterator>
#include <QFile>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/shell/first_run_panel.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {
namespace {

struct Message {
  QString context;
  QString source;
  QString comment;
  QString translation;
  bool finished = true;
};

std::vector<Message> messagesOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  QXmlStreamReader xml(&file);
  std::vector<Message> messages;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    if (xml.name() == QLatin1String("name")) {
      context = xml.readElementText();
    }
    if (xml.name() == QLatin1String("message")) {
      messages.emplace_back().context = context;
    }
    if (xml.name() == QLatin1String("source")) {
      messages.back().source = xml.readElementText();
    }
    if (xml.name() == QLatin1String("comment")) {
      messages.back().comment = xml.readElementText();
    }
    if (xml.name() == QLatin1String("translation")) {
      messages.back().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
      messages.back().translation = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return messages;
}

const QString kTranslations = QStringLiteral(TORSIO_SOURCE_DIR "/assets/translations");

std::vector<Message> chineseMessages() {
  return messagesOf(kTranslations + QStringLiteral("/torsio_zh_CN.ts"));
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

TEST(ChineseTranslation, IsCompleteAndUsesTheSamePlaceholders) {
  const std::vector<Message> messages = chineseMessages();

  EXPECT_GT(messages.size(), 300U);
  for (const Message& message : messages) {
    EXPECT_TRUE(message.finished) << message.source.toStdString();
    EXPECT_FALSE(message.translation.isEmpty()) << message.source.toStdString();
    QStringList wanted = placesIn(message.source);
    wanted.removeAll(QStringLiteral("%n"));  // a Chinese sentence may say "one" without a number
    QStringList given = placesIn(message.translation);
    given.removeAll(QStringLiteral("%n"));
    EXPECT_EQ(given, wanted) << message.source.toStdString();
  }
}

/// "3 s", "%1 mm": numbers have unit symbols; words stay words ("a few seconds").
TEST(ChineseTranslation, HasUnitSymbolsBesideNumbers) {
  static const QRegularExpression kWord(QStringLiteral(
      "(?:[0-9]|%n) ?(?:\u79d2|\u5fae\u79d2|\u6beb\u7c73)"));  // second, microsecond, millimetre
  for (const Message& message : chineseMessages()) {
    EXPECT_FALSE(kWord.match(message.translation).hasMatch()) << message.translation.toStdString();
  }
}

/// A following sentence starts immediately: the full stop includes its space.
TEST(ChineseTranslation, HasNoBlankAfterAFullStop) {
  static const QRegularExpression kBlank(QStringLiteral("[\u3002\uff01\uff1f] "));
  for (const Message& message : chineseMessages()) {
    EXPECT_FALSE(kBlank.match(message.translation).hasMatch()) << message.translation.toStdString();
  }
}

/// Words no longer used, by language; docs/glossary.md has their replacements.
const QStringList kFormerWords{QStringLiteral("Hide names"),        QStringLiteral("The same again"),
                               QStringLiteral("What counts now"),   QStringLiteral("Who was put where"),
                               QStringLiteral("How even it would"), QStringLiteral("sign of life"),
                               QStringLiteral("run day"),           QStringLiteral("Ask raters"),
                               QStringLiteral("let go on target"),  QStringLiteral("other way round"),
                               QStringLiteral("shuffle of"),        QStringLiteral(", nearer"),
                               QStringLiteral("warm-up"),           QStringLiteral("third rater"),
                               QStringLiteral("scoring point"),     QStringLiteral("training run"),
                               QStringLiteral("the office"),        QStringLiteral("nearer tolerance"),
                               QStringLiteral("alignment"),         QStringLiteral("Together:"),
                               QStringLiteral("Bring an organ"),    QStringLiteral("Where to draw"),
                               QStringLiteral("going on"),          QStringLiteral("grip anew"),
                               QStringLiteral("held to be able"),   QStringLiteral(": undo it")};
const QStringList kFormerChineseWords{QStringLiteral("\u8bb2\u8bc4"),                    // debrief
                                      QStringLiteral("\u70ed\u8eab"),                    // rater calibration
                                      QStringLiteral("\u8bc4\u5206\u8005\u6821\u51c6"),  // rater calibration
                                      QStringLiteral("\u8bc4\u5206\u5bf9\u9f50"),        // discrepancy review
                                      QStringLiteral("\u5dee\u5f02\u590d\u6838"),        // discrepancy review
                                      QStringLiteral("\u672a\u89e3\u9501"),              // locked
                                      QStringLiteral("\u5c55\u53f0"),                    // kiosk
                                      QStringLiteral("\u771f\u5b9e\u624b\u81c2"),        // real arm
                                      QStringLiteral("\u75c5\u4f8b"),                    // case
                                      QStringLiteral("\u5f55\u50cf"),                    // recording
                                      QStringLiteral("\u8fd0\u884c\u8bb0\u5f55"),        // recorded runs
                                      QStringLiteral("\u5de5\u4f4d"),                    // station
                                      QStringLiteral("\u529e\u516c\u5ba4"),              // administrators
                                      QStringLiteral("\u5b9e\u81c2")};                   // real arm

TEST(Translations, UseTheGlossarysWordsAndNotTheFormerOnes) {
  static const QRegularExpression kTrial(QStringLiteral("\\btrials?\\b"),
                                         QRegularExpression::CaseInsensitiveOption);
  static const QRegularExpression kAlone(QStringLiteral("(?<!\u65b9\u6848)\u504f\u79bb"));  // deviation
  for (const Message& message : chineseMessages()) {
    for (const QString& word : kFormerWords) {
      EXPECT_FALSE(message.source.contains(word, Qt::CaseInsensitive)) << message.source.toStdString();
    }
    EXPECT_FALSE(message.source.contains(kTrial)) << message.source.toStdString();
    for (const QString& word : kFormerChineseWords) {
      EXPECT_FALSE(message.translation.contains(word)) << message.translation.toStdString();
    }
    if (message.source.contains(QLatin1String("deviation"), Qt::CaseInsensitive) &&
        !message.source.contains(QLatin1String("standard deviation"))) {
      EXPECT_FALSE(message.translation.contains(kAlone)) << message.translation.toStdString();
    }
  }
}

/// An English word with its Chinese equivalents.
struct SaidAs {
  QRegularExpression english;
  QString chinese;
};

TEST(ChineseTranslation, UsesTheGlossarysWordWhereTheEnglishOneOccurs) {
  const auto word = [](const char* pattern) {
    return QRegularExpression(QLatin1String(pattern), QRegularExpression::CaseInsensitiveOption);
  };
  const std::array<SaidAs, 6> pairs{{
      {word("\\brecordings?\\b"), QStringLiteral("\u5f55\u5236")},
      {word("\\bdebrief"), QStringLiteral("\u8bad\u7ec3\u590d\u76d8")},
      {word("\\brater calibration"), QStringLiteral("\u8bc4\u5206\u6821\u51c6")},
      {word("\\bdiscrepancy review"), QStringLiteral("\u8bc4\u5206\u5206\u6b67\u590d\u6838")},
      {word("\\breal arm"), QStringLiteral("\u5b9e\u7269\u624b\u81c2")},
      {word("\\bkiosk"), QStringLiteral("\u81ea\u52a9\u7ec8\u7aef")},
  }};
  std::size_t found = 0;
  for (const Message& message : chineseMessages()) {
    for (const SaidAs& pair : pairs) {
      const QString source = QString(message.source).remove(QLatin1Char('&'));
      if (source.contains(pair.english)) {
        ++found;
        EXPECT_TRUE(message.translation.contains(pair.chinese)) << message.source.toStdString() << "\n"
                                                                << message.translation.toStdString();
      }
    }
  }
  EXPECT_GT(found, 150U);
}

/// The parser of lupdate reads an escape as long as there are hexadecimal digits, so it swallows a letter
/// after it.
TEST(Translations, HaveNoCharacterThatNobodyWrote) {
  for (const Message& message : chineseMessages()) {
    for (const QChar character : message.source) {
      EXPECT_LT(character.unicode(), 0x3000U) << message.source.toStdString();
    }
  }
}

/// Returns whether a text has a plural for each number: %n, or %Ln with digit grouping.
bool hasPlurals(const Message& message) {
  return message.source.contains(QLatin1String("%n")) || message.source.contains(QLatin1String("%Ln"));
}

TEST(EnglishPlurals, AreComplete) {
  for (const Message& message : messagesOf(kTranslations + QStringLiteral("/torsio_en.ts"))) {
    EXPECT_TRUE(message.finished) << message.source.toStdString();
    EXPECT_FALSE(message.translation.contains(QLatin1String("(s)"))) << message.translation.toStdString();
  }
  static const QRegularExpression kEnding(QStringLiteral("[a-z]\\((s|es|ies)\\)"));
  static const QRegularExpression kPair(QStringLiteral("(?<!\\{)\\{[^{}|%]*\\}"));
  for (const Message& message : chineseMessages()) {
    if (!hasPlurals(message)) {
      EXPECT_FALSE(message.source.contains(kEnding)) << message.source.toStdString();
    }
    EXPECT_FALSE(message.source.contains(kPair)) << message.source.toStdString();
    EXPECT_EQ(message.translation.count(QLatin1Char('{')), message.source.count(QLatin1String("{{")) * 2)
        << message.translation.toStdString();
  }
}

/// A number that may be one is followed by "{sheet|sheets}" or occurs in a text with %n.
TEST(EnglishPlurals, AreNotWrittenAfterANumberThatMayBeOne) {
  static const QRegularExpression kCounted(QStringLiteral(
      "(?<!than )(?<!least )(?<!most )(?<!only )(?<!of )(?<!Of )%[1-9] (more |other |open |older )?"
      "(attempts|cases|copies|days|deviations|entries|files|marks|people|persons|raters|"
      "recordings|rows|runs|sheets|stations|tables|trainees|twists)\\b"));
  // Numbers that are never one: whole records, or at least a minimum.
  const QStringList never{
      QStringLiteral("Copied and compared:"),   QStringLiteral("The groups have %1 trainees"),
      QStringLiteral("%1 raters are enough"),   QStringLiteral("%1 trainees, each scored by"),
      QStringLiteral("Not even %1 raters"),     QStringLiteral("%1 people beside others"),
      QStringLiteral("%1 trainees who fail %2")};  // "About 1 in 41 trainees"
  for (const Message& message : chineseMessages()) {
    const bool exempt = message.source == QLatin1String("%1 trainees") ||
                        std::any_of(never.begin(), never.end(),
                                    [&](const QString& text) { return message.source.contains(text); });
    EXPECT_TRUE(exempt || hasPlurals(message) || !message.source.contains(kCounted))
        << message.source.toStdString();
  }
}

using Key = std::tuple<std::string, std::string, std::string>;

std::set<Key> keysOf(const std::vector<Message>& messages) {
  std::set<Key> keys;
  for (const Message& message : messages) {
    keys.emplace(message.context.toStdString(), message.source.toStdString(), message.comment.toStdString());
  }
  return keys;
}

std::string told(const std::set<Key>& keys, const std::set<Key>& without) {
  std::string lines;
  for (const Key& key : keys) {
    if (!without.contains(key)) {
      lines += std::get<0>(key) + ": " + std::get<1>(key) + "\n";
    }
  }
  return lines;
}

TEST(Translations, AreThoseThatLupdateReadsFromTheSources) {
  const QTemporaryDir folder;
  const QStringList files{QStringLiteral("/torsio_zh_CN.ts"), QStringLiteral("/torsio_en.ts")};
  for (const QString& name : files) {
    ASSERT_TRUE(QFile::copy(kTranslations + name, folder.path() + name));
  }

  QProcess renew;
  renew.setProcessChannelMode(QProcess::ForwardedChannels);
  renew.start(kTranslations + QStringLiteral("/renew"), {folder.path()});
  ASSERT_TRUE(renew.waitForFinished(120'000));
  ASSERT_EQ(renew.exitCode(), 0);

  for (const QString& name : files) {
    const std::set<Key> stored = keysOf(messagesOf(kTranslations + name));
    const std::set<Key> said = keysOf(messagesOf(folder.path() + name));
    EXPECT_EQ(told(said, stored), "")
        << "missing in " << name.toStdString() << ": run assets/translations/renew";
    EXPECT_EQ(told(stored, said), "") << "said no more, in " << name.toStdString();
  }
}

/// lupdate loses the class of a Text::tr() that is the first argument of another one, and takes a literal
/// there for a comment.
TEST(ChineseTranslation, KnowsTheClassOfEachText) {
  std::size_t texts = 0;
  for (const Message& message : chineseMessages()) {
    EXPECT_FALSE(message.context.isEmpty()) << message.source.toStdString();
    if (message.context == QLatin1String("Text")) {
      ++texts;
      EXPECT_TRUE(message.comment.isEmpty()) << message.source.toStdString();
    }
  }

  EXPECT_GT(texts, 1500U);
}

/// Adds the texts of an asset's fields `said`.
void addAssetTexts(const QJsonValue& value, const QStringList& said, std::set<std::string>& texts) {
  for (const QJsonValue& item : value.toArray()) {
    addAssetTexts(item, said, texts);
  }
  const QJsonObject object = value.toObject();
  for (auto member = object.begin(); member != object.end(); ++member) {
    if (member.value().isString() && said.contains(member.key())) {
      texts.insert(member.value().toString().toStdString());
    }
    addAssetTexts(member.value(), said, texts);
  }
}

TEST(ChineseTranslation, HasTheTextsOfShippedCurriculaRubricsAndBriefings) {
  const QStringList titles{QStringLiteral("title"), QStringLiteral("label"), QStringLiteral("meaning"),
                           QStringLiteral("description")};
  const QStringList briefings{QStringLiteral("briefing")};
  std::set<std::string> texts;
  for (const QString& kind :
       {QStringLiteral("curricula"), QStringLiteral("rubrics"), QStringLiteral("scenes")}) {
    QDirIterator files(QStringLiteral(TORSIO_SOURCE_DIR "/assets/") + kind, {QStringLiteral("*.json")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      ASSERT_TRUE(file.open(QIODevice::ReadOnly));
      const QJsonDocument document = QJsonDocument::fromJson(file.readAll());
      addAssetTexts(document.isArray() ? QJsonValue(document.array()) : QJsonValue(document.object()),
                    kind == QLatin1String("scenes") ? briefings : titles, texts);
    }
  }

  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);

  static const QRegularExpression kWords(QStringLiteral("[A-Za-z]{2}"));
  EXPECT_GT(texts.size(), 30U);
  for (const std::string& text : texts) {
    const QString english = QString::fromStdString(text);
    if (kWords.match(english).hasMatch()) {
      EXPECT_NE(QCoreApplication::translate("Text", text.c_str()), english) << text;
    }
  }
  language.choose(Language::kEnglish);
}

/// Returns visible texts of labels and buttons.
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
  FirstRunPanel panel(QStringLiteral("/tmp/a.sqlite"), Text());
  switchReaches(panel);
}

TEST(LanguageSwitch, IncludesNumbersAndDates) {
  QWidget window;  // opened before the choice, like the main window
  auto* inside = new QLabel(&window);
  LanguageSwitch language;
  EXPECT_EQ(inside->locale(), QLocale(QLocale::English, QLocale::UnitedKingdom));
  const QDate day(2026, 1, 5);
  language.choose(Language::kSimplifiedChinese);
  EXPECT_EQ(inside->locale().language(), QLocale::Chinese);
  EXPECT_EQ(QLocale().language(), QLocale::Chinese);
  EXPECT_TRUE(QLocale().toString(day, QLocale::LongFormat).contains(QChar(0x5E74)));  // "year"
  EXPECT_EQ(dateText(day), QStringLiteral("2026/1/5"));
  language.choose(Language::kEnglish);
  EXPECT_TRUE(QLocale().toString(day, QLocale::LongFormat).contains(QStringLiteral("January")));
  EXPECT_EQ(dateText(day), QStringLiteral("5 Jan 2026"));  // 05/01 would be May to some
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
