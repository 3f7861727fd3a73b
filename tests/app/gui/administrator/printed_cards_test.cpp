// SPDX-License-Identifier: GPL-3.0-or-later
// What is printed only once must be complete: read back from the pages.
#include "app/gui/administrator/base/printed_cards.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/services/access/first_run.h"
#include "app/services/access/qr_code.h"

namespace torsio::gui {
namespace {

/// Returns the text of a PDF, without blanks.
QString wordsOfPdf(const std::filesystem::path& file) {
  QProcess reader;
  reader.start(QStringLiteral("pdftotext"), {QString::fromStdString(file.string()), QStringLiteral("-")});
  EXPECT_TRUE(reader.waitForFinished()) << "pdftotext of poppler-utils";
  // "ff" is a ligature in some fonts.
  return QString::fromUtf8(reader.readAllStandardOutput())
      .normalized(QString::NormalizationForm_KC)
      .remove(QRegularExpression(QStringLiteral("\\s")));
}

TEST(PrintedCards, EveryStartPasswordAndNameIsComplete) {
  QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "cards.pdf";
  std::vector<StartAccount> accounts;
  for (int i = 0; i < 80; ++i) {
    accounts.push_back(
        {"t-" + std::to_string(i), "trainee", "T-" + std::to_string(i), randomStartPassword(),
         "Dr. Maximiliane Alexandra Wolkenstein-Trostburg, Geburtsname M\u00fcller " + std::to_string(i)});
  }
  accounts[3].startPassword = "WWWWW-MMMMM-WWWWW-MMMMM";  // the widest letters

  writeAccountCards(accounts, "University Hospital, Centre for Surgical Skills and Simulation", file);

  const QString words = wordsOfPdf(file);
  for (const StartAccount& account : accounts) {
    EXPECT_TRUE(words.contains(QString::fromStdString(account.startPassword))) << account.startPassword;
    const QString name = QString::fromStdString(account.personName).remove(u' ');
    EXPECT_TRUE(words.contains(name)) << account.personName;
  }
  EXPECT_FALSE(words.contains(QChar(0x2026)));
}

TEST(PrintedCards, AHalfOfAStartPasswordSaysSoOnTheCardAndItsEnvelope) {
  QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "cards.pdf";
  StartAccount first{.login = "r-01",
                     .personCode = "R-01",
                     .startPassword = "abcde-fghij",
                     .personName = "Chief One",
                     .part = PasswordPart::kFirstHalf};
  StartAccount second = first;
  second.startPassword = "kmnpq-rstuv";
  second.part = PasswordPart::kSecondHalf;
  second.askedBy = "office";

  writeAccountCards({first, second}, "Hospital A", file);

  const QString words = wordsOfPdf(file);
  EXPECT_EQ(words.count(QStringLiteral("ChiefOne")), 2) << words.toStdString();
  EXPECT_TRUE(words.contains(QStringLiteral("R-01.FirsthalfofyourpasswordforTorsio.Foryoualone.")));
  EXPECT_TRUE(words.contains(QStringLiteral("Firsthalf.Thesecondhalfcomesfromanotheradministrator.")));
  EXPECT_TRUE(words.contains(QStringLiteral("R-01.SecondhalfofyourpasswordforTorsio.Foryoualone.")));
  EXPECT_TRUE(words.contains(QStringLiteral("Secondhalf.Thefirsthalfcomesfromoffice.")));
}

TEST(PrintedCards, ShowTheProgramsNameIfTheCentreHasNone) {
  QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "cards.pdf";
  for (const std::string& centre : {std::string("Hospital A"), std::string()}) {
    writeKioskCards({{"R-1", "rater", "1234567890123456"}}, centre, file);
    EXPECT_TRUE(
        wordsOfPdf(file).startsWith(centre.empty() ? QStringLiteral("Torsio") : QStringLiteral("HospitalA")));
  }
}

TEST(PrintedCards, AnInvitationContainsTheWholeLinkOrTheCode) {
  QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "invitations.pdf";
  const std::string link =
      "https://skills-laboratory.university-hospital.example.org/desk/join#2.abcde-fghjk-mnpqr-stuvw";

  writeInvitationCards({{.personCode = "CH-100", .login = "ch-100", .link = link},
                        {.personCode = "CH-101", .login = "ch-101", .code = "wxyzw-mmmmm"}},
                       "University Hospital", file);

  const QString words = wordsOfPdf(file);
  EXPECT_TRUE(words.contains(QString::fromStdString(link))) << words.toStdString();
  EXPECT_TRUE(words.contains(QStringLiteral("wxyzw-mmmmm")));
  EXPECT_EQ(words.count(QStringLiteral("join#")), 1) << "who hands over the code does not know the link";
}

/// Renders the page as printed, at 300 dpi.
QImage pictureOfPdf(const std::filesystem::path& file) {
  const QString name = QString::fromStdString(file.string());
  QProcess drawer;
  drawer.start(QStringLiteral("pdftoppm"),
               {QStringLiteral("-r"), QStringLiteral("300"), QStringLiteral("-gray"),
                QStringLiteral("-singlefile"), name, name});
  EXPECT_TRUE(drawer.waitForFinished()) << "pdftoppm of poppler-utils";
  return QImage(name + QStringLiteral(".pgm"));
}

TEST(PrintedCards, AnInvitationHasItsLinkAsAQrCode) {
  QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "invitations.pdf";
  const std::string link = "https://desk.example.org/join#abcde-fghjk-mnpqr-stuvw";
  writeInvitationCards({{.personCode = "CH-100", .login = "ch-100", .link = link}}, "University Hospital",
                       file);

  const QImage page = pictureOfPdf(file);
  ASSERT_FALSE(page.isNull());
  // The first card, between its lines of text.
  const double mm = page.width() / 210.0;
  const QImage middle = page.copy(QRectF(134.0 * mm, 25.0 * mm, 35.0 * mm, 33.0 * mm).toRect());
  QRect found;
  for (int y = 0; y < middle.height(); ++y) {
    for (int x = 0; x < middle.width(); ++x) {
      if (qGray(middle.pixel(x, y)) < 128) {
        found |= QRect(x, y, 1, 1);
      }
    }
  }
  const auto dark = qrCode(link).dark;
  const auto side = static_cast<double>(dark.size());
  ASSERT_NEAR(found.width(), found.height(), 2.0);
  EXPECT_GT(found.width() / side / mm, 0.5) << "a module of half a millimetre is read from a hand's breadth";
  for (std::size_t row = 0; row < dark.size(); ++row) {
    for (std::size_t column = 0; column < dark.size(); ++column) {
      const int x =
          found.left() + static_cast<int>((static_cast<double>(column) + 0.5) * found.width() / side);
      const int y = found.top() + static_cast<int>((static_cast<double>(row) + 0.5) * found.height() / side);
      ASSERT_EQ(qGray(middle.pixel(x, y)) < 128, dark[row][column]) << row << " " << column;
    }
  }
}

/// Decodes a barcode from its bars like a scanner: nine stripes per character, three of them wide.
std::string readBack(const std::vector<BarcodeStripe>& bars) {
  const std::map<std::string, char> signs{{"000110100", '0'}, {"100100001", '1'}, {"001100001", '2'},
                                          {"101100000", '3'}, {"000110001", '4'}, {"100110000", '5'},
                                          {"001110000", '6'}, {"000100101", '7'}, {"100100100", '8'},
                                          {"001100100", '9'}, {"010010100", '*'}};
  std::string text;
  for (std::size_t first = 0; first + 5 <= bars.size(); first += 5) {
    std::string wide;
    for (std::size_t bar = first; bar < first + 5; ++bar) {
      wide += bars[bar].width > 1.5 ? '1' : '0';
      if (bar + 1 < first + 5) {
        const double gap = bars[bar + 1].left - bars[bar].left - bars[bar].width;
        wide += gap > 1.5 ? '1' : '0';
      }
    }
    const auto sign = signs.find(wide);
    text += sign == signs.end() ? '?' : sign->second;
  }
  return text;
}

TEST(Barcode, IsDecodedWithItsStartAndStopCharacters) {
  const std::string digits = "12345678909876543210";

  const std::vector<BarcodeStripe> bars = code39(digits);

  EXPECT_EQ(readBack(bars), "*" + digits + "*");
  EXPECT_DOUBLE_EQ(bars.back().left + bars.back().width, code39Width(digits.size()));
}

TEST(PrintedCards, AKioskCardAlsoShowsItsCodeInDigits) {
  QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "kiosk.pdf";

  writeKioskCards({{"T-01", "t-01", "12345678909876543210"}, {"T-02", "t-02", "11112222333344445555"}},
                  "City hospital", file);

  const QString words = wordsOfPdf(file);
  EXPECT_TRUE(words.contains(QStringLiteral("12345678909876543210")));
  EXPECT_TRUE(words.contains(QStringLiteral("11112222333344445555")));
  EXPECT_TRUE(words.contains(QStringLiteral("T-02")));
}

}  // namespace
}  // namespace torsio::gui
