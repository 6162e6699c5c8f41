# Build functions of Burmester. Its own rooms use them, and so can people who write a module:
# find_package(burmester) makes them available.
#
#   burmester_add_room(<room> ...)         a folder of sources and headers becomes the library burmester::<room>
#   burmester_add_conformance(<room>)      its headers conformance*.hpp become burmester::conformance
#   burmester_add_test(<name> ...)         a GoogleTest executable, each of its tests known to ctest
#   burmester_enable_intervals(<target>)   lets a target compile interval arithmetic
include_guard(GLOBAL)
include(GNUInstallDirs)

set(BURMESTER_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion)

# burmester_add_room(<room> [LINKS <targets>...] [PRIVATE_LINKS <targets>...])
#
# Makes the target burmester_<room>, alias burmester::<room>, of all *.cpp and *.hpp in the current folder and below.
# Headers stand beside their sources and are included as <burmester/<room>/...>, in the tree as after installation:
# <build>/include/burmester/<room> is a link to this folder. With BURMESTER_INSTALL the room is installed and belongs
# to the export set ${PROJECT_NAME}Targets. Without any *.cpp it is an INTERFACE library.
function(burmester_add_room room)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "LINKS;PRIVATE_LINKS")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.hpp)
  list(FILTER headers EXCLUDE REGEX "(^|/)conformance[^/]*$")

  if(sources)
    add_library(burmester_${room} ${sources})
    target_link_libraries(burmester_${room} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  else()
    add_library(burmester_${room} INTERFACE)
    target_link_libraries(burmester_${room} INTERFACE ${ARG_LINKS})
  endif()

  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include/burmester)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/include/burmester/${room} SYMBOLIC)
  # A header that its own source includes first compiles alone; only the others must be verified.
  set(first_in_source "")
  foreach(header IN LISTS headers)
    cmake_path(REPLACE_EXTENSION header cpp OUTPUT_VARIABLE source)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${source})
      file(STRINGS ${source} include REGEX "^#include" LIMIT_COUNT 1)
      if(include STREQUAL "#include \"burmester/${room}/${header}\"")
        list(APPEND first_in_source ${header})
      endif()
    endif()
  endforeach()
  list(REMOVE_ITEM headers ${first_in_source})
  list(TRANSFORM headers PREPEND ${room}/)
  list(TRANSFORM first_in_source PREPEND ${room}/)
  burmester_finish_library(burmester_${room} HEADERS ${headers} VERIFIED_HEADERS ${first_in_source})
endfunction()

# burmester_add_conformance(<room>): the headers conformance*.hpp of a room, the laws as typed test suites. They need
# GoogleTest, which the room itself does not; so they are a target of their own, burmester::conformance.
function(burmester_add_conformance room)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} conformance*.hpp)
  list(TRANSFORM headers PREPEND ${room}/)
  if(NOT TARGET GTest::gtest)
    set(CMAKE_VERIFY_INTERFACE_HEADER_SETS OFF)  # a build without tests installs these headers unread
  endif()
  add_library(burmester_conformance INTERFACE)
  target_link_libraries(burmester_conformance INTERFACE burmester::${room} GTest::gtest)
  burmester_finish_library(burmester_conformance HEADERS ${headers} EXPORT ${PROJECT_NAME}ConformanceTargets)
endfunction()

# burmester_add_test(<name> SOURCES <files>... [LINKS <targets>...])
function(burmester_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;LINKS")
  include(GoogleTest)
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gmock_main)
  burmester_set_warnings(${name})
  gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 PROPERTIES LABELS ${name} TIMEOUT 600)
endfunction()

# burmester_enable_intervals(<target>): interval arithmetic (CGAL's Interval_nt) switches the rounding mode of the
# processor. A compiler that is not told of it folds 1/3 into a constant, and the box that should contain the truth does
# not. No other target may compile such code. CGAL's headers are found, but CGAL is not linked: the class is inline.
function(burmester_enable_intervals target)
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-frounding-math>)
  target_include_directories(${target} SYSTEM PRIVATE $<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()

# ---- For the functions above and Burmester's own programs ----

function(burmester_set_warnings target)
  target_compile_options(${target} PRIVATE ${BURMESTER_WARNINGS} $<$<BOOL:${BURMESTER_WERROR}>:-Werror>)
endfunction()

# burmester_finish_library(<target> [HEADERS <paths below include/burmester>...] [VERIFIED_HEADERS <such paths>...]
#                          [EXPORT <export set>]):
# alias, header sets, warnings, version, installation. VERIFIED_HEADERS are known to compile alone.
function(burmester_finish_library target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "EXPORT" "HEADERS;VERIFIED_HEADERS")
  if(NOT ARG_EXPORT)
    set(ARG_EXPORT ${PROJECT_NAME}Targets)
  endif()
  string(REGEX REPLACE "^burmester_" "" name ${target})
  add_library(burmester::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})

  get_target_property(type ${target} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(scope INTERFACE)
  else()
    set(scope PUBLIC)
    burmester_set_warnings(${target})
    set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  endif()
  set(include_dir ${PROJECT_BINARY_DIR}/include)
  list(TRANSFORM ARG_HEADERS PREPEND ${include_dir}/burmester/)
  list(TRANSFORM ARG_VERIFIED_HEADERS PREPEND ${include_dir}/burmester/)
  target_sources(${target} ${scope}
    FILE_SET HEADERS BASE_DIRS ${include_dir} FILES ${ARG_HEADERS}
    FILE_SET verified_headers TYPE HEADERS BASE_DIRS ${include_dir} FILES ${ARG_VERIFIED_HEADERS})
  set_target_properties(${target} PROPERTIES INTERFACE_HEADER_SETS_TO_VERIFY HEADERS)

  if(BURMESTER_INSTALL)
    install(TARGETS ${target} EXPORT ${ARG_EXPORT} FILE_SET HEADERS FILE_SET verified_headers)
  endif()
endfunction()
