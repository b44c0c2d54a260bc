#pragma once

// SQLite as values and exceptions, for use inside this layer only: whoever offers a database to
// others catches DatabaseError at the boundary.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace cambrian {

// In words for a person: what could not be done and why, without the file's name.
class DatabaseError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// A statement, run as often as wanted. Integers are 64 bits; unsigned ones keep their bits, so
// large ones look negative in SQL.
class Statement {
public:
    Statement(sqlite3* database, std::string_view sql);

    // Binds the values to the parameters from the first one on, in order.
    template <class... Values>
    void bind(const Values&... values) {
        restart();
        (bind_next(values), ...);
    }
    void bind_next(std::int64_t value);
    void bind_next(std::uint64_t value) { bind_next(static_cast<std::int64_t>(value)); }
    void bind_next(std::uint32_t value) { bind_next(static_cast<std::int64_t>(value)); }
    void bind_next(int value) { bind_next(static_cast<std::int64_t>(value)); }
    void bind_next(bool value) { bind_next(static_cast<std::int64_t>(value)); }
    void bind_next(double value);
    void bind_next(std::string_view text);
    void bind_next(const std::string& text) { bind_next(std::string_view(text)); }
    void bind_next(const char* text) { bind_next(std::string_view(text)); }
    void bind_next(std::nullopt_t);
    template <class Value>
    void bind_next(const std::optional<Value>& value) {
        if (value) {
            bind_next(*value);
        } else {
            bind_next(std::nullopt);
        }
    }
    void bind_bytes(std::string_view bytes);
    void restart();

    bool step();  // whether there is a row
    // Binds and runs to the end.
    template <class... Values>
    void run(const Values&... values) {
        bind(values...);
        finish();
    }
    void finish();
    std::int64_t inserted_row() const;  // by the last insertion, of any statement

    // Of the present row; columns count from 0. Fail if the value is of another type.
    bool is_null(int column) const;
    std::int64_t integer(int column) const;
    double real(int column) const;             // of null: not a number, which SQLite cannot hold
    std::string_view text(int column) const;   // valid until the next step
    std::string_view bytes(int column) const;  // valid until the next step

private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    void check(int code) const;
    [[noreturn]] void refuse(int column, const char* expected) const;

    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
    int bound_ = 0;
};

class Database {
public:
    enum class Access : std::uint8_t {
        kRead,
        kReadUnchanging,  // a file that nobody changes meanwhile: needs and leaves nothing else
        kWrite,
        kCreate,
    };

    // A regular file; an empty path: a database of its own that vanishes with it.
    Database(const std::filesystem::path& path, Access access);

    // A copy in memory.
    Database copy() const;

    // Copies the database to another file, which must be empty if it exists.
    void copy_to(const std::filesystem::path& path) const;

    // Switches to a write-ahead log: readers do not wait for the writer, and a commit is on the
    // disk when it returns. Fails if the file cannot have such a log.
    void make_durable();

    void execute(const std::string& sql);
    Statement prepare(std::string_view sql) const { return {connection_.get(), sql}; }
    // The single value of a query.
    std::int64_t integer(std::string_view sql) const;

private:
    struct Close {
        void operator()(sqlite3* connection) const;
    };
    void open(const std::string& name, int flags);
    void distrust();

    std::unique_ptr<sqlite3, Close> connection_;
};

// A transaction; it rolls back at the end of its scope unless it was committed.
class Transaction {
public:
    explicit Transaction(Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit();

private:
    Database* database_;
};

}  // namespace cambrian
