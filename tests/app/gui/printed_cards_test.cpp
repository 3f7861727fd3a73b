// SPDX-License-Identifier: GPL-3.0-or-later
// What is printed once must be whole: read back from the pages.
#include "app/gui/administrator/base/printed_cards.h"

#include <filesystem>

#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/access/first_run.h"

namespace torsio::gui {
namespace {

/// The words of a PDF, without any blanks.
QString wordsOfPdf(const std::filesystem::path& file) {
  QProcess reader;
  reader.start(QStringLiteral("pdftotext"), {QString::fromStdString(file.string()), QStringLiteral("-")});
  EXPECT_TRUE(reader.waitForFinished()) << "pdftotext of poppler-utils";
  // "ff" is one sign in some fonts.
  return QString::fromUtf8(reader.readAllStandardOutput())
      .normalized(QString::NormalizationForm_KC)
      .remove(QRegularExpression(QStringLiteral("\\s")));
}

TEST(PrintedCards, EveryStartPasswordAndNameIsWhole) {
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

}  // namespace
}  // namespace torsio::gui
