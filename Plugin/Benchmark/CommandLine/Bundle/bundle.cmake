# Makes one archive of volumebench-run with every library that a bare system lacks; launch.sh says
# what lies where. Called by the target volumebench-bundle with
#   PROGRAM, EGL_LIBRARY, STRIP, LAUNCHER, SLURM, LICENSE: files; FOLDER: to work in; ARCHIVE: result
set(most_bytes 41943040) # 40 MiB

file(GET_RUNTIME_DEPENDENCIES
  RESOLVED_DEPENDENCIES_VAR found
  UNRESOLVED_DEPENDENCIES_VAR missing
  EXECUTABLES "${PROGRAM}"
  LIBRARIES "${EGL_LIBRARY}") # which the program opens by its name
if(missing)
  message(FATAL_ERROR "volumebench-run needs libraries that are not here: ${missing}")
endif()
list(APPEND found "${EGL_LIBRARY}")

set(glibc_names "^(ld-linux-x86-64|libc|libm|libmvec|libdl|libpthread|librt|libresolv|libutil)\\.so")
set(opengl_names "^lib(GL|GLX|OpenGL|EGL|GLdispatch)\\.so")
set(gcc_names "^lib(stdc\\+\\+|gcc_s)\\.so")

# Copies a library under the name that others ask for.
function(add_library_file file folder)
  get_filename_component(real "${file}" REALPATH)
  execute_process(COMMAND objdump -p "${real}" OUTPUT_VARIABLE headers COMMAND_ERROR_IS_FATAL ANY)
  get_filename_component(name "${file}" NAME)
  if(headers MATCHES "SONAME +([^\n ]+)")
    set(name "${CMAKE_MATCH_1}")
  endif()
  file(MAKE_DIRECTORY "${FOLDER}/${folder}")
  configure_file("${real}" "${FOLDER}/${folder}/${name}" COPYONLY)
  if(name MATCHES "^libVolumeBench")
    file(RPATH_REMOVE FILE "${FOLDER}/${folder}/${name}") # the folders of this machine
  endif()
  if(folder STREQUAL "lib")
    execute_process(COMMAND "${STRIP}" --strip-unneeded "${FOLDER}/lib/${name}" COMMAND_ERROR_IS_FATAL ANY)
  endif()
  if(name STREQUAL "libc.so.6")
    set(libc_folder "${real}" PARENT_SCOPE)
  endif()
endfunction()

file(REMOVE_RECURSE "${FOLDER}")
foreach(file IN LISTS found)
  get_filename_component(name "${file}" NAME)
  if(name MATCHES "${glibc_names}")
    add_library_file("${file}" glibc)
  elseif(name MATCHES "${opengl_names}")
    add_library_file("${file}" opengl)
  elseif(name MATCHES "${gcc_names}")
    add_library_file("${file}" gcc)
  else()
    add_library_file("${file}" lib)
  endif()
endforeach()

# Drivers ask for those parts of glibc, too, that it has merged into libc since.
get_filename_component(libc_folder "${libc_folder}" DIRECTORY)
foreach(name libdl.so.2 libpthread.so.0 librt.so.1 libm.so.6 libresolv.so.2 libutil.so.1
    ld-linux-x86-64.so.2)
  add_library_file("${libc_folder}/${name}" glibc)
endforeach()

execute_process(COMMAND getconf GNU_LIBC_VERSION OUTPUT_VARIABLE glibc_version COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[^0-9.]" "" glibc_version "${glibc_version}")
file(WRITE "${FOLDER}/glibc/version" "${glibc_version}\n")
file(STRINGS "${FOLDER}/gcc/libstdc++.so.6" gcc_versions REGEX "^GLIBCXX_3\\.4\\.[0-9]+$")
list(SORT gcc_versions COMPARE NATURAL)
list(GET gcc_versions -1 gcc_version)
file(WRITE "${FOLDER}/gcc/version" "${gcc_version}\n")

file(MAKE_DIRECTORY "${FOLDER}/bin")
configure_file("${PROGRAM}" "${FOLDER}/bin/volumebench-run" COPYONLY)
file(RPATH_REMOVE FILE "${FOLDER}/bin/volumebench-run")
execute_process(COMMAND "${STRIP}" "${FOLDER}/bin/volumebench-run" COMMAND_ERROR_IS_FATAL ANY)
configure_file("${LAUNCHER}" "${FOLDER}/volumebench-run" COPYONLY)
file(CHMOD "${FOLDER}/volumebench-run" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
file(COPY "${SLURM}" "${LICENSE}" DESTINATION "${FOLDER}")

get_filename_component(parent "${FOLDER}" DIRECTORY)
get_filename_component(name "${FOLDER}" NAME)
execute_process(COMMAND "${CMAKE_COMMAND}" -E tar cJf "${ARCHIVE}" "${name}"
  WORKING_DIRECTORY "${parent}" COMMAND_ERROR_IS_FATAL ANY)
file(SIZE "${ARCHIVE}" bytes)
if(bytes GREATER most_bytes)
  message(FATAL_ERROR "${ARCHIVE} has ${bytes} bytes; at most ${most_bytes} are wanted")
endif()
message(STATUS "${ARCHIVE}: ${bytes} bytes")
