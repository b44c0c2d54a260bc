find_package(SQLite3 3.37 REQUIRED)
cambrian_wrap(sqlite SQLite::SQLite3)
