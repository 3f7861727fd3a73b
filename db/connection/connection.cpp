// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/connection.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>

#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QVariant>

#include "db/connection/connection_state.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

QVariant toVariant(const Value& value) {
  struct Visitor {
    QVariant operator()(std::monostate) const { return {}; }
    QVariant operator()(std::int64_t number) const { return QVariant::fromValue<qlonglong>(number); }
    QVariant operator()(double number) const {
      TORSIO_EXPECTS(std::isfinite(number));
      return number;
    }
    QVariant operator()(bool flag) const { return flag; }
    QVariant operator()(const std::string& text) const {
      // An empty text is not null: a default-constructed QString would be stored as null.
      return text.empty() ? QStringLiteral("")
                          : QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    }
    QVariant operator()(const Blob& bytes) const {
      return bytes.empty() ? QByteArray("")
                           : QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                        static_cast<qsizetype>(bytes.size()));
    }
  };
  return std::visit(Visitor{}, value.storage());
}

Blob toBlob(const QByteArray& bytes) {
  const auto* begin = reinterpret_cast<const std::byte*>(bytes.constData());
  return {begin, begin + bytes.size()};
}

}  // namespace

/// A QSqlQuery that keeps its database alive, with its SQL text for messages.
class Statement::Query {
 public:
  enum class Start { kPrepare, kRun };
  Query(std::shared_ptr<ConnectionState> connection, std::string_view sql, Start start)
      : state(std::move(connection)), text(sql) {
    if (const auto kept = start == Start::kPrepare ? state->takeKept(sql) : nullptr) {
      query = std::move(*kept);
      return;
    }
    query = state->query();
    const QString statement = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    if (!(start == Start::kPrepare ? query.prepare(statement) : query.exec(statement))) {
      state->fail(text, query.lastError());
    }
  }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;
  ~Query() {
    if (worthKeeping) {
      state->keep(std::move(text), std::move(query));
    }
  }

  std::shared_ptr<ConnectionState> state;
  std::string text;
  QSqlQuery query;
  bool worthKeeping = false;  // prepared, and its last run succeeded
  std::int64_t affectedRows = 0;
  int columns = -1;                               // number of columns; negative: not queried yet
  std::shared_ptr<const ChangeWatch::Plan> plan;  // null: changes are not watched
  std::vector<Value> bound;                       // only with a plan
};

Statement::Statement(std::unique_ptr<Query> query) : query_(std::move(query)) {}
Statement::Statement(Statement&&) noexcept = default;
Statement& Statement::operator=(Statement&&) noexcept = default;
Statement::~Statement() = default;

Statement& Statement::bind(int position, const Value& value) {
  query_->query.bindValue(position, toVariant(value));
  if (query_->plan) {
    const auto index = static_cast<std::size_t>(position);
    if (query_->bound.size() <= index) {
      query_->bound.resize(index + 1);
    }
    query_->bound[index] = value;
  }
  return *this;
}

void Statement::execute() {
  if (!query_->plan || query_->state->depth > 0) {
    run();
    return;
  }
  Connection connection(query_->state);
  Transaction alone(connection);
  run();
  alone.commit();
}

void Statement::run() {
  TORSIO_EXPECTS(!query_->state->broken);
  query_->columns = -1;
  query_->worthKeeping = false;
  if (query_->plan && query_->state->watch) {
    Connection connection(query_->state);
    query_->state->watch->changing(connection, *query_->plan, query_->bound);
  }
  if (!query_->query.exec()) {
    const QSqlError error = query_->query.lastError();
    query_->query.finish();
    query_->state->fail(query_->text, error);
  }
  query_->worthKeeping = true;
  query_->affectedRows = query_->query.numRowsAffected();
  if (query_->plan) {
    ChangeWatch::Rows returned;
    if (query_->query.isSelect()) {
      const int columns = columnCount();
      while (step()) {
        std::vector<Value>& row = returned.emplace_back();
        for (int column = 0; column < columns; ++column) {
          row.push_back(value(column));
        }
      }
      query_->affectedRows = static_cast<std::int64_t>(returned.size());
    }
    query_->query.finish();
    if (query_->state->watch) {
      query_->state->watch->changed(query_->plan, query_->bound, returned, query_->affectedRows);
    }
    return;
  }
  // SQLite refuses COMMIT while a statement is in progress, even one without rows to read.
  if (!query_->query.isSelect()) {
    query_->query.finish();
  }
}

void Statement::execute(std::initializer_list<Value> values) {
  execute(std::span<const Value>(values.begin(), values.size()));
}

void Statement::execute(std::span<const Value> values) {
  int position = 0;
  for (const Value& value : values) {
    bind(position++, value);
  }
  execute();
}

bool Statement::step() {
  if (query_->query.next()) {
    return true;
  }
  const QSqlError error = query_->query.lastError();
  query_->query.finish();
  if (error.isValid()) {
    query_->state->fail(query_->text, error);
  }
  return false;
}

std::int64_t Statement::affectedRows() const {
  return query_->affectedRows;
}

bool Statement::isNull(int column) const {
  return query_->query.value(column).isNull();
}

std::int64_t Statement::int64(int column) const {
  return query_->query.value(column).toLongLong();
}

double Statement::real(int column) const {
  return query_->query.value(column).toDouble();
}

bool Statement::boolean(int column) const {
  return query_->query.value(column).toBool();
}

std::string Statement::text(int column) const {
  return query_->query.value(column).toString().toStdString();
}

Blob Statement::blob(int column) const {
  return toBlob(query_->query.value(column).toByteArray());
}

std::optional<std::int64_t> Statement::maybeInt64(int column) const {
  return isNull(column) ? std::nullopt : std::optional(int64(column));
}

std::optional<double> Statement::maybeReal(int column) const {
  return isNull(column) ? std::nullopt : std::optional(real(column));
}

std::optional<std::string> Statement::maybeText(int column) const {
  return isNull(column) ? std::nullopt : std::optional(text(column));
}

int Statement::columnCount() const {
  if (query_->columns < 0) {
    query_->columns = query_->query.record().count();  // record() copies the row
  }
  return query_->columns;
}

std::string Statement::columnName(int column) const {
  return query_->query.record().fieldName(column).toStdString();
}

Value Statement::value(int column) const {
  const QVariant variant = query_->query.value(column);
  if (variant.isNull()) {
    return {};
  }
  switch (variant.typeId()) {
    case QMetaType::Bool:
      return variant.toBool();
    case QMetaType::Double:
      return variant.toDouble();
    case QMetaType::QByteArray:
      return toBlob(variant.toByteArray());
    case QMetaType::QString:
      return variant.toString().toStdString();
    default:
      return static_cast<std::int64_t>(variant.toLongLong());
  }
}

Connection::Connection(std::shared_ptr<ConnectionState> state) : state_(std::move(state)) {}
Connection::Connection(Connection&&) noexcept = default;
Connection& Connection::operator=(Connection&&) noexcept = default;
Connection::~Connection() = default;

void Connection::observeStatements(std::function<void(std::string_view)> observer) {
  state_->observer = std::move(observer);
}

Statement Connection::prepare(std::string_view sql) {
  if (state_->observer) {
    state_->observer(sql);
  }
  std::shared_ptr<const ChangeWatch::Plan> plan = state_->watch ? state_->watch->planOf(sql) : nullptr;
  std::string longer;
  if (plan && !plan->returning().empty()) {
    longer.append(sql).append(" RETURNING ").append(plan->returning());
    sql = longer;
  }
  auto query = std::make_unique<Statement::Query>(state_, sql, Statement::Query::Start::kPrepare);
  query->plan = std::move(plan);
  return Statement(std::move(query));
}

std::shared_ptr<ChangeWatch> Connection::watchChanges(std::shared_ptr<ChangeWatch> watch) {
  return std::exchange(state_->watch, std::move(watch));
}

void Connection::reportChange(std::string_view table, std::vector<Value> key, bool removed) {
  if (state_->watch) {
    state_->watch->changedElsewhere(table, std::move(key), removed);
  }
}

Statement Connection::selectVerbatim(std::string_view sql) {
  return Statement(std::make_unique<Statement::Query>(state_, sql, Statement::Query::Start::kRun));
}

std::int64_t Connection::execute(std::string_view sql, std::initializer_list<Value> values) {
  Statement statement = prepare(sql);
  statement.execute(values);
  return statement.affectedRows();
}

void Connection::executeVerbatim(std::string_view sql) {
  state_->run(sql);
  if (sql.rfind("SELECT", 0) != 0) {
    state_->forgetKept();
  }
}

Engine Connection::engine() const noexcept {
  return state_->engine;
}

const std::string& Connection::location() const noexcept {
  return state_->location;
}

bool Connection::readOnly() const noexcept {
  return state_->readOnly;
}

bool Connection::inTransaction() const noexcept {
  return state_->depth > 0;
}

Connection openDatabase(const std::string& locator, OpenMode mode, int busyTimeout_ms) {
  Connection connection(std::make_shared<ConnectionState>(parseLocator(locator), mode, busyTimeout_ms));
  if (std::getenv(kShowStatements) != nullptr) {
    connection.observeStatements([](std::string_view sql) { std::cerr << "sql: " << sql << '\n'; });
  }
  return connection;
}

Transaction::Transaction(Connection& connection, Purpose purpose) : state_(connection.state_) {
  if (state_->depth == 0) {
    state_->begin(purpose);
  }
  ++state_->depth;
}

Transaction::~Transaction() {
  if (!open_) {
    return;
  }
  if (--state_->depth == 0) {
    state_->leave();
  } else {
    state_->abandon();
  }
}

void Transaction::commit() {
  TORSIO_EXPECTS(open_);
  if (state_->depth > 1) {
    open_ = false;
    --state_->depth;
    return;
  }
  if (state_->broken) {
    throw DbError(DbFault::kBrokenBefore, "COMMIT",
                  Text::tr("an earlier step of this change failed: nothing was kept"), state_->location,
                  Text::tr("Repeat the whole change"));
  }
  if (state_->watch) {
    Connection connection(state_);
    state_->watch->beforeCommit(connection);
  }
  state_->commit();  // on an exception the destructor rolls back
  open_ = false;
  state_->depth = 0;
  if (state_->watch) {
    state_->watch->forget();
  }
}

}  // namespace torsio
