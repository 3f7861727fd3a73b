// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>

#ifdef __linux__
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#endif

#include <gtest/gtest.h>

#include "sim/core/clock.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/file_lock.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

TEST(Digest, GivesTheHashesOfBlake2bWith256Bits) {
  Digest nothing;
  Digest abc;
  abc.update("a");
  abc.update("bc");

  // hashlib.blake2b(digest_size=32) of Python for b"" and b"abc".
  EXPECT_EQ(nothing.hex(), "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8");
  EXPECT_EQ(abc.hex(), "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
}

TEST(Digest, TakesNumbersAsLittleEndianBytes) {
  Digest digest;
  digest.update(std::int64_t{-2});
  digest.update(1.5);
  digest.update("x");

  // hashlib.blake2b(struct.pack("<qd", -2, 1.5) + b"x", digest_size=32)
  EXPECT_EQ(digest.hex(), "f13061cc10033a92f03b082cefb38474fc4162a4504f4d043ff8c45acb99a685");
}

TEST(Digest, CanBeReadBeforeTheEnd) {
  Digest digest;
  digest.update("a");
  const std::string first = digest.hex();
  digest.update("bc");

  EXPECT_NE(first, digest.hex());
  EXPECT_EQ(digest.hex(), "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
}

class FileIo : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / (std::string("torsio_file_io_") +
                                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    ensureFolder(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  static ErrorCode refusal(const std::function<void()>& action) {
    try {
      action();
    } catch (const Error& error) {
      EXPECT_FALSE(error.remedy().empty());
      EXPECT_FALSE(error.where().empty());
      return error.code();
    }
    return ErrorCode::kInternal;
  }
  std::size_t filesLeft() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder)) {
      ++count;
    }
    return count;
  }

  fs::path folder;
};

TEST_F(FileIo, ReadsBackWhatItWroteByteForByte) {
  const std::string bytes("\0\r\n\xff text", 9);

  writeFileAtomically(folder / "a", bytes);

  EXPECT_EQ(readFile(folder / "a"), bytes);
  EXPECT_EQ(filesLeft(), 1U);
}

TEST_F(FileIo, ReadsAnEmptyFile) {
  writeFileAtomically(folder / "empty", "");
  EXPECT_EQ(readFile(folder / "empty"), "");
}

TEST_F(FileIo, LeavesTheOldFileWhenTheWriterThrows) {
  writeFileAtomically(folder / "a", "old");

  EXPECT_THROW(writeFileAtomically(folder / "a",
                                   [](std::ostream& out) {
                                     out << "half";
                                     throw std::runtime_error("broken");
                                   }),
               std::runtime_error);

  EXPECT_EQ(readFile(folder / "a"), "old");
  EXPECT_EQ(filesLeft(), 1U);
}

TEST_F(FileIo, IsWrittenByOneProgramAtATime) {
  writeFileAtomically(folder / "a", "old");
  {
    const PartFile other(folder / "a");
    std::ofstream(other.path()) << "half";

    try {
      writeFileAtomically(folder / "a", "new");
      FAIL() << "both wrote the same temporary file";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kFileUnwritable);
      EXPECT_EQ(error.happened(), "another program is writing this file now");
    }
    EXPECT_EQ(readFile(other.path()), "half");
  }
  EXPECT_EQ(readFile(folder / "a"), "old");
  EXPECT_EQ(filesLeft(), 1U);

  std::ofstream(folder / "a.part") << "of a program that was killed";
  std::ofstream(folder / "a.part.lock").close();
  writeFileAtomically(folder / "a", "new");
  EXPECT_EQ(readFile(folder / "a"), "new");
  EXPECT_EQ(filesLeft(), 1U);
}

#ifdef __linux__
TEST_F(FileIo, NeverReplacesSomethingThatIsNoFile) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  ensureFolder(folder / "set");

  for (const char* name : {"pipe", "set"}) {
    EXPECT_EQ(refusal([&] { writeFileAtomically(folder / name, "x"); }), ErrorCode::kFileUnwritable) << name;
  }

  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
  EXPECT_EQ(filesLeft(), 2U);
}
#endif

TEST_F(FileIo, SaysWhatIsWrongWithAFile) {
  EXPECT_EQ(refusal([this] { (void)readFile(folder / "nothing"); }), ErrorCode::kFileMissing);
  EXPECT_EQ(refusal([this] { (void)readFile(folder); }), ErrorCode::kFileUnreadable);
  EXPECT_EQ(refusal([this] { writeFileAtomically(folder / "no" / "such" / "folder", "x"); }),
            ErrorCode::kFileUnwritable);
  writeFileAtomically(folder / "file", "x");
  EXPECT_EQ(refusal([this] { ensureFolder(folder / "file" / "below"); }), ErrorCode::kFileUnwritable);
}

TEST(Error, SaysWhereWhatAndWhatToDo) {
  const Error error(ErrorCode::kBadMesh, Text::verbatim("vertex 3 is not a number"),
                    Text::verbatim("arm.obj"), Text::verbatim("Repair the mesh"));

  EXPECT_STREQ(error.what(), "arm.obj: vertex 3 is not a number. Repair the mesh");
  EXPECT_EQ(static_cast<int>(error.code()), 6);
}

TEST(Contracts, ThrowWithTheConditionAndTheLine) {
  const auto broken = [] { TORSIO_EXPECTS(1 + 1 == 3); };
  try {
    broken();
    FAIL() << "accepted";
  } catch (const ContractError& error) {
    EXPECT_NE(std::string(error.what()).find("1 + 1 == 3"), std::string::npos);
  }
}

TEST(ManualClock, MovesOnlyWhenTold) {
  ManualClock clock(5);
  EXPECT_EQ(clock.now_us(), 5);
  clock.advance_us(1000);
  EXPECT_EQ(clock.now_us(), 1005);
}

TEST(MonotonicClock, NeverGoesBack) {
  const MonotonicClock clock;
  std::int64_t before_us = clock.now_us();
  for (int i = 0; i < 1'000; ++i) {
    const std::int64_t now_us = clock.now_us();
    ASSERT_GE(now_us, before_us);
    before_us = now_us;
  }
}

#ifdef __linux__
TEST(PrivateFiles, DisablesCoreDumpsAndMemoryReads) {
  const auto child = [] {
    disableCoreDumps();
    rlimit core{.rlim_cur = 1, .rlim_max = 1};
    getrlimit(RLIMIT_CORE, &core);
    std::_Exit(core.rlim_max == 0 && prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) == 0 ? 0 : 1);
  };
  EXPECT_EXIT(child(), ::testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace torsio
