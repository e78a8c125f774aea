# Installs a build to a fresh prefix, then configures, builds and runs the project beside this
# script against it, and runs the installed program.
# cmake -DBUILD_DIR=<build tree> -DWORK_DIR=<scratch folder, emptied> [-DCONFIG=Release]
#       [-DGENERATOR=Ninja] [-DCXX=g++] [-DCXX_FLAGS=...] -P consume.cmake
cmake_minimum_required(VERSION 3.25)
foreach(needed BUILD_DIR WORK_DIR)
  if(NOT ${needed})
    message(FATAL_ERROR "consume.cmake needs -D${needed}=...")
  endif()
endforeach()
if(NOT GENERATOR)
  set(GENERATOR Ninja)
endif()
if(NOT CXX)
  set(CXX c++)
endif()
if(NOT CONFIG)
  set(CONFIG Release)
endif()

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "failed with ${result}: ${command}")
  endif()
endfunction()

set(prefix ${WORK_DIR}/prefix)
set(build ${WORK_DIR}/build)
file(REMOVE_RECURSE ${prefix} ${build})

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix} --config ${CONFIG})
# What the package leaves to others is found in the system; shedlight itself only in the prefix.
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${build} -G ${GENERATOR}
    -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
    -DCMAKE_PREFIX_PATH=${prefix} -DSHEDLIGHT_INCLUDE_DIR=${prefix}/include/shedlight
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${build} --config ${CONFIG})
run(${build}/core)
run(${build}/period)
if(EXISTS ${prefix}/bin/shedlight)
  run(${prefix}/bin/shedlight --version)
endif()
