# Flags that every target of ours is compiled with. VTK modules are passed by their module name.
function(volumebench_compile_options target)
  get_target_property(aliased "${target}" ALIASED_TARGET)
  if(aliased)
    set(target "${aliased}")
  endif()
  target_compile_options("${target}" PRIVATE -Wall -Wextra)
  if(VOLUMEBENCH_WARNINGS_AS_ERRORS)
    target_compile_options("${target}" PRIVATE -Werror)
  endif()
endfunction()

# The first report ends the program, so that no test passes with one.
if(VOLUMEBENCH_SANITIZE)
  set(sanitizers -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all)
  add_compile_options(${sanitizers} -fno-omit-frame-pointer)
  add_link_options(${sanitizers})
endif()
