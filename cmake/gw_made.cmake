# Writes files for the installation with the program itself: completion for three shells and the
# manual page. The page is packed as Debian requires, without a name and a time, so that the same
# input gives the same bytes.
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
