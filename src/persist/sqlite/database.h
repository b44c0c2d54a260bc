#pragma once

// SQLite with values and exceptions, for this layer only. Functions of the layer's interface must
// catch DatabaseError.

#include <cstddef>
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

// The message says what could not be done and why, without the file's name.
class DatabaseError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class DiskFullError : public DatabaseError {
public:
    using DatabaseError::DatabaseError;
};

// A statement, which can be run repeatedly. Integers have 64 bits; unsigned ones keep their bits,
// so that large ones look negative in SQL.
class Statement {
public:
    static constexpr std::size_t kLongestWord = 1000;  // bytes of names, kinds and short lists

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

    bool step();  // returns whether there is a row
    // Binds the values and runs the statement to its end.
    template <class... Values>
    void run(const Values&... values) {
        bind(values...);
        finish();
    }
    void finish();
    std::int64_t inserted_row() const;  // row of the last insertion by any statement

    // Return the value of a column, counted from 0, in the present row. They fail if the value has
    // another type.
    bool is_null(int column) const;
    std::int64_t integer(int column) const;
    double real(int column) const;  // null reads as not-a-number, which SQLite cannot store
    // Fails if the text has more than `longest` bytes. Valid until the next step.
    std::string_view text(int column, std::size_t longest = kLongestWord) const;
    // Returns a short text as it may be shown (core/text/shown_text.h): a name, a kind, a version.
    std::string word(int column) const;
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
        kReadUnchanging,  // a file that nobody changes meanwhile; creates no other files
        kWrite,
        kCreate,
    };

    // Opens a regular file. An empty path means a temporary database that is deleted when closed.
    Database(const std::filesystem::path& path, Access access);

    // Returns a copy in memory.
    Database copy() const;

    // Copies the database to another file, which must be empty if it exists.
    void copy_to(const std::filesystem::path& path) const;

    // Switches to a write-ahead log. Readers then do not wait for the writer, and a commit is on
    // the disk when it returns. Fails if the file cannot have such a log.
    void make_durable();

    // Takes all changes from the write-ahead log into the file, or fails; nobody else may use it.
    void empty_log();

    // Allows texts and blobs of so many bytes; 5 MB are allowed otherwise.
    void allow_values_of(int bytes) const;

    void execute(const std::string& sql);
    Statement prepare(std::string_view sql) const { return {connection_.get(), sql}; }
    // Returns the single value of a query.
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
