// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDateEdit>
#include <QDir>
#include <QIcon>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTest>
#include <QTimeEdit>
#include <QVBoxLayout>
#include <gtest/gtest.h>

#include "app/gui/base/page.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/gauges.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/page_parts.h"

namespace torsio::gui {
namespace {

// WCAG 2.1: text 4.5 : 1 (1.4.3), parts of the interface 3 : 1 (1.4.11).
constexpr double kText = 4.5;
constexpr double kMark = 3.0;

double channel(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
  return 0.2126 * channel(colour.redF()) + 0.7152 * channel(colour.greenF()) +
         0.0722 * channel(colour.blueF());
}

/// Returns the contrast ratio of two opaque colours, 1..21 (WCAG 2).
double contrast(const QColor& a, const QColor& b) {
  const auto [dim, bright] = std::minmax({luminance(a), luminance(b)});
  return (bright + 0.05) / (dim + 0.05);
}

class ThemeContrast : public ::testing::TestWithParam<ThemeKind> {};

TEST(Theme, ContrastOfBlackAndWhiteIsTwentyOne) {
  EXPECT_NEAR(contrast(Qt::white, Qt::black), 21.0, 1e-9);
  EXPECT_NEAR(contrast(Qt::red, Qt::red), 1.0, 1e-12);
}

TEST_P(ThemeContrast, TextIsLegibleOnEveryBackground) {
  const Theme& t = theme(GetParam());

  for (const QColor& ground : {t.window, t.surface, t.raised}) {
    EXPECT_GE(contrast(t.text, ground), kText);
    EXPECT_GE(contrast(t.quietText, ground), kText);
  }
  for (const QColor& words : {t.good, t.caution, t.recording, t.accent}) {
    EXPECT_GE(contrast(words, t.surface), kText);
    EXPECT_GE(contrast(words, t.window), kText);
  }
  EXPECT_GE(contrast(t.onAccent, t.accent), kText);
}

/// Returns the painted colour of a text, which may be translucent.
QColor shownOn(const QColor& ground, const QColor& text) {
  const auto alpha = static_cast<double>(text.alphaF());
  const auto mixed = [alpha](int from, int to) { return static_cast<int>(from + (to - from) * alpha); };
  return QColor(mixed(ground.red(), text.red()), mixed(ground.green(), text.green()),
                mixed(ground.blue(), text.blue()));
}

TEST_P(ThemeContrast, HintsInFieldsAndDisabledTextsAreLegible) {
  const Theme& t = theme(GetParam());
  applyTheme(*qApp, t);
  for (const QColor& ground : {t.window, t.surface, t.raised}) {
    EXPECT_GE(contrast(t.disabledText, ground), kText);
  }

  QWidget window;
  QLineEdit line(&window);
  QPlainTextEdit text(&window);
  QPushButton button(QStringLiteral("Save"), &window);
  QComboBox box(&window);
  const std::vector<QWidget*> fields{&line, &text, &button, &box};
  window.show();
  for (QWidget* field : fields) {
    field->ensurePolished();
    const QPalette& palette = field->palette();
    for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled}) {
      if (field == &line || field == &text) {
        const QColor hint = palette.color(group, QPalette::PlaceholderText);
        EXPECT_GE(contrast(shownOn(t.surface, hint), t.surface), kText)
            << field->metaObject()->className() << ' ' << group;
      }
      EXPECT_GE(contrast(shownOn(t.raised, palette.color(group, QPalette::ButtonText)), t.raised), kText)
          << field->metaObject()->className() << ' ' << group;
      EXPECT_GE(contrast(shownOn(t.surface, palette.color(group, QPalette::Text)), t.surface), kText)
          << field->metaObject()->className() << ' ' << group;
    }
  }
}

TEST(Icons, AreDifferentForEachPageOfTheNavigation) {
  std::map<QString, PageId> pages;
  for (int i = 0; i <= static_cast<int>(PageId::kDevices); ++i) {
    const auto id = static_cast<PageId>(i);
    const QString name = QString::fromLatin1(factsOf(id).icon);
    if (name.isEmpty()) {
      continue;
    }
    const auto [other, first] = pages.emplace(name, id);
    EXPECT_TRUE(first) << name.toStdString() << ": " << pageText(id).toStdString() << " and "
                       << pageText(other->second).toStdString();
  }
  EXPECT_GT(pages.size(), 20U);
}

TEST(Icons, TheProgramHasItsOwnInEverySize) {
  const QIcon sign = applicationIcon();
  for (const int size : {16, 32, 64, 256}) {
    const QImage picture = sign.pixmap(size, size).toImage();
    ASSERT_EQ(picture.width(), size);
    EXPECT_GT(picture.pixelColor(size / 2, size / 16 + 1).alpha(), 200);
  }
}

TEST_P(ThemeContrast, MarksStandOutFromTheirBackground) {
  const Theme& t = theme(GetParam());

  EXPECT_GE(contrast(t.border, t.surface), kMark);
  for (const QColor& mark : {t.accent, t.good, t.caution}) {
    EXPECT_GE(contrast(mark, t.track), kMark);
  }
  for (const QColor& line : {t.grasp, t.lattice, t.wire, t.shaft}) {
    EXPECT_GE(contrast(line, t.backdrop), kMark);
  }
}

INSTANTIATE_TEST_SUITE_P(LightAndDark, ThemeContrast, ::testing::Values(ThemeKind::kLight, ThemeKind::kDark));

TEST_P(ThemeContrast, ACardLooksLikeOneWhateverItsObjectName) {
  const Theme& t = theme(GetParam());
  applyTheme(*qApp, t);
  Card card(QStringLiteral("This session"));
  card.setObjectName(QStringLiteral("session"));
  card.resize(300, 100);
  card.show();
  QApplication::processEvents();

  const QImage picture = card.grab().toImage();

  EXPECT_EQ(picture.pixelColor(picture.width() / 2, picture.height() - 20), t.surface);
}

TEST_P(ThemeContrast, TheCurrentEntryOfAnOpenListIsReadable) {
  const Theme& t = theme(GetParam());
  applyTheme(*qApp, t);
  QComboBox box;
  box.addItems({QStringLiteral("a"), QStringLiteral("the current one"),
                QStringLiteral("one that is much longer than the field above it is wide")});
  box.setCurrentIndex(1);
  box.resize(120, box.sizeHint().height());
  box.show();
  box.showPopup();
  QApplication::processEvents();

  const QAbstractItemView& list = *box.view();
  const QRect row = list.visualRect(list.model()->index(1, 0));
  const QImage picture = const_cast<QAbstractItemView&>(list).viewport()->grab().toImage();
  const QColor ground = picture.pixelColor(row.right() - 12, row.center().y());

  EXPECT_GE(contrast(t.onAccent, ground), kText) << ground.name().toStdString();
  EXPECT_GE(list.viewport()->width(), list.sizeHintForColumn(0));  // no entry is clipped
  box.hidePopup();
}

// Side by side in a form, with and without focus.
TEST_P(ThemeContrast, FieldsInALineHaveTheSameHeight) {
  applyTheme(*qApp, theme(GetParam()));
  QWidget window;
  QLineEdit line(&window);
  QComboBox box(&window);
  QComboBox writable(&window);
  writable.setEditable(true);
  QSpinBox count(&window);
  QDoubleSpinBox number(&window);
  QDateEdit day(&window);
  QTimeEdit hour(&window);
  window.show();

  for (QWidget* field : std::vector<QWidget*>{&line, &box, &writable, &count, &number, &day, &hour}) {
    field->ensurePolished();
    const int height = field->sizeHint().height();
    EXPECT_EQ(height, 30) << field->metaObject()->className();
    window.activateWindow();
    field->setFocus();
    EXPECT_EQ(field->sizeHint().height(), height) << field->metaObject()->className();
  }
}

// The current entry's background reaches the edges, its text has padding.
TEST_P(ThemeContrast, EntriesOfAListHavePadding) {
  const Theme& t = theme(GetParam());
  applyTheme(*qApp, t);
  QListWidget list;
  list.addItem(QStringLiteral("HHHH"));
  list.addItem(QStringLiteral("HHHH"));
  list.resize(300, 120);
  list.show();
  list.setCurrentRow(0);
  QApplication::processEvents();

  const QImage seen = list.viewport()->grab().toImage();
  const auto firstInk = [&](int row, const QColor& ground) {
    const QRect place = list.visualItemRect(list.item(row));
    for (int x = place.left(); x < place.right(); ++x) {
      for (int y = place.top() + 2; y < place.bottom() - 1; ++y) {
        if (contrast(seen.pixelColor(x, y), ground) > 2.0) {
          return x - place.left();
        }
      }
    }
    return -1;
  };

  EXPECT_GE(firstInk(0, t.accent), kSpace);
  EXPECT_GE(firstInk(1, t.surface), kSpace);
  EXPECT_LE(firstInk(1, t.surface), 2 * kSpace);
  EXPECT_EQ(seen.pixelColor(2, list.visualItemRect(list.item(0)).center().y()), t.accent);
}

struct SliderLook {
  QColor disc;    // at the middle of the handle
  QColor filled;  // the groove before it
  QColor empty;   // and after it
  QImage handle;
};

SliderLook lookOf(QSlider& slider) {
  QStyleOptionSlider option;
  option.initFrom(&slider);
  option.orientation = slider.orientation();
  option.minimum = slider.minimum();
  option.maximum = slider.maximum();
  option.sliderPosition = option.sliderValue = slider.value();
  option.upsideDown = slider.orientation() == Qt::Vertical;
  option.subControls = QStyle::SC_All;
  const QRect handle =
      slider.style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider);
  const QImage seen = slider.grab().toImage();
  const bool level = slider.orientation() == Qt::Horizontal;
  const QPoint middle = handle.center();
  const QPoint along = level ? QPoint(handle.width(), 0) : QPoint(0, -handle.height());
  return {seen.pixelColor(middle), seen.pixelColor(middle - along), seen.pixelColor(middle + along),
          seen.copy(handle)};
}

TEST_P(ThemeContrast, ASliderShowsItsPositionAndFocus) {
  const Theme& t = theme(GetParam());
  applyTheme(*qApp, t);
  for (const Qt::Orientation orientation : {Qt::Horizontal, Qt::Vertical}) {
    QWidget window;
    QSlider slider(orientation, &window);
    slider.setGeometry(orientation == Qt::Horizontal ? QRect(0, 0, 200, 24) : QRect(0, 0, 24, 200));
    slider.setValue(50);
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    slider.clearFocus();

    const SliderLook rest = lookOf(slider);
    slider.setFocus();
    ASSERT_TRUE(slider.hasFocus());
    const SliderLook focused = lookOf(slider);
    slider.setEnabled(false);
    const SliderLook off = lookOf(slider);

    EXPECT_GE(contrast(rest.disc, rest.empty), kMark) << orientation;
    EXPECT_GE(contrast(rest.disc, t.window), kMark) << orientation;
    EXPECT_GE(contrast(rest.disc, t.surface), kMark) << orientation;
    EXPECT_GE(contrast(rest.filled, rest.empty), kMark) << orientation;
    EXPECT_EQ(focused.handle.size(), rest.handle.size()) << "it moves when the keys come";
    int ring = 0;
    for (int x = 0; x < focused.handle.width(); ++x) {
      const int y = focused.handle.height() / 2;
      ring += focused.handle.pixelColor(x, y) == t.text && rest.handle.pixelColor(x, y) != t.text ? 1 : 0;
    }
    EXPECT_GE(ring, 2) << orientation << ": both sides of the ring";
    EXPECT_NE(off.disc, rest.disc) << orientation;
    EXPECT_NE(off.filled, rest.filled) << orientation;
  }
}

TEST(Icons, EveryIconOfTheWindowExistsInBothThemes) {
  for (const char* name : {"record", "stop", "replay", "release", "front", "side", "top", "fit", "lattice",
                           "wireframe", "picture", "theme", "open", "help", "play", "pause", "close"}) {
    for (const ThemeKind kind : {ThemeKind::kLight, ThemeKind::kDark}) {
      const QImage picture = icon(QLatin1String(name), theme(kind)).pixmap(20, 20).toImage();
      int drawn = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
          drawn += picture.pixelColor(x, y).alpha() > 128 ? 1 : 0;
        }
      }
      EXPECT_GT(drawn, 10) << name;
    }
  }
}

TEST(Icons, EveryDrawingOfTheFolderIsInTheProgram) {
  const QStringList drawings =
      QDir(QStringLiteral(TORSIO_SOURCE_DIR "/assets/icons")).entryList({QStringLiteral("*.svg")});

  const QStringList compiled = QDir(QStringLiteral(":/torsio/icons")).entryList();

  ASSERT_FALSE(drawings.isEmpty());
  EXPECT_EQ(compiled, drawings) << "list it in app/gui/widgets/CMakeLists.txt";
}

// The same text in a 4K window: no line exceeds a readable length.
TEST(Sentence, WrapsAtAHundredAndTwentyCharacters) {
  QLabel& words = *sentence(nullptr);
  const std::unique_ptr<QLabel> owned(&words);
  words.setText(QStringLiteral("one run decides nothing ").repeated(20));
  const int widest = 120 * words.fontMetrics().averageCharWidth();
  const int least = words.minimumSizeHint().width();
  for (const int width : {300, 1600, 3600, 500}) {
    words.resize(width, words.heightForWidth(width));
    words.show();
    QApplication::processEvents();

    const int used = words.contentsRect().width();
    EXPECT_EQ(used, std::min(width, widest));
    EXPECT_GE(
        words.height(),
        words.fontMetrics().boundingRect(QRect(0, 0, used, 9999), Qt::TextWordWrap, words.text()).height());
    EXPECT_EQ(words.minimumSizeHint().width(), least) << "a wide window could never be narrow again";
  }
}

// Its right edge aligns with other cards; only a scroll bar takes space from it.
TEST(ScrollGap, ExistsWhileThereIsAScrollBar) {
  QScrollArea area;
  area.setFrameShape(QFrame::NoFrame);
  area.setWidgetResizable(true);
  auto* ground = new QWidget;
  auto* column = new QVBoxLayout(ground);
  column->setContentsMargins(0, 0, 2 * kSpace, 0);
  keepOffScrollBar(area, *column);
  auto* card = new QWidget;
  card->setMinimumHeight(300);
  column->addWidget(card);
  area.setWidget(ground);
  area.resize(200, 400);
  area.show();
  QApplication::processEvents();
  EXPECT_EQ(card->mapTo(&area, card->rect().bottomRight()).x(), area.rect().right());

  area.resize(200, 200);
  QApplication::processEvents();
  ASSERT_TRUE(area.verticalScrollBar()->isVisible());
  const QPoint bar = area.verticalScrollBar()->mapTo(&area, QPoint(0, 0));
  EXPECT_EQ(card->mapTo(&area, card->rect().topRight()).x() + 1 + kSpace, bar.x());

  area.resize(200, 400);
  QApplication::processEvents();
  EXPECT_EQ(card->mapTo(&area, card->rect().bottomRight()).x(), area.rect().right());
}

TEST(LevelBar, SaysInWordsThatTheLimitIsReached) {
  LevelBar bar(QStringLiteral("Force"), QStringLiteral("N"), 2);
  bar.setLimit(3.3);

  bar.setValue(3.2);
  EXPECT_FALSE(bar.overLimit());
  EXPECT_FALSE(bar.accessibleDescription().contains(QStringLiteral("limit")));

  bar.setValue(3.3);
  EXPECT_TRUE(bar.overLimit());
  EXPECT_TRUE(bar.accessibleDescription().contains(QStringLiteral("limit")));
}

}  // namespace
}  // namespace torsio::gui
