// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

namespace torsio::testing {

/// Copies shipped data files, except organs, to a test's own folder, to change one of them.
class CopiedSceneFiles : public ::testing::Test {
 protected:
  /// `names`: relative to the folder of the shipped data.
  explicit CopiedSceneFiles(std::initializer_list<const char*> names) {
    namespace fs = std::filesystem;
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    assets_ = fs::path(::testing::TempDir()) / (std::string(test->test_suite_name()) + "_" + test->name());
    fs::remove_all(assets_);
    for (const char* name : names) {
      fs::create_directories((assets_ / name).parent_path());
      fs::copy_file(fs::path(TORSIO_SOURCE_DIR) / "assets" / name, assets_ / name);
    }
  }
  ~CopiedSceneFiles() override { std::filesystem::remove_all(assets_); }

  std::filesystem::path assets_;
};

}  // namespace torsio::testing
