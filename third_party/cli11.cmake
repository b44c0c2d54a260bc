find_package(CLI11 2 REQUIRED)
cambrian_wrap(cli11 CLI11::CLI11)
