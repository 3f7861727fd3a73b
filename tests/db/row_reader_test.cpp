// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/row_reader.h"

#include <optional>
#include <utility>

#include "db/connection/connection.h"
#include "sim/core/contracts.h"
#include "tests/db/test_database.h"

namespace torsio {
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
