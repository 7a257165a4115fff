# What the program says of itself, as files for the installation: completion of three shells and the
# manual page, packed as Debian wants it (no name and no time in it, so that same input is same bytes).
#
#   cmake -DPROGRAM=<gearwright> -DINTO=<folder> -P gw_made.cmake
function(say file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${INTO}/${file} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} ${ARGN} ended in ${status}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${INTO})
say(gearwright.bash completion bash)
say(_gearwright completion zsh)
say(gearwright.fish completion fish)
say(gearwright.1 manual)
find_program(GZIP gzip)
if(GZIP)
  execute_process(COMMAND ${GZIP} -9nkf ${INTO}/gearwright.1 COMMAND_ERROR_IS_FATAL ANY)
endif()
