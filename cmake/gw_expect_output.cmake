# Runs a program and compares its output exactly with the last comment of its source:
#
#   /* prints
#   contact ratio 2.2772
#   */
#
#   PROGRAM   the program to run, in the working directory      SOURCE   the .cpp with the comment
#
# If GW_WRITE_DOCS is set in the environment, the comment is written again instead.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ends with ${status}; it printed\n${printed}")
endif()
file(READ ${SOURCE} text)
string(FIND "${text}" "\n/* prints\n" at REVERSE)
if(DEFINED ENV{GW_WRITE_DOCS})
  string(SUBSTRING "${text}" 0 ${at} program)
  string(STRIP "${program}" program)
  file(WRITE ${SOURCE} "${program}\n\n/* prints\n${printed}*/\n")
  return()
endif()
if(at EQUAL -1)
  message(FATAL_ERROR "${SOURCE} does not end with /* prints")
endif()
string(SUBSTRING "${text}" ${at} -1 expected)
if(NOT expected STREQUAL "\n/* prints\n${printed}*/\n")
  message(FATAL_ERROR "${SOURCE} says${expected}but the program prints\n${printed}")
endif()
