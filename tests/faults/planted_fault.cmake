# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# A planted fault is a copy of one of our files with one piece of its text replaced. A build from that
# copy must be judged wrong by the case that is named with it: the suite is proved to notice.
#
#   planted_fault(NAME LIBRARY reference FILE … PRINTED "…" PLANTED "…" CASE … ENGINE … [COMPILE a.cpp b.cpp])
#
# FILE is relative to the root. A fault in a header names in COMPILE the sources that it changes.
function(planted_fault name)
  cmake_parse_arguments(arg "" "LIBRARY;FILE;PRINTED;PLANTED;CASE;ENGINE" "COMPILE" ${ARGN})
  set(tree ${CMAKE_CURRENT_BINARY_DIR}/${name})
  plant(${arg_FILE} ${tree}/${arg_FILE} "${arg_PRINTED}" "${arg_PLANTED}")

  set(sources)
  set(exclude)
  foreach(source IN LISTS arg_COMPILE)
    list(APPEND sources ${PROJECT_SOURCE_DIR}/${source})
  endforeach()
  if(arg_FILE MATCHES "\\.cpp$")
    list(APPEND sources ${tree}/${arg_FILE})
  endif()
  foreach(source IN LISTS arg_COMPILE arg_FILE)
    get_filename_component(object ${source} NAME)
    list(APPEND exclude "/${object}\\.")
  endforeach()
  list(JOIN exclude "|" exclude)

  # The faulty objects stand in for the library's own; the other libraries are linked as they are.
  add_executable(fault_${name} verdict_on_fault.cpp ${sources}
    $<FILTER:$<TARGET_OBJECTS:grainproof_${arg_LIBRARY}>,EXCLUDE,${exclude}>)
  target_include_directories(fault_${name} BEFORE PRIVATE ${tree})
  target_compile_definitions(fault_${name} PRIVATE GRAINPROOF_VERSION="faulty")
  target_link_libraries(fault_${name} PRIVATE grainproof_flags grainproof_input grainproof_comparisons
    grainproof_analytic grainproof_reference)
  add_test(NAME Faults.${name} COMMAND fault_${name} ${PROJECT_SOURCE_DIR}/scenes/${arg_CASE}.toml)
  set_tests_properties(Faults.${name} PROPERTIES LABELS faults TIMEOUT 300)
endfunction()

# Writes FROM with PRINTED replaced to TO, and refuses a text that does not stand there exactly once.
function(plant from to printed planted)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${from})
  file(READ ${PROJECT_SOURCE_DIR}/${from} text)
  string(FIND "${text}" "${printed}" first)
  string(FIND "${text}" "${printed}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "planted fault: '${printed}' must stand exactly once in ${from}")
  endif()
  string(REPLACE "${printed}" "${planted}" text "${text}")
  file(GENERATE OUTPUT ${to} CONTENT "${text}")
endfunction()
