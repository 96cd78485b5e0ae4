# Installs the library, then configures, builds and runs a project that finds it, once for each component. Variables: BUILD (the build folder), SOURCE
# (this folder), WORK (an empty folder to use), COMPILER.
file(REMOVE_RECURSE "${WORK}")
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()
step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
# The algorithms need nothing but the standard library, and Boost is behind the door.
set(without_algorithms -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON -DCMAKE_DISABLE_FIND_PACKAGE_GMP=ON)
set(without_door -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON)
foreach(component algorithms kernels door)
  step(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/${component} -DCOMPONENT=${component} -DCMAKE_PREFIX_PATH=${WORK}/prefix
       -DCMAKE_CXX_COMPILER=${COMPILER} ${without_${component}})
  step(${CMAKE_COMMAND} --build ${WORK}/${component})
  step(${WORK}/${component}/consumer)
endforeach()
