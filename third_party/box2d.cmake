# Only the benchmarks compare with it.
find_package(box2d 2.4.1 REQUIRED)
cambrian_wrap(box2d box2d::box2d)
