# The workbook's own tests, on the solutions, in double and float: one program a topic.
set(topics engine joints stability lanes ground bench errata)
foreach(number double float)
  set(suffix ${suffix_of_${number}})
  add_library(oracle${suffix} STATIC checker/oracle.cpp checker/rigs.cpp
    checker/allocations.cpp)
  target_link_libraries(oracle${suffix} PUBLIC bench_stability${suffix} wide${suffix}
    ${libraries${suffix}} instruments${suffix} checker${suffix} Eigen3::Eigen
    PRIVATE workbook_strict)
  target_precompile_headers(oracle${suffix} PRIVATE checker/catch.h checker/oracle.h)
  foreach(topic ${topics})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${topic}/*_test.cpp)
    set(target ${topic}_test${suffix})
    add_executable(${target} ${sources} checker/where.cpp)
    target_compile_definitions(${target} PRIVATE EXERCISE_FILE="")
    target_link_libraries(${target} PRIVATE oracle${suffix} workbook_strict)
    target_precompile_headers(${target} REUSE_FROM oracle${suffix})
    list_program(topic ${topic} ${number} ${target})
  endforeach()
endforeach()
