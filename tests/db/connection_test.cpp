// SPDX-License-Identifier: GPL-3.0-or-later

#include "db/connection/connection.h"

#include <cstdlib>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/connection/row_reader.h"
#include "sim/core/error.h"
#include "tests/db/test_database.h"

namespace torsio {

namespace {

class ConnectionTest : public DatabaseTest {
 protected:
  /// Opens a table with every column type of the schema.
  Connection openWithTable() {
    Connection connection = open();
    const std::string blob = onPostgresql() ? "BYTEA" : "BLOB";
    connection.executeVerbatim(
        "CREATE TABLE thing (id TEXT PRIMARY KEY, whole BIGINT, part DOUBLE PRECISION,"
        " flag BOOLEAN, words TEXT, bytes " +
        blob + ", CHECK (whole < 1000000000000000000 OR whole = 9223372036854775807))");
    connection.executeVerbatim("CREATE TABLE other (thing_id TEXT NOT NULL REFERENCES thing (id))");
    return connection;
  }
};

const char* const kInsert =
    "INSERT INTO thing (id, whole, part, flag, words, bytes) VALUES (?, ?, ?, ?, ?, ?)";

TEST_F(ConnectionTest, ReturnsEveryTypeUnchanged) {
  Connection connection = openWithTable();
  const Blob bytes{std::byte{0}, std::byte{0xFF}, std::byte{0x27}, std::byte{0x5C}, std::byte{0}};
  const double third = 1.0 / 3.0;
  const std::string words = "Zürich 手 'quoted' \\ ; -- ? :x";

  connection.execute(kInsert, {"a", std::numeric_limits<std::int64_t>::max(), third, true, words, bytes});

  Statement row = connection.prepare("SELECT whole, part, flag, words, bytes FROM thing WHERE id = ?");
  row.execute({"a"});
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.int64(0), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(row.real(1), third);
  EXPECT_TRUE(row.boolean(2));
  EXPECT_EQ(row.text(3), words);
  EXPECT_EQ(row.blob(4), bytes);
  EXPECT_FALSE(row.step());
}

TEST_F(ConnectionTest, PreservesExtremeDoublesBitForBit) {
  Connection connection = openWithTable();
  const double values[] = {5e-324, std::numeric_limits<double>::max(), -0.1, 0.1 + 0.2, 1e-7, -1.0 / 0x1p60};
  for (const double value : values) {
    connection.execute("DELETE FROM thing");
    connection.execute("INSERT INTO thing (id, part) VALUES (?, ?)", {"a", value});
    Statement row = connection.prepare("SELECT part FROM thing");
    row.execute();
    ASSERT_TRUE(row.step());
    EXPECT_EQ(row.real(0), value);
  }
}

TEST_F(ConnectionTest, ShowsStatementsWithoutValuesOnRequest) {
  ::setenv(kShowStatements, "1", 1);
  Connection connection = openWithTable();
  ::unsetenv(kShowStatements);
  ::testing::internal::CaptureStderr();

  connection.execute(kInsert, {"secret", 1, 1.0, true, "words", Blob{}});

  const std::string told = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(told.find("sql: INSERT INTO thing"), std::string::npos) << told;
  EXPECT_EQ(told.find("secret"), std::string::npos);
}

TEST_F(ConnectionTest, DistinguishesNullFromEmpty) {
  Connection connection = openWithTable();
  connection.execute(kInsert, {"null", nullptr, std::optional<double>(), Value(), Value(), Value()});
  connection.execute(kInsert, {"empty", 0, 0.0, false, "", Blob{}});

  Statement row = connection.prepare("SELECT whole, part, flag, words, bytes FROM thing WHERE id = ?");
  row.execute({"null"});
  ASSERT_TRUE(row.step());
  for (int column = 0; column < 5; ++column) {
    EXPECT_TRUE(row.isNull(column)) << column;
  }
  row.execute({"empty"});
  ASSERT_TRUE(row.step());
  for (int column = 0; column < 5; ++column) {
    EXPECT_FALSE(row.isNull(column)) << column;
  }
}

TEST_F(ConnectionTest, RejectsNonFiniteNumbers) {
  Connection connection = openWithTable();

  EXPECT_THROW(connection.execute("INSERT INTO thing (id, part) VALUES (?, ?)", {"a", std::nan("")}),
               ContractError);
}

TEST_F(ConnectionTest, ReportsTheSameFaultOnBothEngines) {
  Connection connection = openWithTable();
  connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"});

  EXPECT_EQ(faultFrom([&] { connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"}); }),
            DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] { connection.execute("INSERT INTO other (thing_id) VALUES (?)", {"b"}); }),
            DbFault::kForeignKey);
  EXPECT_EQ(faultFrom([&] { connection.execute("INSERT INTO other (thing_id) VALUES (?)", {nullptr}); }),
            DbFault::kNotNull);
  EXPECT_EQ(faultFrom([&] {
              connection.execute("INSERT INTO thing (id, whole) VALUES (?, ?)", {"b", 2000000000000000000});
            }),
            DbFault::kCheck);
  EXPECT_EQ(faultFrom([&] { connection.execute("SELECT nothing FROM nowhere"); }), DbFault::kOther);
}

TEST_F(ConnectionTest, ErrorNamesTheOperationWithoutValues) {
  Connection connection = openWithTable();
  try {
    connection.execute("INSERT INTO other (thing_id) VALUES (?)", {"Anna Bauer"});
    FAIL();
  } catch (const DbError& error) {
    EXPECT_EQ(error.operation(), "INSERT INTO other");
    EXPECT_FALSE(error.retryable());
    EXPECT_EQ(error.code(), ErrorCode::kDatabase);
    EXPECT_EQ(std::string(error.what()).find("Anna"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

/// Number of statements about `what` that the server holds prepared for this connection.
std::int64_t preparedAbout(Connection& connection, const std::string& what) {
  Statement row = connection.selectVerbatim(
      "SELECT count(*) FROM pg_prepared_statements WHERE statement LIKE '%" + what + "%'");
  return row.step() ? row.int64(0) : -1;
}

TEST_F(ConnectionTest, CachesAndEvictsPreparedStatementsOnAServer) {
  if (!onPostgresql()) {
    GTEST_SKIP() << "SQLite prepares in this process";
  }
  Connection connection = openWithTable();
  for (const char* id : {"a", "b"}) {
    connection.execute("INSERT INTO thing (id, whole) VALUES (?, ?)", {id, 7});
  }
  EXPECT_EQ(preparedAbout(connection, "INSERT INTO thing"), 1);
  EXPECT_EQ(connection.execute("UPDATE thing SET whole = ? WHERE id = ?", {Value(), "a"}), 1);

  const char* const kLook = "SELECT id, whole FROM thing WHERE id <> ? ORDER BY id";
  {
    Statement one = connection.prepare(kLook);
    Statement other = connection.prepare(kLook);  // while the first one is executing
    one.execute({"b"});
    other.execute({"a"});
    ASSERT_TRUE(one.step() && other.step());
    EXPECT_EQ(one.text(0), "a");
    EXPECT_TRUE(one.isNull(1));
    EXPECT_EQ(other.text(0), "b");
  }
  EXPECT_EQ(preparedAbout(connection, "SELECT id, whole FROM thing"), 1);

  connection.executeVerbatim("ALTER TABLE thing ALTER COLUMN whole TYPE DOUBLE PRECISION");
  Statement row = connection.prepare(kLook);
  row.execute({"a"});
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.real(1), 7.0);
  for (int i = 0; i < 200; ++i) {
    Statement many = connection.prepare("SELECT " + std::to_string(i) + " FROM thing");
    many.execute();
  }
  EXPECT_LT(preparedAbout(connection, "FROM thing"), 100);
}

TEST_F(ConnectionTest, PreparesAFailedStatementAgain) {
  Connection connection = openWithTable();
  connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"});
  for (int i = 0; i < 2; ++i) {
    Transaction change(connection);
    EXPECT_EQ(faultFrom([&] { connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"}); }),
              DbFault::kUnique);
  }
  EXPECT_EQ(connection.execute("INSERT INTO thing (id) VALUES (?)", {"b"}), 1);
}

TEST_F(ConnectionTest, CountsChangedRows) {
  Connection connection = openWithTable();
  connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"});
  connection.execute("INSERT INTO thing (id) VALUES (?)", {"b"});

  EXPECT_EQ(connection.execute("UPDATE thing SET whole = ?", {7}), 2);
  EXPECT_EQ(connection.execute("DELETE FROM thing WHERE id = ?", {"c"}), 0);
}

TEST_F(ConnectionTest, IsConfinedToTheThreadThatOpenedIt) {
  Connection connection = openWithTable();
  bool refused = false;
  std::thread other([&] {
    try {
      connection.execute("DELETE FROM thing");
    } catch (const ContractError&) {
      refused = true;
    }
  });
  other.join();

  EXPECT_TRUE(refused);
}

TEST_F(ConnectionTest, ReadOnlyConnectionRefusesToWrite) {
  openWithTable();
  Connection reader = openDatabase(locator(), OpenMode::kReadOnly);

  EXPECT_EQ(numberFrom(reader, "SELECT count(*) FROM thing"), 0);
  EXPECT_EQ(faultFrom([&] { reader.execute("INSERT INTO thing (id) VALUES (?)", {"a"}); }),
            DbFault::kReadOnly);
}

using TransactionTest = ConnectionTest;

TEST_F(TransactionTest, DiscardsChangesUnlessCommitted) {
  Connection connection = openWithTable();
  {
    const Transaction transaction(connection);
    connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"});
    EXPECT_TRUE(connection.inTransaction());
  }
  EXPECT_FALSE(connection.inTransaction());
  EXPECT_EQ(numberFrom(connection, "SELECT count(*) FROM thing"), 0);
}

TEST_F(TransactionTest, KeepsCommittedChanges) {
  Connection connection = openWithTable();
  {
    Transaction transaction(connection);
    connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"});
    connection.execute("INSERT INTO thing (id) VALUES (?)", {"b"});
    transaction.commit();
  }
  Connection again = open();
  EXPECT_EQ(numberFrom(again, "SELECT count(*) FROM thing"), 2);
}

TEST_F(TransactionTest, CannotBeCommittedAfterAFailedStatement) {
  Connection connection = openWithTable();
  {
    Transaction transaction(connection);
    connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"});
    EXPECT_EQ(faultFrom([&] { connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"}); }),
              DbFault::kUnique);
    EXPECT_EQ(faultFrom([&] { transaction.commit(); }), DbFault::kBrokenBefore);
  }
  EXPECT_EQ(numberFrom(connection, "SELECT count(*) FROM thing"), 0);
}

TEST_F(TransactionTest, JoinsTheOuterOne) {
  Connection connection = openWithTable();
  {
    const Transaction outer(connection);
    Transaction inner(connection);
    connection.execute("INSERT INTO thing (id) VALUES (?)", {"a"});
    inner.commit();
  }
  EXPECT_EQ(numberFrom(connection, "SELECT count(*) FROM thing"), 0);

  Transaction outer(connection);
  { const Transaction givenUp(connection); }
  EXPECT_EQ(faultFrom([&] { outer.commit(); }), DbFault::kBrokenBefore);
}

TEST_F(TransactionTest, ReportsBusyWhenAnotherConnectionLocksTheRow) {
  Connection first = openWithTable();
  Connection second = open(50);
  Transaction transaction(first);
  first.execute("INSERT INTO thing (id) VALUES (?)", {"a"});

  try {
    const Transaction waiting(second);
    second.execute("INSERT INTO thing (id) VALUES (?)", {"a"});
    FAIL() << "nothing was refused";
  } catch (const DbError& error) {
    EXPECT_EQ(error.fault(), DbFault::kBusy);
    EXPECT_TRUE(error.retryable());
  }

  transaction.commit();
  second.execute("INSERT INTO thing (id) VALUES (?)", {"b"});
  EXPECT_EQ(numberFrom(second, "SELECT count(*) FROM thing"), 2);
}

TEST(Locator, ParsesAServerAddress) {
  const Locator locator =
      parseLocator("postgresql://torsio:p%40ss%3A@db.example.org:6543/skills?schema=ward_2");

  EXPECT_EQ(locator.engine, Engine::kPostgresql);
  EXPECT_EQ(locator.user, "torsio");
  EXPECT_EQ(locator.password, "p@ss:");
  EXPECT_EQ(locator.host, "db.example.org");
  EXPECT_EQ(locator.port, 6543);
  EXPECT_EQ(locator.database, "skills");
  EXPECT_EQ(locator.schema, "ward_2");
}

TEST(Locator, PassesEveryKnownParameterAndReadsItsOwnAddressBack) {
  const std::string text =
      "postgresql://u@db.example.org:6543/skills?sslmode=verify-full&sslrootcert=/etc/ca%20of%20us.pem"
      "&connect_timeout=7&application_name=ward%261&schema=ward_2";

  const Locator locator = parseLocator(text);

  EXPECT_EQ(locator.parameter("sslmode"), "verify-full");
  EXPECT_EQ(locator.parameter("sslrootcert"), "/etc/ca of us.pem");
  EXPECT_EQ(locator.parameter("application_name"), "ward&1");
  EXPECT_EQ(locator.schema, "ward_2");
  const Locator again = parseLocator(addressOf(locator));
  EXPECT_EQ(again.parameters, locator.parameters);
  EXPECT_EQ(again.schema, locator.schema);
  EXPECT_EQ(again.port, 6543);
}

TEST(Locator, RejectsUnknownPartsOfAnAddress) {
  const auto refused = [](const std::string& rest) {
    return refusalFrom([&rest] { (void)parseLocator("postgresql://u@h/d" + rest); });
  };

  EXPECT_NE(refused("?ssl_mode=verify-full").text.find("unknown connection parameter ssl_mode"),
            std::string::npos);
  EXPECT_NE(refused("?sslmode=verify_full").text.find("verify-full"), std::string::npos);
  EXPECT_NE(refused("?sslmode=").text.find("has no value"), std::string::npos);
  EXPECT_NE(refused("?sslmode=require&sslmode=disable").text.find("twice"), std::string::npos);
  EXPECT_NE(refused("?schema=a&schema=b").text.find("twice"), std::string::npos);
  EXPECT_NE(refused("?password=secret").text.find(".pgpass"), std::string::npos);
  EXPECT_EQ(refused("?password=secret").text.find("secret"), std::string::npos);
  EXPECT_EQ(refused("?sslcert=a;b").code, ErrorCode::kBadParameter);
  EXPECT_EQ(refused("#part").code, ErrorCode::kBadParameter);
}

TEST(Locator, TakesHostAndDatabaseFromAServiceFile) {
  const Locator locator = parseLocator("postgresql:///?service=ward");

  EXPECT_EQ(locator.parameter("service"), "ward");
  EXPECT_EQ(locator.port, 0);
  EXPECT_EQ(locator.shown(), "postgresql:///?service=ward");
  EXPECT_EQ(parseLocator(addressOf(locator)).parameters, locator.parameters);
}

TEST(Locator, NeverShowsThePassword) {
  EXPECT_EQ(parseLocator("postgresql://torsio:secret@h:1/d").shown(), "postgresql://h:1/d");
  const Refusal refusal = refusalFrom([] { (void)parseLocator("postgresql://torsio:secret@/d"); });
  EXPECT_EQ(refusal.code, ErrorCode::kBadParameter);
  EXPECT_EQ(refusal.text.find("secret"), std::string::npos);
}

TEST(Locator, RejectsAnUnsafeSchemaName) {
  EXPECT_EQ(refusalFrom([] { (void)parseLocator("postgresql://u@h/d?schema=a%22b"); }).code,
            ErrorCode::kBadParameter);
}

TEST(Locator, ReportsAnUnreachableServer) {
  try {
    (void)openDatabase("postgresql://u:secret@127.0.0.1:1/d", OpenMode::kReadWrite);
    FAIL();
  } catch (const DbError& error) {
    EXPECT_EQ(error.fault(), DbFault::kUnreachable);
    EXPECT_TRUE(error.retryable());
    EXPECT_EQ(std::string(error.what()).find("secret"), std::string::npos);
  }
}

}  // namespace

namespace {

class RowReaderTest : public DatabaseTest {
 protected:
  [[nodiscard]] Connection openWithRows() const {
    Connection connection = open();
    connection.executeVerbatim("CREATE TABLE t (number BIGINT, label TEXT, measured DOUBLE PRECISION)");
    connection.execute(insertInto("t", "number, label, measured"), {1, "one", 0.1});
    connection.execute(insertInto("t", "number, label, measured"), {2, "two", nullptr});
    return connection;
  }
};

constexpr const char* kAll = "SELECT number, label, measured FROM t ORDER BY number";

struct Line {
  std::int64_t number = 0;
  std::string label{};
  std::optional<double> measured{};
  friend bool operator==(const Line&, const Line&) = default;
};

Line lineOf(RowReader& row) {
  return {row.int64(), row.text(), row.maybeReal()};
}

TEST_F(RowReaderTest, TakesColumnsFromLeftToRight) {
  Connection connection = openWithRows();

  const std::vector<Line> lines = selectAll(connection, kAll, {}, lineOf);

  EXPECT_EQ(lines, (std::vector<Line>{{1, "one", 0.1}, {2, "two", std::nullopt}}));
}

TEST_F(RowReaderTest, ReadsTheFirstRowOrNone) {
  Connection connection = openWithRows();
  const char* const byNumber = "SELECT number, label, measured FROM t WHERE number = ?";

  const std::optional<Line> second = selectFirst(connection, byNumber, {2}, lineOf);
  const std::optional<Line> third = selectFirst(connection, byNumber, {3}, lineOf);

  EXPECT_EQ(second, (Line{2, "two", std::nullopt}));
  EXPECT_EQ(third, std::nullopt);
}

TEST_F(RowReaderTest, DetectsANullAndSkipsColumns) {
  Connection connection = openWithRows();

  const auto seen = selectAll(connection, kAll, {}, [](RowReader& row) {
    row.skip(2);
    const bool null = row.nextIsNull();
    return std::pair(null, row.hasValue());
  });

  EXPECT_EQ(seen.at(0), std::pair(false, true));
  EXPECT_EQ(seen.at(1), std::pair(true, false));
}

TEST_F(RowReaderTest, ThrowsForUnreadOrMissingColumns) {
  Connection connection = openWithRows();
  const auto tooMany = [](RowReader& row) { return std::pair(lineOf(row), row.int64()); };

  EXPECT_THROW((void)selectAll(connection, kAll, {}, readInt64), ContractError);
  EXPECT_THROW((void)selectAll(connection, kAll, {}, tooMany), ContractError);
}

TEST(InsertInto, HasAPlaceholderForEachColumn) {
  EXPECT_EQ(insertInto("t", "a"), "INSERT INTO t (a) VALUES (?)");
  EXPECT_EQ(insertInto("t", "a, b, c"), "INSERT INTO t (a, b, c) VALUES (?, ?, ?)");
}

}  // namespace

}  // namespace torsio
