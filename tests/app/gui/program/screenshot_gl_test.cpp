// SPDX-License-Identifier: GPL-3.0-or-later
// The real program draws the real scene, on a virtual display with a software renderer.
#include <set>

#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace {

constexpr int kPatience_ms = 200'000;  // a busy machine draws slowly

class Screenshot : public ::testing::Test {
 protected:
  QTemporaryDir folder_;
  QString said_;  // standard error of the last run

  void SetUp() override {
    if (QStandardPaths::findExecutable(QStringLiteral("xvfb-run")).isEmpty()) {
      GTEST_SKIP() << "xvfb-run is not installed";
    }
  }

  QImage shot(const QString& name, const QStringList& options, int exitCode = 0) {
    const QString file = folder_.filePath(name);
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
    environment.insert(QStringLiteral("LIBGL_ALWAYS_SOFTWARE"), QStringLiteral("1"));
    environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), folder_.path());
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral("xvfb-run"),
                  QStringList{QStringLiteral("-a"), QStringLiteral("-s"),
                              QStringLiteral("-screen 0 1600x1000x24 +extension GLX -noreset"),
                              QStringLiteral(TORSIO_PROGRAM), QStringLiteral("--screenshot"), file} +
                      options);
    EXPECT_TRUE(process.waitForFinished(kPatience_ms));
    said_ = QString::fromLocal8Bit(process.readAllStandardError());
    EXPECT_EQ(process.exitCode(), exitCode) << said_.toStdString();
    return QImage(file);
  }

  static std::size_t colours(const QImage& picture, const QRect& where) {
    std::set<QRgb> seen;
    for (int y = where.top(); y <= where.bottom(); ++y) {
      for (int x = where.left(); x <= where.right(); ++x) {
        seen.insert(picture.pixel(x, y));
      }
    }
    return seen.size();
  }

  /// Counts reddish pixels, which are tissue. The backdrop is bluish, the instrument grey.
  static int tissue(const QImage& picture, const QRect& where) {
    int count = 0;
    for (int y = where.top(); y <= where.bottom(); ++y) {
      for (int x = where.left(); x <= where.right(); ++x) {
        const QColor c = picture.pixelColor(x, y);
        count += c.red() > c.blue() + 25 ? 1 : 0;
      }
    }
    return count;
  }

  static int different(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        const QColor p = a.pixelColor(x, y);
        const QColor q = b.pixelColor(x, y);
        count += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) > 40 ? 1 : 0;
      }
    }
    return count;
  }
};

TEST_F(Screenshot, ShowsALitOrganInTheMiddleAndAVisibleTwist) {
  const QStringList options{QStringLiteral("--organ"),      QStringLiteral("stomach"),
                            QStringLiteral("--quality"),    QStringLiteral("fast"),
                            QStringLiteral("--size"),       QStringLiteral("1000x700"),
                            QStringLiteral("--scene-only"), QStringLiteral("--angle")};

  const QImage rest = shot(QStringLiteral("rest.png"), options + QStringList{QStringLiteral("0")});
  const QImage twisted = shot(QStringLiteral("twisted.png"), options + QStringList{QStringLiteral("-90")});

  ASSERT_FALSE(rest.isNull());
  ASSERT_EQ(rest.size(), twisted.size());
  const QRect whole = rest.rect();
  const QRect middle(whole.width() / 4, whole.height() / 4, whole.width() / 2, whole.height() / 2);
  EXPECT_GT(colours(rest, middle), 2000U);  // shading and mottling, not a flat silhouette
  EXPECT_GT(tissue(rest, middle), middle.width() * middle.height() / 8);
  EXPECT_LT(tissue(rest, QRect(0, 0, whole.width() / 10, whole.height())), 50);
  EXPECT_GT(different(rest, twisted), whole.width() * whole.height() / 100);
}

TEST_F(Screenshot, TheClothExtendsAcrossAVeryWideView) {
  const QImage wide = shot(QStringLiteral("wide.png"),
                           {QStringLiteral("--organ"), QStringLiteral("forearm"), QStringLiteral("--quality"),
                            QStringLiteral("fast"), QStringLiteral("--size"), QStringLiteral("1500x450"),
                            QStringLiteral("--scene-only"), QStringLiteral("--angle"), QStringLiteral("0")});

  ASSERT_FALSE(wide.isNull());
  int streaks = 0;  // rows whose first pixels are identical
  for (int y = 0; y < wide.height(); ++y) {
    streaks += colours(wide, QRect(0, y, wide.width() / 20, 1)) == 1 ? 1 : 0;
  }
  EXPECT_LT(streaks, wide.height() / 20);
}

TEST_F(Screenshot, ShowsAnOrganFromSixSidesAtRestAndTurned) {
  const QImage sheet =
      shot(QStringLiteral("sides.png"),
           {QStringLiteral("--organ"), QStringLiteral("intestine"), QStringLiteral("--quality"),
            QStringLiteral("fast"), QStringLiteral("--size"), QStringLiteral("900x700"),
            QStringLiteral("--six-sides"), QStringLiteral("--angle"), QStringLiteral("180")});

  ASSERT_FALSE(sheet.isNull());
  const QSize cell(sheet.width() / 6, sheet.height() / 2);
  for (int column = 0; column < 6; ++column) {
    const QRect above(QPoint(column * cell.width(), 0), cell);
    const QRect below(QPoint(column * cell.width(), cell.height()), cell);
    EXPECT_GT(tissue(sheet, above), 500) << column;
    EXPECT_GT(tissue(sheet, below), 500) << column;
    EXPECT_GT(different(sheet.copy(above), sheet.copy(below)), 300) << column;
  }
}

TEST_F(Screenshot, AnAngleAgainstTheTaskIsRefusedInsteadOfDrawnAtRest) {
  const QStringList options{QStringLiteral("--organ"), QStringLiteral("stomach"), QStringLiteral("--angle"),
                            QStringLiteral("90")};  // the tasks of the stomach turn to negative angles

  const QImage picture =
      shot(QStringLiteral("none.png"), options, static_cast<int>(torsio::ErrorCode::kBadParameter));

  EXPECT_TRUE(picture.isNull());
  EXPECT_TRUE(said_.contains(QLatin1String("this task turns the other way"))) << said_.toStdString();
}

TEST_F(Screenshot, TargetGhostAndMarkersAppearOnlyOnRequest) {
  const QStringList options{
      QStringLiteral("--organ"),      QStringLiteral("forearm"), QStringLiteral("--quality"),
      QStringLiteral("fast"),         QStringLiteral("--size"),  QStringLiteral("640x480"),
      QStringLiteral("--scene-only"), QStringLiteral("--angle"), QStringLiteral("0")};

  const QImage plain = shot(QStringLiteral("plain.png"), options);
  const QImage again = shot(QStringLiteral("again.png"), options);
  const QImage ghost = shot(QStringLiteral("ghost.png"), options + QStringList{QStringLiteral("--ghost")});
  const QImage markers =
      shot(QStringLiteral("markers.png"), options + QStringList{QStringLiteral("--markers")});

  ASSERT_FALSE(plain.isNull());
  EXPECT_EQ(different(plain, again), 0);
  EXPECT_GT(different(plain, ghost), 500);   // the hand's target pose is visible, too
  EXPECT_GT(different(plain, markers), 20);  // ten points of a few pixels, half of them behind the arm
}

TEST_F(Screenshot, DrawsTissueWithItsOwnShadersAtTheFineLevel) {
  for (const char* organ : {"stomach", "forearm", "intestine"}) {
    const QStringList options{QStringLiteral("--organ"),      QLatin1String(organ),
                              QStringLiteral("--size"),       QStringLiteral("640x480"),
                              QStringLiteral("--scene-only"), QStringLiteral("--quality")};

    const QImage fine = shot(QStringLiteral("fine.png"), options + QStringList{QStringLiteral("fine")});
    const QString complaints = said_;
    const QImage fast = shot(QStringLiteral("fast.png"), options + QStringList{QStringLiteral("fast")});

    EXPECT_FALSE(complaints.contains(QLatin1String("shader"), Qt::CaseInsensitive))
        << complaints.toStdString();
    ASSERT_EQ(fine.size(), fast.size());
    EXPECT_GT(different(fine, fast), 500) << organ;
    const QRect middle(fine.width() / 4, fine.height() / 4, fine.width() / 2, fine.height() / 2);
    EXPECT_GT(tissue(fine, middle), middle.width() * middle.height() / 16) << organ;  // not black or white
  }
}

TEST_F(Screenshot, TheStressMapHasTheColoursOfItsLegendAtEveryLevel) {
  constexpr int kTolerance = 6;  // of 255: rounding of the conversion to linear light and back
  for (const char* quality : {"fast", "fine"}) {
    const QImage rest = shot(
        QStringLiteral("stress.png"),
        {QStringLiteral("--organ"), QStringLiteral("stomach"), QStringLiteral("--shear"),
         QStringLiteral("--angle"), QStringLiteral("0"), QStringLiteral("--size"), QStringLiteral("640x480"),
         QStringLiteral("--scene-only"), QStringLiteral("--quality"), QLatin1String(quality)});

    // Without twist there is no stress: the darkest blue of cividis, (0, 0.135, 0.305), where the tissue
    // faces the viewer, and the same hue, darker, elsewhere.
    int whole = 0;
    int organ = 0;
    int other = 0;  // edges of the surroundings, and smoothed ones of the fast level
    for (int y = 0; y < rest.height(); ++y) {
      for (int x = 0; x < rest.width(); ++x) {
        const QColor c = rest.pixelColor(x, y);
        // The band of the grasp is dark as well, but green.
        if (c.red() > kTolerance || c.blue() < 40 || c.green() > 45) {
          continue;
        }
        ++organ;
        whole += std::abs(c.green() - 34) <= kTolerance && std::abs(c.blue() - 78) <= kTolerance ? 1 : 0;
        other += std::abs(c.green() - c.blue() * 34.0 / 78.0) <= kTolerance ? 0 : 1;
      }
    }
    EXPECT_GT(organ, rest.width() * rest.height() / 20) << quality;
    EXPECT_GT(whole, organ / 2) << quality;
    EXPECT_LT(other, organ / 200) << quality;
  }
}

TEST_F(Screenshot, AFilmStripShowsTheOrganIncreasinglyTwisted) {
  const QImage strip =
      shot(QStringLiteral("strip.png"),
           {QStringLiteral("--organ"), QStringLiteral("stomach"), QStringLiteral("--angle"),
            QStringLiteral("-90"), QStringLiteral("--film-strip"), QStringLiteral("--quality"),
            QStringLiteral("fast"), QStringLiteral("--size"), QStringLiteral("640x480")});

  // 0, -30, -60 and -90 degrees in one row.
  ASSERT_FALSE(strip.isNull());
  const int cell = strip.width() / 4;
  const QRect first(0, 0, cell, strip.height());
  EXPECT_GT(tissue(strip, first), 1000);
  for (int frame = 1; frame < 4; ++frame) {
    const QImage before = strip.copy(first.translated((frame - 1) * cell, 0));
    EXPECT_GT(different(before, strip.copy(first.translated(frame * cell, 0))), 500) << frame;
  }
}

TEST_F(Screenshot, ShowsTheWholeWindowWithItsReadouts) {
  const QImage window =
      shot(QStringLiteral("window.png"), {QStringLiteral("--organ"), QStringLiteral("forearm"),
                                          QStringLiteral("--theme"), QStringLiteral("dark")});

  EXPECT_EQ(window.size(), QSize(1280, 800));
  EXPECT_GT(colours(window, window.rect()), 5000U);
  // The panel at the right is dark with light text.
  int bright = 0;
  for (int y = 100; y < 700; ++y) {
    for (int x = 1000; x < 1240; ++x) {
      bright += qGray(window.pixel(x, y)) > 180 ? 1 : 0;
    }
  }
  EXPECT_GT(bright, 500);
  EXPECT_LT(bright, 240 * 600 / 4);
}

}  // namespace
