# Nothing that needs it is built for other processors (tests/golden/everywhere.sh).
if(CMAKE_CROSSCOMPILING)
  cambrian_wrap(sqlite)
else()
  find_package(SQLite3 3.37 REQUIRED)
  cambrian_wrap(sqlite SQLite::SQLite3)
endif()
