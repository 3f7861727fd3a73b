// SPDX-License-Identifier: GPL-3.0-or-later
// Every screen with the demonstration record: switched to Chinese while open, and in a pseudo language with
// 40 % longer words, at the smallest supported size.
#include <map>
#include <set>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QEventLoop>
#include <QFont>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTabBar>
#include <QTableView>
#include <QTextDocumentFragment>
#include <QTimer>
#include <QTranslator>
#include <gtest/gtest.h>

#include "app/gui/administrator/reporting/report_preview.h"
#include "app/gui/base/language.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/program/screenshots.h"
#include "app/gui/shell/desk.h"
#include "app/outputs/charts/typeface.h"
#include "tests/app/gui/program/screen_faults.h"
#include "tests/app/gui/support/visible_texts.h"

namespace torsio::gui {
namespace {

constexpr double kWiderFace_percent = 115.0;
constexpr QSize kSmallest(1366, 768);
constexpr QSize kWide[] = {{1920, 1080}, {3840, 2160}};

/// Returns whether a text is the same in every language: names of the demonstration, codes, units, names of
/// programs.
bool isLanguageNeutral(const QString& text) {
  static const QRegularExpression kKept(QStringLiteral(
      "^("
      "Torsio|English|Skills laboratory|administrator|demo\\.\\w+|"                    // names
      "Good grip\\..*|server\\.hospital\\.example|Station 1|.*\\(demonstration\\).*|"  // names in the
                                                                                       // demonstration record
      "[A-Z]{1,2}-?[0-9]{1,3}\\b.*|[0-9]+[A-Z]|"  // codes: T-01, G1, M1 ..., 7F
      "(PM|FEM|MSM|Hedges g|Krippendorff α|ICC\\(2,[1k]\\))( \\[95.%\\])?|[pz] "
      "\\((Holm|Dunn|Greenhouse-Geisser)\\)|"  // models,
                                               // statistics
      "(evaluation|training)-1|Saint-Venant|"  // versions and names of formulas
      "[\\W\\d_]*([kmµ]?(Pa|N|Nm|N m|m|s|Hz|B|MiB|GiB)|CSV|PDF|PIN|ms|µs|X|Y|Z|F1)?[\\W\\d_]*|"  // units
      "/.*|[0-9a-f]{8,}.*|R-[0-9]+-[0-9a-f]{8}|\\d.*UTC"  // paths, hashes, numbers of reports, times
      ")$"));
  return kKept.match(text.trimmed()).hasMatch();
}

/// Messages shown for a moment while something is opened or done, which are not repeated, and the anchor of
/// the current row. An open problem keeps its language.
constexpr int kMaxWaits = 40;
constexpr int kWait_ms = 50;

bool passes(const QString& text) {
  static const QRegularExpression kPassing(
      QStringLiteral("^(Opening .*|The recording is being opened.*|On target\\..*|: "
                     ".*|[A-Z]+ [-\u2212] [A-Z]+)$"));  // two models
  return kPassing.match(text).hasMatch();
}

/// Screens that are modal: nobody switches the language while one is open.
const std::set<QString> kModal{QStringLiteral("second-factor")};

QString plain(const QString& text) {
  return Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
}

void add(QStringList& texts, const QString& text) {
  for (const QString& line : plain(text).split(QLatin1Char('\n'))) {
    if (!line.trimmed().isEmpty()) {
      texts << line.trimmed();
    }
  }
}

/// Returns the visible texts: labels, buttons, tabs, headers, boxes, lists, placeholders, and the report.
QStringList seenTexts(QWidget& window) {
  QStringList texts;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisibleTo(&window)) {
      continue;
    }
    if (const auto* label = qobject_cast<QLabel*>(widget)) {
      add(texts, label->text());
    }
    if (const auto* button = qobject_cast<QAbstractButton*>(widget)) {
      add(texts, button->text());
    }
    if (const auto* box = qobject_cast<QGroupBox*>(widget)) {
      add(texts, box->title());
    }
    if (const auto* combo = qobject_cast<QComboBox*>(widget)) {
      add(texts, combo->currentText());
    }
    if (const auto* field = qobject_cast<QLineEdit*>(widget)) {
      add(texts, field->placeholderText());
    }
    if (const auto* report = qobject_cast<ReportPreview*>(widget)) {
      add(texts, report->toPlainText());
    }
    if (const auto* list = qobject_cast<QListWidget*>(widget)) {
      for (int i = 0; i < list->count(); ++i) {
        add(texts, list->item(i)->text());
      }
    }
    if (const auto* tabs = qobject_cast<QTabBar*>(widget)) {
      for (int i = 0; i < tabs->count(); ++i) {
        add(texts, tabs->tabText(i));
      }
    }
    if (const auto* table = qobject_cast<QTableView*>(widget)) {
      for (int i = 0; i < table->model()->columnCount(); ++i) {
        if (!table->isColumnHidden(i)) {
          add(texts, table->model()->headerData(i, Qt::Horizontal).toString());
        }
      }
    }
  }
  return texts;
}

/// Returns whether a Chinese reader sees a text without any Chinese character.
bool lacksChinese(const QString& text) {
  static const QRegularExpression kChinese(QStringLiteral("\\p{Han}"));
  static const QRegularExpression kWord(QStringLiteral("[A-Za-z]{2,}"));
  return kWord.match(text).hasMatch() && !kChinese.match(text).hasMatch() && !isLanguageNeutral(text);
}

/// Adds accents, 40 % more letters, and brackets that reveal clipping.
class PseudoTranslator : public QTranslator {
 public:
  [[nodiscard]] bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char*, int) const override {
    // Formats of Qt itself ("%1 (%2)" of dialogs) must stay usable.
    if (QByteArray(context).startsWith("Q") && QByteArray(context) != "QPlatformTheme") {
      return {};
    }
    static const QHash<QChar, QChar> kAccents{{u'a', u'\u00e4'}, {u'e', u'\u00e9'}, {u'i', u'\u00ef'},
                                              {u'o', u'\u00f6'}, {u'u', u'\u00fc'}, {u'A', u'\u00c4'},
                                              {u'E', u'\u00c9'}, {u'O', u'\u00d6'}, {u'n', u'\u00f1'}};
    QString text = QString::fromUtf8(source);
    const auto longer = static_cast<qsizetype>(0.4 * static_cast<double>(text.size()));
    for (qsizetype i = 0; i < text.size(); ++i) {
      const bool place = i > 0 && (text[i - 1] == u'%' || text[i - 1] == u'&');
      if (!place) {
        text[i] = kAccents.value(text[i], text[i]);
      }
    }
    return QStringLiteral("[") + text + QString(longer, QLatin1Char('~')) + QStringLiteral("]");
  }
};

/// Removes times and sizes, which change while a screen is shown.
QStringList withoutNumbers(QStringList texts) {
  static const QRegularExpression kNumber(QStringLiteral("[0-9]+([.,][0-9]+)*"));
  return texts.replaceInStrings(kNumber, QString());
}

void retranslated() {
  QCoreApplication::processEvents();
  // Lays out what a timer has just shown, from the inside outwards.
  for (int depth = 0; depth < 4; ++depth) {
    QCoreApplication::sendPostedEvents();
  }
}

/// Returns whether a duration of a minute or more is in plain seconds, or has a leading zero: value_text.h
/// formats 1:15.
bool hasUnformattedDuration(const QString& text) {
  static const QRegularExpression kOtherwise(
      QStringLiteral("(^|[^\\d.:])([6-9]\\d|\\d{3,})([.,]\\d+)? s($|[ .,;)])|(^|[^\\d])0\\d:\\d\\d[.]\\d"));
  return kOtherwise.match(text).hasMatch();
}

using Findings = std::map<QString, std::set<QString>>;

/// The program's typeface, and two that represent substitutes on other machines: a different design, and
/// letters 15 % wider.
struct Face {
  QString name;
  QFont font;
};

std::vector<Face> faces() {
  QFont serif = QApplication::font();
  serif.setFamilies({QStringLiteral("DejaVu Serif")});
  QFont wide = QApplication::font();
  wide.setLetterSpacing(QFont::PercentageSpacing, kWiderFace_percent);
  return {{QLatin1String(kTypeface), QApplication::font()},
          {QStringLiteral("serif"), serif},
          {QStringLiteral("wide"), wide}};
}

/// Walks over all screens: each opened in English, then switched to Chinese and to the pseudo language, the
/// latter in all typefaces.
class Walk {
 public:
  Findings switched;  // English texts that a Chinese reader sees
  Findings stuck;     // texts that do not return to English
  Findings cut;       // pseudo language
  Findings doubled;   // keys claimed twice on a screen, and repeated titles
  Findings clipped;   // English and Chinese
  Findings spans;     // durations formatted unlike on other screens
  Findings numbers;   // numbers formatted unlike on other screens
  Findings crowding;  // pages in a corner of a wide screen
  int screens = 0;

  Walk() {
    ScreenshotsRequest request;
    request.assets = TORSIO_SOURCE_DIR "/assets";
    request.sizes = {kSmallest};
    request.themes = {ThemeKind::kLight};
    request.languages = {Language::kEnglish};
    request.look = [this](const QString& name, QWidget& window) { look(name, window); };
    takeAllScreenshots(request);
  }

 private:
  void findDoubled(const QString& name, QWidget& window) {
    for (const QString& text : testing::doubledKeys(window) + testing::doubledTitles(window)) {
      doubled[name].insert(text);
    }
  }

  [[nodiscard]] static std::set<QString> othersThan(const QStringList& before, QWidget& window) {
    std::set<QString> others;
    for (const QString& text : withoutNumbers(seenTexts(window))) {
      if (!before.contains(text) && !passes(text)) {
        others.insert(text);
      }
    }
    return others;
  }

  void look(const QString& name, QWidget& window) {
    ++screens;
    const QStringList before = withoutNumbers(seenTexts(window));
    findDoubled(name, window);
    for (const QString& text : testing::roughNumbers(window)) {
      numbers[name].insert(text);
    }
    for (const QString& text : testing::clippedTexts(window)) {
      clipped[name].insert(text);
    }
    for (const QString& text : seenTexts(window)) {
      if (hasUnformattedDuration(text)) {
        spans[name].insert(text);
      }
    }
    {
      LanguageSwitch chinese;
      chinese.choose(Language::kSimplifiedChinese);
      retranslated();
      for (const QString& text : seenTexts(window)) {
        if (lacksChinese(text) && !passes(text) && kModal.count(name) == 0) {
          switched[name].insert(text);
        }
      }
      findDoubled(name, window);
      for (const QString& text : testing::clippedTexts(window)) {
        clipped[name + QStringLiteral(" (Chinese)")].insert(text);
      }
      chinese.choose(Language::kEnglish);
      retranslated();
    }
    // Content that changes while a screen is shown uses the language chosen last.
    std::set<QString> left = othersThan(before, window);
    for (int wait = 0; wait < kMaxWaits && !left.empty(); ++wait) {
      QEventLoop loop;
      QTimer::singleShot(kWait_ms, &loop, &QEventLoop::quit);
      loop.exec();
      left = othersThan(before, window);
    }
    if (!left.empty()) {
      stuck[name] = left;
    }
    PseudoTranslator pseudo;
    QCoreApplication::installTranslator(&pseudo);
    const QFont usual = QApplication::font();
    for (const Face& face : faces()) {
      QApplication::setFont(face.font);
      // A layout passes its new height to its parent layout in the next iteration.
      for (int round = 0; round < 6; ++round) {
        retranslated();
      }
      for (const QString& text : testing::cutTexts(window)) {
        cut[QStringLiteral("%1 (%2)").arg(name, face.name)].insert(text);
      }
    }
    QApplication::setFont(usual);
    QCoreApplication::removeTranslator(&pseudo);
    retranslated();
    lookAtWide(name, window);
  }

  void lookAtWide(const QString& name, QWidget& window) {
    const auto* desk = qobject_cast<const Desk*>(&window);
    const QWidget& page = desk != nullptr && desk->page() != nullptr ? *desk->page() : window;
    window.setUpdatesEnabled(false);  // only positions are checked, not the picture
    for (const QSize& size : kWide) {
      window.resize(size);
      for (int round = 0; round < 3; ++round) {
        retranslated();
      }
      const QString width = QStringLiteral("%1 (%2)").arg(name).arg(size.width());
      if (const QString found = testing::crowded(page); !found.isEmpty()) {
        crowding[width].insert(found);
      }
      for (const QString& text : testing::clippedTexts(window)) {
        clipped[width].insert(text);
      }
    }
    window.resize(kSmallest);
    window.setUpdatesEnabled(true);
  }
};

std::string told(const Findings& findings) {
  QString all;
  for (const auto& [screen, texts] : findings) {
    for (const QString& text : texts) {
      all += QStringLiteral("%1: %2\n").arg(screen, text);
    }
  }
  return all.toStdString();
}

TEST(Faces, AreFixedAndTheWideOneIsFifteenPercentWider) {
  const QString sentence = QStringLiteral("Every rater gets an order of their own");
  const std::vector<Face> all = faces();

  EXPECT_EQ(QFontInfo(all[0].font).family(), QLatin1String(kTypeface));
  const double usual = QFontMetricsF(all[0].font).horizontalAdvance(sentence);
  EXPECT_NEAR(QFontMetricsF(all[2].font).horizontalAdvance(sentence), 1.15 * usual, 0.01 * usual);
}

/// A single test, because the walk takes most of a minute.
TEST(EveryScreen, IsChineseAfterALiveSwitchEnglishAgainAndHasRoomForLongerTexts) {
  const Walk walk;

  EXPECT_GT(walk.screens, 30);
  EXPECT_TRUE(walk.switched.empty()) << told(walk.switched);
  EXPECT_TRUE(walk.stuck.empty()) << told(walk.stuck);
  EXPECT_TRUE(walk.cut.empty()) << told(walk.cut);
  EXPECT_TRUE(walk.doubled.empty()) << told(walk.doubled);
  EXPECT_TRUE(walk.clipped.empty()) << told(walk.clipped);
  EXPECT_TRUE(walk.spans.empty()) << told(walk.spans);
  EXPECT_TRUE(walk.numbers.empty()) << told(walk.numbers);
  EXPECT_TRUE(walk.crowding.empty()) << told(walk.crowding);
}

TEST(TranslatedErrors, InsertsArgumentsIntoTheChineseSentence) {
  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);

  const Error error(ErrorCode::kBadData, Text::tr("row %1 is not answered", std::string("C2")),
                    Text::tr("case %1", std::string("7F")), Text::tr("Fill it in"));
  const TranslatedError said = translated(error);

  EXPECT_EQ(said.happened.toStdString(), "\u7b2c C2 \u9879\u672a\u4f5c\u7b54");
  EXPECT_TRUE(said.details.endsWith(QStringLiteral("7F")));
  EXPECT_NE(said.remedy, QStringLiteral("Fill it in"));
}

TEST(TranslatedErrors, NamesTheKindOfErrorIfTheSentenceHasNoTranslation) {
  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);

  const TranslatedError said =
      translated(Error(ErrorCode::kDatabase, Text::verbatim("zxqv 17"), "", Text::tr("Try again")));

  EXPECT_FALSE(lacksChinese(said.happened));
  EXPECT_TRUE(said.details.contains(QStringLiteral("zxqv 17")));
  language.choose(Language::kEnglish);
  EXPECT_EQ(
      translated(Error(ErrorCode::kDatabase, Text::verbatim("zxqv 17"), "", Text::tr("Try again"))).happened,
      QStringLiteral("Zxqv 17"));
}

}  // namespace
}  // namespace torsio::gui
