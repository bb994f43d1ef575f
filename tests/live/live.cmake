# The scenes of the live page in native programs: with the digits of one the page's are compared,
# the other is `./wb run 3 --compare`.
set(live ${PROJECT_SOURCE_DIR}/docs/live)
add_executable(live_digits live/digits.cpp ${live}/scenes.cpp ${live}/run.cpp)
add_executable(compare_chapter live/compared.cpp ${live}/scenes.cpp)
foreach(program live_digits compare_chapter)
  target_link_libraries(${program} PRIVATE bench_scenes 04_slider 05_fixed 06_baumgarte
    07_performance 08_ground 10_own workbook_strict)
endforeach()
