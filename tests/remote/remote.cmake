# What ./wb grade runs: the tests of a chapter, which ask a process of the answer's own for its
# numbers, and the program of that process. See wire.h.
add_library(remote_tests OBJECT EXCLUDE_FROM_ALL remote/client.cpp remote/wire.cpp)
add_library(remote_answer OBJECT EXCLUDE_FROM_ALL remote/server.cpp remote/wire.cpp
  checker/stack.cpp)
foreach(target remote_tests remote_answer)
  target_link_libraries(${target} PRIVATE engine workbook_strict)
  at_once(${target})
endforeach()
check_cxx_compiler_flag(-fsemantic-interposition WORKBOOK_CAN_INTERPOSE)
file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/remote/*.h)

foreach(chapter ${chapters})
  get_property(name GLOBAL PROPERTY WORKBOOK_NAME_${chapter})
  get_property(uses GLOBAL PROPERTY WORKBOOK_USES_${chapter})
  get_property(options GLOBAL PROPERTY WORKBOOK_OPTIONS_${chapter})
  get_property(given GLOBAL PROPERTY WORKBOOK_GIVEN_${chapter})
  set(solution ${PROJECT_SOURCE_DIR}/solutions/${chapter}/${name}.cpp)
  set(maker ${PROJECT_SOURCE_DIR}/tools/classroom/remote.py)
  foreach(side client server)
    set(source ${PROJECT_BINARY_DIR}/remote/${chapter}_${side}.cpp)
    add_custom_command(OUTPUT ${source}
      COMMAND Python3::Interpreter ${maker} ${side} ${solution} ${source}
      DEPENDS ${maker} ${PROJECT_SOURCE_DIR}/tools/base/exercises.py ${solution} ${headers}
      COMMENT "" VERBATIM)
    add_library(${chapter}_${side} OBJECT EXCLUDE_FROM_ALL ${source})
    target_link_libraries(${chapter}_${side} PRIVATE engine ${uses})
    target_compile_options(${chapter}_${side} PRIVATE ${options})
  endforeach()

  add_exercise_test(${chapter}_judge chapters/${chapter}/${name}.cpp ${chapter}_tests
    $<TARGET_OBJECTS:${chapter}_client> $<TARGET_OBJECTS:remote_tests> ${given} ${uses}
    $<TARGET_OBJECTS:${chapter}_mistakes> checker)
  add_executable(${chapter}_answer_mine $<TARGET_OBJECTS:${chapter}_server>
    $<TARGET_OBJECTS:remote_answer>)
  target_link_libraries(${chapter}_answer_mine PRIVATE ${chapter}_mine)
  add_library(${chapter}_spare OBJECT EXCLUDE_FROM_ALL ${solution})  # for what is not right
  target_link_libraries(${chapter}_spare PRIVATE engine ${uses} workbook_lenient)
  target_compile_options(${chapter}_spare PRIVATE ${options})
  foreach(target ${chapter}_spare ${chapter}_mine)  # a function calls those that are linked
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    if(WORKBOOK_CAN_INTERPOSE)
      target_compile_options(${target} PRIVATE -fsemantic-interposition)
    endif()
  endforeach()
  set_target_properties(${chapter}_judge ${chapter}_answer_mine PROPERTIES EXCLUDE_FROM_ALL ON)
endforeach()
list(APPEND remote 01_distance_judge 01_distance_spare 01_distance_server remote_answer)
