# The exercise files once more, with numbers that carry units: NN_name_units on the solution,
# NN_name_units_mine on the reader's file, and the wrong answers that the units find out.
add_library(units_options INTERFACE)
target_link_libraries(units_options INTERFACE workbook_options Catch2::Catch2WithMain)
target_compile_definitions(units_options INTERFACE JOINTS_REAL=joints::Quantity
  "JOINTS_REAL_HEADER=\"tests/checker/quantity.h\"")
target_compile_options(units_options INTERFACE -O0)

# What the exercises call, and the headers of all: read once, as all is made with these options.
add_library(engine_units STATIC
  ${PROJECT_SOURCE_DIR}/engine/real.cpp ${PROJECT_SOURCE_DIR}/engine/body.cpp
  ${PROJECT_SOURCE_DIR}/engine/rotation/motion.cpp ${PROJECT_SOURCE_DIR}/engine/kept/bodies.cpp
  ${PROJECT_SOURCE_DIR}/engine/matrix.cpp ${PROJECT_SOURCE_DIR}/engine/block.cpp
  checker/chosen.cpp)
target_link_libraries(engine_units PUBLIC units_options PRIVATE workbook_lenient)
target_precompile_headers(engine_units PRIVATE checker/units.h <vector>)

get_property(sealed GLOBAL PROPERTY WORKBOOK_SEALED)
foreach(chapter ${chapters})
  get_property(name GLOBAL PROPERTY WORKBOOK_NAME_${chapter})
  get_property(uses GLOBAL PROPERTY WORKBOOK_USES_${chapter})
  list(TRANSFORM uses APPEND _units_file)
  foreach(one ${sealed})  # of a student's edition: the student's own
    list(TRANSFORM uses REPLACE "^${one}_units_file$" "${one}_units_mine_file")
  endforeach()

  add_library(${chapter}_units_tests OBJECT ${chapter}/units.cpp)
  add_library(${chapter}_units_file STATIC ${PROJECT_SOURCE_DIR}/solutions/${chapter}/${name}.cpp)
  add_library(${chapter}_units_mine_file STATIC
    ${PROJECT_SOURCE_DIR}/chapters/${chapter}/${name}.cpp)
  foreach(version tests file mine_file)
    target_link_libraries(${chapter}_units_${version} PUBLIC engine_units PRIVATE workbook_lenient)
    target_precompile_headers(${chapter}_units_${version} REUSE_FROM engine_units)
  endforeach()
  target_link_libraries(${chapter}_units_file PUBLIC ${uses})
  target_link_libraries(${chapter}_units_mine_file PUBLIC ${uses})
  set_target_properties(${chapter}_units_mine_file PROPERTIES EXCLUDE_FROM_ALL ON)

  set(tests $<TARGET_OBJECTS:${chapter}_units_tests>)
  add_executable(${chapter}_units ${tests})
  target_link_libraries(${chapter}_units PRIVATE ${chapter}_units_file)
  list_program(exercise ${chapter} units ${chapter}_units)
  add_executable(${chapter}_units_mine EXCLUDE_FROM_ALL ${tests})
  target_link_libraries(${chapter}_units_mine PRIVATE ${chapter}_units_mine_file)

  add_answers(${chapter}_units_answers_file units ${chapter} ${name})
  target_link_libraries(${chapter}_units_answers_file PRIVATE engine_units workbook_lenient)
  target_precompile_headers(${chapter}_units_answers_file REUSE_FROM engine_units)
  add_executable(${chapter}_units_answers ${tests} $<TARGET_OBJECTS:${chapter}_units_answers_file>)
  target_link_libraries(${chapter}_units_answers PRIVATE ${uses} engine_units)
  list_program(answers ${chapter} units ${chapter}_units_answers)
endforeach()
