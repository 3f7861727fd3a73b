// SPDX-License-Identifier: GPL-3.0-or-later
// QtSql loads its drivers through the application object, which the library does not create.
#include <QCoreApplication>
#include <gtest/gtest.h>

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
