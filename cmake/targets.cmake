# How targets are made: everything twice (double, float), a chapter's files in their versions.

# In another project's build the targets have names of their own, and what it sets stays as it is.
set(WORKBOOK_PREFIX "")
if(NOT PROJECT_IS_TOP_LEVEL)
  set(WORKBOOK_PREFIX joints_)
endif()

# What every source is compiled with. No contraction to fused multiply-add and no -march=native:
# the same digits on every machine. Sections and their collection: a program carries what it uses.
add_library(workbook_options INTERFACE)
target_compile_features(workbook_options INTERFACE cxx_std_20)
target_include_directories(workbook_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_definitions(workbook_options INTERFACE GLM_FORCE_EXPLICIT_CTOR)
target_compile_options(workbook_options INTERFACE
  -ffp-contract=off -ffunction-sections -fdata-sections)
if(APPLE)  # its linker calls it so
  target_link_options(workbook_options INTERFACE -Wl,-dead_strip)
else()
  target_link_options(workbook_options INTERFACE -Wl,--gc-sections)
endif()
target_link_libraries(workbook_options INTERFACE glm::glm)
if(WORKBOOK_SANITIZE)
  # A null pointer stops a program anyway; the checks that are left out take a third of the time.
  target_compile_options(workbook_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize=null,alignment,vptr -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  target_link_options(workbook_options INTERFACE -fsanitize=address,undefined)
endif()

# The workbook's own sources are compiled with every warning. That none is left is seen to where
# the workbook is made: another compiler's new warning must not stop a reader.
option(WORKBOOK_WARNINGS_AS_ERRORS "Stop at a warning in the workbook's own sources" OFF)
add_library(workbook_strict INTERFACE)
target_compile_options(workbook_strict INTERFACE -Wall -Wextra -Wpedantic)
if(WORKBOOK_WARNINGS_AS_ERRORS)
  target_compile_options(workbook_strict INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # g++ 12 sees overlaps in std::string that are not there
  target_compile_options(workbook_strict INTERFACE -Wno-restrict)
endif()
# A reader's file may be half written: no word about what is not used yet, and no warning stops it,
# but for what would make a crash or a number without a reason: a forgotten return, a variable that
# is read before it is set. Where the compiler cannot see the latter, the variable holds a huge
# number instead of the zero that happens to lie there. An index outside a vector stops the program
# at once: without the check it reads what happens to lie there. So does an array of the function
# that is too small.
add_library(workbook_lenient INTERFACE)
target_compile_definitions(workbook_lenient INTERFACE _GLIBCXX_ASSERTIONS)
target_compile_options(workbook_lenient INTERFACE -fstack-protector-strong
  -Wall -Wextra -Werror=return-type -Werror=uninitialized
  -Wno-unused-parameter -Wno-unused-variable -Wno-unused-but-set-variable)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(workbook_lenient INTERFACE -Werror=maybe-uninitialized)
endif()
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-ftrivial-auto-var-init=pattern WORKBOOK_HAS_PATTERN)
if(WORKBOOK_HAS_PATTERN)
  target_compile_options(workbook_lenient INTERFACE -ftrivial-auto-var-init=pattern)
endif()

# at_once(targets...): all of a target's sources are compiled as one, which is faster than the
# headers again for each of them. Those with options of their own stay apart.
function(at_once)
  foreach(target ${ARGN})
    get_target_property(sources ${target} SOURCES)
    list(LENGTH sources count)
    if(count GREATER 1)
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    endif()
  endforeach()
endfunction()

# add_twice(NAME KIND sources...): NAME in double and NAME_float. They may become part of a shared
# library or a plug-in; whether their functions call each other through a table is no use to anyone.
check_cxx_compiler_flag(-fno-semantic-interposition WORKBOOK_HAS_INTERPOSITION)
function(add_twice bare kind)
  foreach(suffix "" "_float")
    set(name ${WORKBOOK_PREFIX}${bare})
    add_library(${name}${suffix} ${kind} ${ARGN})
    set_target_properties(${name}${suffix} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    if(WORKBOOK_HAS_INTERPOSITION)
      target_compile_options(${name}${suffix} PRIVATE -fno-semantic-interposition)
    endif()
    target_link_libraries(${name}${suffix} PUBLIC workbook_options PRIVATE workbook_strict)
    if(suffix STREQUAL "_float")
      target_compile_definitions(${name}${suffix} PUBLIC JOINTS_REAL=float)
    endif()
    at_once(${name}${suffix})
  endforeach()
endfunction()

# link_twice(NAME PUBLIC targets...): each to its own kind of number.
function(link_twice name scope)
  foreach(suffix "" "_float")
    foreach(target ${ARGN})
      target_link_libraries(${WORKBOOK_PREFIX}${name}${suffix} ${scope}
        ${WORKBOOK_PREFIX}${target}${suffix})
    endforeach()
  endforeach()
endfunction()

# The stub that is made from a solution.
function(make_stub out solution)
  add_custom_command(OUTPUT ${out}
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/base/exercises.py ${solution} ${out}
    DEPENDS ${PROJECT_SOURCE_DIR}/tools/base/exercises.py ${solution} COMMENT "" VERBATIM)
endfunction()

# add_exercise_file(TARGET SOURCE libraries...): one version of an exercise file of a reader's, with
# the given sources that call it.
function(add_exercise_file target source given)
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${source} ${given})
  target_link_libraries(${target} PUBLIC workbook_options ${ARGN} PRIVATE workbook_lenient)
endfunction()

# add_chapter(NN_name name [GIVEN sources...] [USES earlier chapters...]) makes
#   NN_name, NN_name_float   the solution          NN_name_mine   the reader's file
#   NN_name_run              program/*.cpp on the solution, NN_name_run_mine on the reader's file,
#                            its unwritten exercises filled in from the solution
# GIVEN sources stand beside the exercise file and call it.
# Later chapters use the solutions of earlier ones, so that an unfinished one blocks nothing. Of
# the library alone only the solutions are wanted.
function(add_chapter chapter name)
  cmake_parse_arguments(arg "" "" "GIVEN;USES" ${ARGN})
  file(GLOB program CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/${chapter}/program/*.cpp)
  set(solution ${PROJECT_SOURCE_DIR}/solutions/${chapter}/${name}.cpp)
  set(mine ${PROJECT_SOURCE_DIR}/chapters/${chapter}/${name}.cpp)
  set(mixed ${PROJECT_BINARY_DIR}/mixed/${chapter}/${name}.cpp)  # written by ./wb run
  # In a student's edition a stub stands in the place of a solution, until the chapter is over.
  file(STRINGS ${solution} open_lines REGEX "^ *todo\\(\"")
  if(open_lines)
    set_property(GLOBAL APPEND PROPERTY WORKBOOK_SEALED ${chapter})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${solution})
  endif()
  get_property(sealed GLOBAL PROPERTY WORKBOOK_SEALED)
  set(earlier "")
  set(earlier_mine "")
  foreach(used ${arg_USES})
    if(used IN_LIST sealed)
      list(APPEND earlier ${used}_mine)
    else()
      list(APPEND earlier ${used})
    endif()
    list(APPEND earlier_mine ${used}_mine)
  endforeach()
  if(NOT WORKBOOK_ALL_MINE)
    set(earlier_mine ${earlier})
  endif()

  list(TRANSFORM arg_GIVEN PREPEND ${PROJECT_SOURCE_DIR}/chapters/${chapter}/)
  add_twice(${chapter} STATIC ${solution} ${arg_GIVEN})
  link_twice(${chapter} PUBLIC engine ${arg_USES})
  set_property(GLOBAL APPEND PROPERTY WORKBOOK_CHAPTERS ${chapter})
  if(WORKBOOK_LIBRARY_ONLY)
    return()
  endif()
  set(given "")
  if(arg_GIVEN)  # of the reader's versions
    add_library(${chapter}_given OBJECT EXCLUDE_FROM_ALL ${arg_GIVEN})
    target_link_libraries(${chapter}_given PRIVATE engine ${arg_USES} workbook_strict)
    at_once(${chapter}_given)
    set(given $<TARGET_OBJECTS:${chapter}_given>)
  endif()
  set_property(GLOBAL PROPERTY WORKBOOK_GIVEN_${chapter} ${given})
  add_exercise_file(${chapter}_mine ${mine} "${given}" engine ${earlier_mine})
  # Only tests run it, for milliseconds, and a reader waits for its compiler.
  target_compile_options(${chapter}_mine PRIVATE $<$<CONFIG:Release>:-O1>)
  if(arg_GIVEN)  # a chapter with many headers: they are read once, and what is given is compiled
    target_precompile_headers(${chapter}_mine PRIVATE
      ${PROJECT_SOURCE_DIR}/chapters/${chapter}/${name}.h <set>)
  endif()

  if(NOT EXISTS ${mixed})
    configure_file(${solution} ${mixed} COPYONLY)
  endif()
  add_exercise_file(${chapter}_mixed ${mixed} "${given}" engine ${earlier})

  foreach(kind "" "_mixed")
    set(run ${chapter}_run)
    if(kind STREQUAL "_mixed")
      set(run ${chapter}_run_mine)
    endif()
    add_executable(${run} ${program})
    target_link_libraries(${run} PRIVATE ${chapter}${kind} instruments workbook_strict)
    # Its loops are in the libraries. It compiles in three quarters of the time, and runs about as
    # fast.
    target_compile_options(${run} PRIVATE $<$<CONFIG:Release>:-O1>)
    at_once(${run})
  endforeach()
  set_target_properties(${chapter}_run_mine PROPERTIES EXCLUDE_FROM_ALL ON)
  set_property(GLOBAL PROPERTY WORKBOOK_NAME_${chapter} ${name})
  set_property(GLOBAL PROPERTY WORKBOOK_USES_${chapter} ${arg_USES})
endfunction()

# use_best_instructions(NN_name): a chapter's file and all that use it may have the 32 byte registers
# of an x86 processor, if the one that builds has them. None of it is installed: what goes elsewhere
# chooses where it runs (engine/simd/iterate.cpp).
function(use_best_instructions chapter)
  include(CheckCXXSourceRuns)
  check_cxx_source_runs("
    int main() {
    #ifdef __x86_64__
      return __builtin_cpu_supports(\"avx2\") ? 0 : 1;
    #else
      return 1;
    #endif
    }" WORKBOOK_HAS_AVX2)
  set(options -Wno-psabi)  # vectors never pass by value between what is compiled in two ways
  if(WORKBOOK_HAS_AVX2)
    list(APPEND options -mavx2)
  endif()
  foreach(version "" _float _mine _mixed)
    target_compile_options(${chapter}${version} PUBLIC ${options})
  endforeach()
  set_property(GLOBAL PROPERTY WORKBOOK_OPTIONS_${chapter} ${options})
  set_property(GLOBAL APPEND PROPERTY WORKBOOK_STAYS_HOME ${chapter})
endfunction()
