#include "persist/sqlite/database.h"

#include "core/files/private_folder.h"
#include "core/text/shown_text.h"
#include "persist/sqlite/safe_files.h"

#include <fmt/core.h>

#include <cerrno>
#include <limits>
#include <sqlite3.h>
#include <system_error>
#include <utility>

namespace cambrian {
namespace {

constexpr int kLongestValue = 5'000'000;       // bytes, unless more are allowed
constexpr std::size_t kLongestShownWord = 64;  // bytes
constexpr int kPatience = 2000;                // ms to wait while another program reads or writes
constexpr int kWriterCache = 256;              // kB of pages; writers hardly read what they wrote

// Returns whether it is a database without a name, which SQLite keeps in memory and, if it is
// large, in the temporary folder.
bool is_temporary(sqlite3* connection) {
    const char* const name = sqlite3_db_filename(connection, "main");
    return name == nullptr || *name == '\0';
}

// A full disk also keeps SQLite from making the index of a log, and is then an error of input and
// output.
bool is_full(sqlite3* connection, int code) {
    return code == SQLITE_FULL || code == SQLITE_IOERR_SHMSIZE ||
           ((code & 0xff) == SQLITE_IOERR && sqlite3_system_errno(connection) == ENOSPC);
}

// SQLite's messages quote names that files choose.
[[noreturn]] void fail(sqlite3* connection, int code) {
    const std::string reason = shown(sqlite3_errmsg(connection), kLongestReason);
    if (is_full(connection, code))
        throw DiskFullError(is_temporary(connection) ? of_temporary_folder("it is full")
                                                     : std::string("the disk is full"));
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            throw DatabaseError("another program is using it");
        case SQLITE_READONLY:
        case SQLITE_PERM:
        case SQLITE_AUTH:
            throw DatabaseError("it cannot be written to");
        case SQLITE_NOTADB:
            throw DatabaseError("it is not an SQLite database");
        case SQLITE_CORRUPT:
            throw DatabaseError(fmt::format("it is damaged ({})", reason));
        default:
            throw DatabaseError(reason);
    }
}

int flags_of(Database::Access access) {
    switch (access) {
        case Database::Access::kRead:
            return SQLITE_OPEN_READONLY;
        case Database::Access::kReadUnchanging:
            return SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
        case Database::Access::kWrite:
            return SQLITE_OPEN_READWRITE;
        case Database::Access::kCreate:
            break;
    }
    return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
}

// Adds the folder, so that SQLite does not read the name as a URI or as a database in memory.
std::filesystem::path usable_name(const std::filesystem::path& path, Database::Access access) {
    if (path.empty()) return path;
    std::error_code unknown;
    const auto facts = std::filesystem::status(path, unknown);
    if (std::filesystem::exists(facts) && !std::filesystem::is_regular_file(facts))
        throw DatabaseError("it is not a regular file");
    if (!std::filesystem::exists(facts) && access != Database::Access::kCreate)
        throw DatabaseError(unknown ? unknown.message() : std::generic_category().message(ENOENT));
    return std::filesystem::absolute(path);
}

// Returns the URI with which SQLite opens a file that does not change.
std::string unchanging(const std::filesystem::path& path) {
    std::string name = "file:";
    for (const char letter : path.string()) {
        if (letter == '%' || letter == '?' || letter == '#') {
            name += letter == '%' ? "%25" : letter == '?' ? "%3f" : "%23";
        } else {
            name += letter;
        }
    }
    return name + "?immutable=1";
}

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Statement::Statement(sqlite3* database, std::string_view sql) {
    sqlite3_stmt* statement = nullptr;
    const int code =
        sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    statement_.reset(statement);
    if (code != SQLITE_OK) fail(database, code);
}

void Statement::check(int code) const {
    if (code != SQLITE_OK) fail(sqlite3_db_handle(statement_.get()), code);
}

void Statement::restart() {
    // Returns the error of the last step again, which was reported.
    sqlite3_reset(statement_.get());
    bound_ = 0;
}

void Statement::bind_next(std::int64_t value) {
    check(sqlite3_bind_int64(statement_.get(), ++bound_, value));
}

void Statement::bind_next(double value) {
    check(sqlite3_bind_double(statement_.get(), ++bound_, value));
}

void Statement::bind_next(std::string_view text) {
    check(sqlite3_bind_text(statement_.get(), ++bound_, text.data(), static_cast<int>(text.size()),
                            SQLITE_TRANSIENT));
}

void Statement::bind_next(std::nullopt_t) {
    check(sqlite3_bind_null(statement_.get(), ++bound_));
}

void Statement::bind_bytes(std::string_view bytes) {
    check(sqlite3_bind_blob(statement_.get(), ++bound_, bytes.data(),
                            static_cast<int>(bytes.size()), SQLITE_TRANSIENT));
}

bool Statement::step() {
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW) return true;
    if (code != SQLITE_DONE) fail(sqlite3_db_handle(statement_.get()), code);
    return false;
}

void Statement::finish() {
    while (step()) {
    }
    restart();
}

std::int64_t Statement::inserted_row() const {
    return sqlite3_last_insert_rowid(sqlite3_db_handle(statement_.get()));
}

void Statement::refuse(int column, const char* expected) const {
    static constexpr const char* names[] = {"nothing", "a whole number", "a number",
                                            "a text",  "bytes",          "nothing"};
    const int found = sqlite3_column_type(statement_.get(), column);
    throw DatabaseError(fmt::format("column \"{}\": expected {}, found {}",
                                    sqlite3_column_name(statement_.get(), column), expected,
                                    names[found]));
}

bool Statement::is_null(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const {
    if (sqlite3_column_type(statement_.get(), column) != SQLITE_INTEGER)
        refuse(column, "a whole number");
    return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
    const int type = sqlite3_column_type(statement_.get(), column);
    if (type == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
    if (type != SQLITE_FLOAT && type != SQLITE_INTEGER) refuse(column, "a number");
    return sqlite3_column_double(statement_.get(), column);
}

std::string_view Statement::text(int column, std::size_t longest) const {
    if (sqlite3_column_type(statement_.get(), column) != SQLITE_TEXT) refuse(column, "a text");
    const auto* letters = sqlite3_column_text(statement_.get(), column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    if (size > longest)
        throw DatabaseError(fmt::format("column \"{}\": a text of {} bytes; expected at most {}",
                                        sqlite3_column_name(statement_.get(), column), size,
                                        longest));
    return {reinterpret_cast<const char*>(letters), size};
}

std::string Statement::word(int column) const {
    return shown(text(column), kLongestShownWord);
}

std::string_view Statement::bytes(int column) const {
    if (sqlite3_column_type(statement_.get(), column) != SQLITE_BLOB) refuse(column, "bytes");
    const void* bytes = sqlite3_column_blob(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return {static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

void Database::Close::operator()(sqlite3* connection) const {
    sqlite3_close_v2(connection);
}

Database::Database(const std::filesystem::path& named, Access access) {
    const std::filesystem::path path = usable_name(named, access);
    if (!path.empty() && access != Access::kReadUnchanging) check_journal(path);
    open(access == Access::kReadUnchanging ? unchanging(path) : path.string(), flags_of(access));
    distrust();
}

void Database::open(const std::string& name, int flags) {
    sqlite3* connection = nullptr;
    const int code =
        sqlite3_open_v2(name.c_str(), &connection, flags | SQLITE_OPEN_NOMUTEX, safe_file_system());
    connection_.reset(connection);
    if (code != SQLITE_OK) fail(connection, code);
}

// Protects against malicious files.
void Database::distrust() {
    sqlite3* const connection = connection_.get();
    sqlite3_extended_result_codes(connection, 1);
    sqlite3_busy_timeout(connection, kPatience);
    sqlite3_limit(connection, SQLITE_LIMIT_LENGTH, kLongestValue);
    sqlite3_db_config(connection, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(connection, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(connection, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(connection, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    execute("PRAGMA cell_size_check = ON");
    execute("PRAGMA mmap_size = 0");
}

void Database::allow_values_of(int bytes) const {
    sqlite3_limit(connection_.get(), SQLITE_LIMIT_LENGTH, bytes);
}

Database Database::copy() const {
    Database copied({}, Access::kCreate);
    sqlite3* const target = copied.connection_.get();
    sqlite3_backup* const backup = sqlite3_backup_init(target, "main", connection_.get(), "main");
    if (backup == nullptr) fail(target, sqlite3_errcode(target));
    sqlite3_backup_step(backup, -1);
    if (const int code = sqlite3_backup_finish(backup); code != SQLITE_OK) fail(target, code);
    return copied;
}

void Database::copy_to(const std::filesystem::path& path) const {
    prepare("VACUUM INTO ?").run(std::filesystem::absolute(path).string());
}

void Database::make_durable() {
    Statement mode = prepare("PRAGMA journal_mode = WAL");
    if (!mode.step() || mode.text(0) != "wal")
        throw DatabaseError("it cannot have a write-ahead log there");
    mode.finish();
    execute(fmt::format("PRAGMA cache_size = -{}", kWriterCache));
    execute("PRAGMA synchronous = FULL");
}

void Database::empty_log() {
    Statement checkpoint = prepare("PRAGMA wal_checkpoint(TRUNCATE)");
    if (checkpoint.step() && checkpoint.integer(0) != 0)
        throw DatabaseError("another program is using it");
    checkpoint.finish();
}

void Database::execute(const std::string& sql) {
    const int code = sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail(connection_.get(), code);
}

std::int64_t Database::integer(std::string_view sql) const {
    Statement statement = prepare(sql);
    if (!statement.step()) throw DatabaseError("a value is missing");
    return statement.integer(0);
}

Transaction::Transaction(Database& database) : database_(&database) {
    database.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    if (database_ == nullptr) return;
    try {
        database_->execute("ROLLBACK");
    } catch (const DatabaseError&) {
        // SQLite has rolled back by itself.
        return;
    }
}

void Transaction::commit() {
    database_->execute("COMMIT");
    database_ = nullptr;
}

}  // namespace cambrian
