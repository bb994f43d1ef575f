# The scenes of the live page in a native program: with its digits the page's are compared.
add_executable(live_digits live/digits.cpp
  ${PROJECT_SOURCE_DIR}/docs/live/scenes.cpp ${PROJECT_SOURCE_DIR}/docs/live/run.cpp)
target_link_libraries(live_digits PRIVATE bench_scenes 04_slider 05_fixed 06_baumgarte
  07_performance 08_ground 10_own workbook_strict)
