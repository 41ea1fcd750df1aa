# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# Run when a test program has been linked: writes an entry of ctest for each of its suites. A process a test would cost
# minutes: thousands of them take milliseconds, and each that builds a kernel would first read PoCL's own library.
#
#   cmake -D PROGRAM=… -D FILTER=… -D FOLDER=… -D PROPERTIES=… -D INTO=… -P discover_suites.cmake
execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${FILTER}
  WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE listed TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[A-Za-z0-9_/]+\\.\n" suites "${listed}")
if(NOT suites)
  message(FATAL_ERROR "no tests in ${PROGRAM}")
endif()
set(entries "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "\n(.*)\\.\n" "\\1" suite "${suite}")
  string(APPEND entries "add_test(${suite} \"${PROGRAM}\" \"--gtest_filter=${suite}.*\" --gtest_brief=1)\n"
    "set_tests_properties(${suite} PROPERTIES WORKING_DIRECTORY \"${FOLDER}\"")
  foreach(property IN LISTS PROPERTIES)
    string(APPEND entries " \"${property}\"")
  endforeach()
  string(APPEND entries ")\n")
endforeach()
file(WRITE ${INTO} "${entries}")
