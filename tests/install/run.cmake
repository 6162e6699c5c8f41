# Installs a finished build below `work`, then configures, builds and tests consumer/ against it as a stranger would:
# with flags of his own (-march=native: the layout of public types must not depend on the width of vectors).
# cmake -D build=DIR -D work=DIR -D generator=NAME -D compiler=PATH -D config=NAME -P run.cmake
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/prefix --config ${config})

# The installed tree stands by itself: no link and no path back to where it was built.
file(GLOB_RECURSE installed LIST_DIRECTORIES true ${work}/prefix/*)
foreach(path IN LISTS installed)
  if(IS_SYMLINK ${path})
    file(READ_SYMLINK ${path} target)
    if(IS_ABSOLUTE ${target})
      message(FATAL_ERROR "${path} was installed as a link to ${target}")
    endif()
  endif()
endforeach()
file(GLOB_RECURSE package_files ${work}/prefix/*.cmake)
foreach(path IN LISTS package_files)
  file(READ ${path} text)
  string(FIND "${text}" "${build}" position)
  if(NOT position EQUAL -1)
    message(FATAL_ERROR "${path} mentions the build folder ${build}")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${work}/consumer -G ${generator}
    -D CMAKE_BUILD_TYPE=${config} -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=-march=native
    -D CMAKE_PREFIX_PATH=${work}/prefix)
run(${CMAKE_COMMAND} --build ${work}/consumer --config ${config})
run(${CMAKE_CTEST_COMMAND} --test-dir ${work}/consumer -C ${config} --output-on-failure --no-tests=error)
