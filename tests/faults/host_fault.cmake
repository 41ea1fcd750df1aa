# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# A planted fault is one expression of ours beside the mistake that could stand in its place. All of them are
# compiled into one program, which has one of them at a time: a build a fault would cost minutes.

# host_fault(NAME FILE … CASE … [OPENCL] PRINTED "…" PLANTED "…"): refuses a text that does not stand exactly once in
# FILE. With OPENCL the case holds that engine against the reference, and it is the difference that is noticed.
function(host_fault name)
  cmake_parse_arguments(arg "OPENCL" "FILE;PRINTED;PLANTED;CASE" "" ${ARGN})
  set(source ${PROJECT_SOURCE_DIR}/${arg_FILE})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(READ ${source} text)
  string(FIND "${text}" "${arg_PRINTED}" first)
  string(FIND "${text}" "${arg_PRINTED}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "planted fault: '${arg_PRINTED}' must stand exactly once in ${arg_FILE}")
  endif()

  get_property(count GLOBAL PROPERTY grainproof_host_faults)
  math(EXPR count "0${count} + 1")
  set_property(GLOBAL PROPERTY grainproof_host_faults ${count})
  get_property(known GLOBAL PROPERTY grainproof_faulty_files)
  if(arg_FILE IN_LIST known)
    get_property(text GLOBAL PROPERTY "grainproof_faulty:${arg_FILE}")
  else()
    set_property(GLOBAL APPEND PROPERTY grainproof_faulty_files ${arg_FILE})
    string(PREPEND text "#include \"tests/faults/planted.hpp\"\n")
  endif()
  set(either "(::grainproof::faults::planted == ${count} ? (${arg_PLANTED}) : (${arg_PRINTED}))")
  string(REPLACE "${arg_PRINTED}" "${either}" text "${text}")
  set_property(GLOBAL PROPERTY "grainproof_faulty:${arg_FILE}" "${text}")
  set(opencl false)
  if(arg_OPENCL)
    set(opencl true)
  endif()
  get_property(table GLOBAL PROPERTY grainproof_fault_table)
  string(APPEND table "    HostFault{\"${name}\", \"${arg_FILE}\", \"${arg_CASE}\", ${opencl}},\n")
  set_property(GLOBAL PROPERTY grainproof_fault_table "${table}")
endfunction()

# host_faults_program(TARGET SOURCES … RECOMPILE …): the faulty files, and the sources in RECOMPILE that faulty
# headers change, stand in for the libraries' own objects.
function(host_faults_program target)
  cmake_parse_arguments(arg "" "" "SOURCES;RECOMPILE" ${ARGN})
  set(tree ${CMAKE_CURRENT_BINARY_DIR}/faulty)
  get_property(files GLOBAL PROPERTY grainproof_faulty_files)
  get_property(table GLOBAL PROPERTY grainproof_fault_table)
  file(GENERATE OUTPUT ${tree}/host_fault_table.inc CONTENT "${table}")
  set(sources)
  set(exclude)
  foreach(file IN LISTS files)
    get_property(text GLOBAL PROPERTY "grainproof_faulty:${file}")
    file(GENERATE OUTPUT ${tree}/${file} CONTENT "${text}")
    get_filename_component(object ${file} NAME)
    if(file MATCHES "\\.cpp$")
      list(APPEND sources ${tree}/${file})
      list(APPEND exclude "/${object}\\.")
    endif()
  endforeach()
  foreach(source IN LISTS arg_RECOMPILE)
    get_filename_component(object ${source} NAME)
    list(APPEND sources ${PROJECT_SOURCE_DIR}/${source})
    list(APPEND exclude "/${object}\\.")
  endforeach()
  list(JOIN exclude "|" exclude)
  add_executable(${target} ${arg_SOURCES} ${sources}
    $<FILTER:$<TARGET_OBJECTS:grainproof_reference>,EXCLUDE,${exclude}>
    $<FILTER:$<TARGET_OBJECTS:grainproof_analytic>,EXCLUDE,${exclude}>)
  target_include_directories(${target} BEFORE PRIVATE ${tree})
  target_compile_definitions(${target} PRIVATE GRAINPROOF_VERSION="faulty")
  target_link_libraries(${target} PRIVATE grainproof_flags grainproof_input grainproof_comparisons
    grainproof_analytic grainproof_opencl grainproof_reference GTest::gtest GTest::gtest_main)
endfunction()
