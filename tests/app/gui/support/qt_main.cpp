// SPDX-License-Identifier: GPL-3.0-or-later
// Widgets need an application object; the tests use the platform without a display.
#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/outputs/charts/typeface.h"

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  QApplication application(argc, argv);
  torsio::useTypeface(application);
  QApplication::setOrganizationName("torsio-tests");
  // Separate settings: a parallel test would otherwise delete them.
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
