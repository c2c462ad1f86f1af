# The machinery behind Plugin/Techniques.cmake. A row is
#   volumebench_technique(<id> CLASS <Class> LABEL "<label in ParaView>" [SETTINGS <name>...]
#     [WITHOUT <name>...] [FOLDER <folder>] [REQUIRES <variable> "<what that is>"])
# and gives: the factory entry, the source pair Techniques/<Class>.h/.cxx, the representation type
# in ParaView's list, its panel, and a case in every image test. SETTINGS are the properties that
# the panel shows for this technique and not for all, WITHOUT those that it shows for all but a few.
# FOLDER, below the root, holds the pair in place of Techniques/; a build in which the variable that
# REQUIRES names is false has no such technique.
set(volumebench_technique_ids "")
set(volumebench_left_out_rows "")
set(volumebench_technique_settings InteractiveFrameTime MemoryBudget ErrorTarget Skipping TerminationThreshold RaySetUp Jitter JitterSeed
  WorkGroupShape OpenclDevice OpenclStorage PictureTransfer VoxelOrder SliceExtent SliceOrder
  SliceTarget SliceThreads)
set(volumebench_common_settings StepVoxels Integrator)

function(volumebench_expect_known id names known)
  foreach(name IN LISTS names)
    if(NOT "${name}" IN_LIST known)
      list(JOIN known ", " known)
      message(FATAL_ERROR "volumebench_technique(${id}): there is no ${name} here; known are ${known}")
    endif()
  endforeach()
endfunction()

function(volumebench_technique id)
  cmake_parse_arguments(PARSE_ARGV 1 row "" "CLASS;LABEL;FOLDER" "REQUIRES;SETTINGS;WITHOUT")
  if(NOT row_CLASS OR NOT row_LABEL OR row_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "volumebench_technique(${id}): CLASS and LABEL are needed, nothing else "
      "but SETTINGS, WITHOUT, FOLDER and REQUIRES")
  endif()
  if(row_REQUIRES)
    list(LENGTH row_REQUIRES words)
    if(NOT words EQUAL 2)
      message(FATAL_ERROR "volumebench_technique(${id}): REQUIRES takes a variable and what it stands for")
    endif()
    list(GET row_REQUIRES 0 variable)
    list(GET row_REQUIRES 1 requirement)
    if(NOT "${${variable}}")
      string(APPEND volumebench_left_out_rows "    { \"${id}\", \"${requirement}\" },\n")
      set(volumebench_left_out_rows "${volumebench_left_out_rows}" PARENT_SCOPE)
      return()
    endif()
  endif()
  if(NOT row_FOLDER)
    set(row_FOLDER Techniques)
  endif()
  volumebench_expect_known("${id}" "${row_SETTINGS}" "${volumebench_technique_settings}")
  volumebench_expect_known("${id}" "${row_WITHOUT}" "${volumebench_common_settings}")
  if("${id}" IN_LIST volumebench_technique_ids)
    message(FATAL_ERROR "volumebench_technique(${id}): this technique is listed twice")
  endif()
  list(APPEND volumebench_technique_ids "${id}")
  set(volumebench_technique_ids "${volumebench_technique_ids}" PARENT_SCOPE)
  set("volumebench_class_${id}" "${row_CLASS}" PARENT_SCOPE)
  set("volumebench_folder_${id}" "${row_FOLDER}" PARENT_SCOPE)
  set("volumebench_label_${id}" "${row_LABEL}" PARENT_SCOPE)
  set(settings ${volumebench_common_settings} ${row_SETTINGS})
  if(row_WITHOUT)
    list(REMOVE_ITEM settings ${row_WITHOUT})
  endif()
  set("volumebench_settings_${id}" "${settings}" PARENT_SCOPE)
endfunction()

# Writes the decorator that shows a property's row only while a technique with that setting is chosen, and the
# hints with it alone.
function(volumebench_shown_for setting decorator_variable hints_variable)
  set(conditions "")
  foreach(id IN LISTS volumebench_technique_ids)
    if("${setting}" IN_LIST "volumebench_settings_${id}")
      string(APPEND conditions
        "              <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\"\n"
        "                property=\"Representation\" value=\"${volumebench_label_${id}}\" />\n")
    endif()
  endforeach()
  if(NOT conditions)
    # No technique of this build has the setting; no representation is called so.
    string(CONCAT conditions
      "              <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\"\n"
      "                property=\"Representation\" value=\"none\" />\n")
  endif()
  string(CONCAT decorator
    "          <PropertyWidgetDecorator type=\"CompositeDecorator\">\n"
    "            <Expression type=\"or\">\n"
    "${conditions}"
    "            </Expression>\n"
    "          </PropertyWidgetDecorator>")
  set("${decorator_variable}" "${decorator}" PARENT_SCOPE)
  set("${hints_variable}" "        <Hints>\n${decorator}\n        </Hints>" PARENT_SCOPE)
endfunction()

# Writes the factory table from the rows; its source goes to the variable named `source_variable`.
function(volumebench_generate_technique_table template source_variable)
  set(TECHNIQUE_INCLUDES "")
  set(TECHNIQUE_ROWS "")
  foreach(id IN LISTS volumebench_technique_ids)
    set(class "${volumebench_class_${id}}")
    string(APPEND TECHNIQUE_INCLUDES "#include \"${volumebench_folder_${id}}/${class}.h\"\n")
    string(APPEND TECHNIQUE_ROWS
      "    { \"${id}\", \"${volumebench_label_${id}}\",\n"
      "      []() -> std::unique_ptr<Technique> { return std::make_unique<${class}>(); } },\n")
  endforeach()
  set(LEFT_OUT_ROWS "${volumebench_left_out_rows}")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/TechniqueTable.cxx")
  configure_file("${template}" "${source}" @ONLY)
  set("${source_variable}" "${source}" PARENT_SCOPE)
endfunction()

# Writes a server-manager XML file of the plugin from its template and the rows; @NAME@ in it stands
# for the text of each further argument NAME=FILE.
function(volumebench_generate_xml template xml_variable)
  set(REPRESENTATION_TYPES "")
  set(REPRESENTATION_DECORATORS "")
  set(OTHER_REPRESENTATION_DECORATORS "")
  foreach(id IN LISTS volumebench_technique_ids)
    set(label "${volumebench_label_${id}}")
    string(APPEND REPRESENTATION_TYPES
      "      <RepresentationType subproxy=\"VolumeBenchRepresentation\"\n"
      "                          text=\"${label}\" subtype=\"${id}\" />\n")
    string(APPEND REPRESENTATION_DECORATORS
      "                  <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\"\n"
      "                    property=\"Representation\" value=\"${label}\" />\n")
    string(APPEND OTHER_REPRESENTATION_DECORATORS
      "                  <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\"\n"
      "                    property=\"Representation\" value=\"${label}\" inverse=\"1\" />\n")
  endforeach()
  foreach(setting IN LISTS volumebench_common_settings volumebench_technique_settings)
    volumebench_shown_for("${setting}" "DECORATOR_FOR_${setting}" "SHOWN_FOR_${setting}")
  endforeach()
  list(JOIN volumebench_technique_ids ", " TECHNIQUE_IDS)
  foreach(part IN LISTS ARGN)
    string(REGEX MATCH "^([A-Z_]+)=(.+)$" matched "${part}")
    configure_file("${CMAKE_MATCH_2}" "${CMAKE_CURRENT_BINARY_DIR}/${CMAKE_MATCH_1}.xml" @ONLY)
    file(READ "${CMAKE_CURRENT_BINARY_DIR}/${CMAKE_MATCH_1}.xml" "${CMAKE_MATCH_1}")
  endforeach()
  get_filename_component(name "${template}" NAME_WLE)
  set(xml "${CMAKE_CURRENT_BINARY_DIR}/${name}")
  configure_file("${template}" "${xml}" @ONLY)
  set("${xml_variable}" "${xml}" PARENT_SCOPE)
endfunction()

# Writes all server-manager XML of the plugin, and lists the files in the variable. Needs no ParaView:
# the reference in the documentation is made of them too.
function(volumebench_generate_plugin_xml files_variable)
  set(rows "${PROJECT_SOURCE_DIR}/Representations/ParaView")
  set(benchmark "${PROJECT_SOURCE_DIR}/Plugin/Benchmark")
  volumebench_generate_xml("${rows}/Representations.xml.in" representations_xml
    "DEVICE_ROWS=${rows}/DeviceRows.xml.in"
    "OPENCL_ROWS=${rows}/OpenClRows.xml.in"
    "SLICE_ROWS=${rows}/SliceRows.xml.in"
    "READ_ONLY_ROWS=${rows}/ReadOnlyRows.xml.in"
    "PANEL_GROUPS=${rows}/PanelGroups.xml.in")
  volumebench_generate_xml("${benchmark}/Benchmark.xml.in" benchmark_xml)
  volumebench_generate_xml("${benchmark}/Stability/Stability.xml.in" stability_xml)
  set("${files_variable}"
    "${representations_xml}"
    "${benchmark_xml}"
    "${benchmark}/ErrorChart.xml"
    "${stability_xml}"
    "${PROJECT_SOURCE_DIR}/Plugin/Readers/Readers.xml"
    PARENT_SCOPE)
endfunction()
