# The workbook's own tests, on the solutions, in double and float: one program a topic.
set(topics engine joints stability lanes ground direct reduced compare bench errata fuzz)
if(TARGET bench_peers OR TARGET bench_peers_float)  # where published engines are installed
  list(APPEND topics peers)
endif()
if(TARGET heaps)  # contacts from Bullet's collision part, in double
  list(APPEND topics bullet)
else()
  message(STATUS "Contacts from Bullet are not tested: libbullet-dev is not installed")
endif()
# In double alone, and why float would prove nothing more:
set(double_only
  bench/accuracy_test.cpp  # references to 1e-9 m
  bench/next_door_test.cpp  # where convergence ends, which rounding decides in float
  direct/order_test.cpp  # orders of convergence: rounding hides them in float
  engine/projected_energy_test.cpp  # linkages that gain energy, which rounding chooses
  engine/input_test.cpp joints/driven_input_test.cpp)
    # which values are refused, and in what words

# gather(OUT NAME sources...): several sources as one, see tools/check/gather.py. An edit compiles as many
# anew as stand in one.
function(gather out name)
  set(at_most 7)
  set(made "")
  list(LENGTH ARGN count)
  math(EXPR parts "(${count} + ${at_most} - 1) / ${at_most}")
  foreach(part RANGE 1 ${parts})
    math(EXPR begin "${count} * (${part} - 1) / ${parts}")
    math(EXPR size "${count} * ${part} / ${parts} - ${begin}")
    list(SUBLIST ARGN ${begin} ${size} sources)
    set(source ${PROJECT_BINARY_DIR}/gathered/${name}_${part}.cpp)
    add_custom_command(OUTPUT ${source}
      COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check/gather.py ${source} ${sources}
      DEPENDS ${PROJECT_SOURCE_DIR}/tools/check/gather.py ${sources} COMMENT "" VERBATIM)
    list(APPEND made ${source})
  endforeach()
  set(${out} ${made} PARENT_SCOPE)
endfunction()

# Eigen is read in one file, once for both kinds of number: the oracle reckons in double.
add_library(dense STATIC oracle/dense.cpp)
target_compile_features(dense PRIVATE cxx_std_20)
target_include_directories(dense PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(dense PRIVATE Eigen3::Eigen workbook_strict)

foreach(number double float)
  set(suffix ${suffix_of_${number}})
  add_library(oracle${suffix} STATIC oracle/oracle.cpp oracle/rigs.cpp
    oracle/allocations.cpp)
  target_link_libraries(oracle${suffix} PUBLIC bench_scenes${suffix} simd${suffix}
    ${libraries${suffix}} instruments${suffix} checker${suffix} dense PRIVATE workbook_strict)
  # joints.h, for the examples of library/examples
  target_include_directories(oracle${suffix} PUBLIC ${PROJECT_SOURCE_DIR}/library)
  target_precompile_headers(oracle${suffix} PRIVATE checker/catch.h oracle/oracle.h)
  foreach(topic ${topics})
    if((topic STREQUAL peers AND NOT TARGET bench_peers${suffix}) OR
       (topic STREQUAL bullet AND number STREQUAL float))
      continue()
    endif()
    set(target ${topic}_test${suffix})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${topic}/*_test.cpp)
    set(name ${topic})
    if(number STREQUAL float)
      foreach(file ${double_only})
        list(REMOVE_ITEM sources ${CMAKE_CURRENT_SOURCE_DIR}/${file})
      endforeach()
      set(name ${topic}_float)
    endif()
    gather(gathered ${name} ${sources})
    add_executable(${target} ${gathered} checker/where.cpp)
    target_compile_definitions(${target} PRIVATE EXERCISE_FILE="")
    target_link_libraries(${target} PRIVATE oracle${suffix} workbook_strict)
    if(topic MATCHES "^(peers|bullet)$")
      target_link_libraries(${target} PRIVATE bench_peers${suffix})
    elseif(topic STREQUAL bench)
      target_link_libraries(${target} PRIVATE bench_stability${suffix})
    elseif(topic STREQUAL compare)
      target_link_libraries(${target} PRIVATE compare${suffix})
    endif()
    target_precompile_headers(${target} REUSE_FROM oracle${suffix})
    list_program(topic ${topic} ${number} ${target})
  endforeach()
endforeach()
