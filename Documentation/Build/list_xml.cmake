# cmake -P: writes the plugin's XML, with all techniques that there are, into the working directory
# and prints the files' paths, one a line.
cmake_minimum_required(VERSION 3.25)
get_filename_component(PROJECT_SOURCE_DIR "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(VOLUMEBENCH_CUDA_FOUND TRUE)
include("${PROJECT_SOURCE_DIR}/CMake/VolumeBenchTechniques.cmake")
include("${PROJECT_SOURCE_DIR}/Plugin/Techniques.cmake")
volumebench_generate_plugin_xml(files)
foreach(file IN LISTS files)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E echo "${file}")
endforeach()
