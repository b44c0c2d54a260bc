find_package(benchmark 1.7 REQUIRED)
cambrian_wrap(benchmark benchmark::benchmark benchmark::benchmark_main)
