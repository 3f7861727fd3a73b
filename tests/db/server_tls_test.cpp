// SPDX-License-Identifier: GPL-3.0-or-later
// TLS parameters and services of an address reach libpq.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "db/connection/locator.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

/// The server of the suite, with a certificate for "localhost" (tests/support/start-postgres.sh).
class ServerTlsTest : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (!onPostgresql()) {
      GTEST_SKIP() << "an SQLite file has no TLS";
    }
    if (IsSkipped()) {
      return;
    }
    server_ = parseLocator(locator());
    authority_ = fs::temp_directory_path() / ("torsio-postgres-" + std::to_string(server_.port)) / "ca.crt";
    if (!fs::exists(authority_)) {
      GTEST_SKIP() << "the server was not started by tests/support/start-postgres.sh";
    }
  }

  [[nodiscard]] std::string with(const std::string& host,
                                 const std::vector<ServerParameter>& parameters) const {
    Locator server = server_;
    server.host = host;
    server.parameters = parameters;
    return addressOf(server);
  }
  /// Encryption of this connection as the server sees it; "ssl|application_name".
  [[nodiscard]] static std::string seen(const std::string& locator) {
    Connection connection = openDatabase(locator, OpenMode::kReadOnly);
    Statement row = connection.prepare(
        "SELECT s.ssl::text || '|' || a.application_name FROM pg_stat_ssl s JOIN pg_stat_activity a"
        " ON a.pid = s.pid WHERE s.pid = pg_backend_pid()");
    row.execute();
    return row.step() ? row.text(0) : "";
  }
  [[nodiscard]] static std::string refusal(const std::string& locator) {
    return refusalFrom([&] { (void)openDatabase(locator, OpenMode::kReadOnly); }).text;
  }

  Locator server_;
  fs::path authority_;
};

TEST_F(ServerTlsTest, VerifiesTheServerInFullAndRefusesAnotherName) {
  const std::string root = authority_.string();

  EXPECT_EQ(seen(with("localhost", {{"sslmode", "verify-full"}, {"sslrootcert", root}})), "true|torsio");
  EXPECT_EQ(seen(with("127.0.0.1", {{"sslmode", "verify-ca"}, {"sslrootcert", root}})), "true|torsio");
  const std::string wrong = refusal(with("127.0.0.1", {{"sslmode", "verify-full"}, {"sslrootcert", root}}));
  EXPECT_NE(wrong.find("127.0.0.1"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("localhost"), std::string::npos) << wrong;
}

TEST_F(ServerTlsTest, RejectsAnUnrelatedAuthority) {
  const TemporaryFolder folder;
  const fs::path other = folder.path() / "other.crt";
  ASSERT_EQ(std::system(("openssl req -x509 -newkey rsa:2048 -nodes -days 1 -subj /CN=other -keyout " +
                         (folder.path() / "other.key").string() + " -out " + other.string() + " 2>/dev/null")
                            .c_str()),
            0);

  const std::string wrong =
      refusal(with("localhost", {{"sslmode", "verify-full"}, {"sslrootcert", other.string()}}));

  EXPECT_NE(wrong.find("certificate"), std::string::npos) << wrong;
  const std::string none =
      refusal(with("localhost", {{"sslmode", "verify-full"}, {"sslrootcert", "/nowhere/ca.crt"}}));
  EXPECT_NE(none.find("/nowhere/ca.crt"), std::string::npos) << none;
}

TEST_F(ServerTlsTest, GoesWithoutTlsOnlyOnRequest) {
  EXPECT_EQ(seen(with("127.0.0.1", {{"sslmode", "disable"}, {"application_name", "room 7 'left'"}})),
            "false|room 7 'left'");
  EXPECT_EQ(seen(with("127.0.0.1", {{"sslmode", "require"}})), "true|torsio");
}

TEST_F(ServerTlsTest, TakesEverythingFromAServiceFileAndThePasswordFromItsOwnFile) {
  const TemporaryFolder folder;
  const fs::path service = folder.path() / "service.conf";
  const fs::path passwords = folder.path() / "pgpass";
  std::ofstream(service) << "[ward]\nhost=localhost\nport=" << server_.port << "\ndbname=" << server_.database
                         << "\nuser=" << server_.user
                         << "\nsslmode=verify-full\nsslrootcert=" << authority_.string()
                         << "\napplication_name=from the file\n";
  std::ofstream(passwords) << "*:*:*:*:" << server_.password << "\n";
  fs::permissions(passwords, fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_EQ(setenv("PGSERVICEFILE", service.c_str(), 1), 0);

  EXPECT_EQ(seen("postgresql:///?service=ward&passfile=" + passwords.string()), "true|from the file");

  const std::string none = refusal("postgresql:///?service=nobody");
  EXPECT_NE(none.find("nobody"), std::string::npos) << none;
  unsetenv("PGSERVICEFILE");
}

}  // namespace
}  // namespace torsio
