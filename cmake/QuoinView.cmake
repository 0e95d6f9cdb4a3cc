# SPDX-License-Identifier: Apache-2.0
# Builds web/ into HTML files, one for each kind of page, and embeds them into the library: what quoin/view/page.cc,
# picture_page.cc, sphere_page.cc, plan_page.cc and layered_page.cc write into.
# Everything npm writes lies in the build tree. Without Node.js the library still builds, and write_page says what is missing.
if(NOT QUOIN_VIEW)
  return()
endif()

find_program(NODE_PROGRAM NAMES node nodejs)
find_program(NPM_PROGRAM npm)
set(node_version 0)
if(NODE_PROGRAM)
  execute_process(COMMAND "${NODE_PROGRAM}" --version OUTPUT_VARIABLE node_version OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX REPLACE "^v" "" node_version "${node_version}")
endif()
if(NOT NPM_PROGRAM OR node_version VERSION_LESS 18)
  message(WARNING "The browser view needs npm and Node.js 18 or newer: built without it. -DQUOIN_VIEW=OFF silences this.")
  return()
endif()

set(web_source "${PROJECT_SOURCE_DIR}/web")
set(web_build "${PROJECT_BINARY_DIR}/web")
set(web_lock package.json package-lock.json .npmrc)
set(web_config index.html picture.html sphere.html plan.html layers.html tsconfig.json vite.config.ts)
file(GLOB_RECURSE web_files RELATIVE "${web_source}" CONFIGURE_DEPENDS
  "${web_source}/src/*.ts" "${web_source}/src/*.css")
list(APPEND web_files ${web_config})
list(TRANSFORM web_lock PREPEND "${web_source}/" OUTPUT_VARIABLE web_lock_paths)
list(TRANSFORM web_files PREPEND "${web_source}/" OUTPUT_VARIABLE web_paths)

add_custom_command(
  OUTPUT "${web_build}/installed"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${web_build}"
  COMMAND "${CMAKE_COMMAND}" -E copy ${web_lock_paths} "${web_build}"
  COMMAND "${NPM_PROGRAM}" install --no-audit --no-fund --loglevel=error
  COMMAND "${CMAKE_COMMAND}" -E touch "${web_build}/installed"
  WORKING_DIRECTORY "${web_build}"
  DEPENDS ${web_lock_paths}
  COMMENT "Installing what the browser view is built with (skip the view with -DQUOIN_VIEW=OFF)"
  VERBATIM)
list(TRANSFORM web_config PREPEND "${web_source}/" OUTPUT_VARIABLE web_config_paths)
set(embed_page "${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake")
set(page_templates page_template.cc picture_template.cc sphere_template.cc plan_template.cc layers_template.cc)
list(TRANSFORM page_templates PREPEND "${web_build}/")
add_custom_command(
  OUTPUT ${page_templates}
  COMMAND "${CMAKE_COMMAND}" -E rm -rf src dist
  COMMAND "${CMAKE_COMMAND}" -E copy ${web_config_paths} "${web_build}"
  COMMAND "${CMAKE_COMMAND}" -E copy_directory "${web_source}/src" "${web_build}/src"
  COMMAND "${NPM_PROGRAM}" run --silent build
  COMMAND "${CMAKE_COMMAND}" -DFROM=dist/index.html -DTO=page_template.cc -DNAME=built_page_template -P "${embed_page}"
  COMMAND "${CMAKE_COMMAND}" -DFROM=dist/picture.html -DTO=picture_template.cc -DNAME=built_picture_template
          -P "${embed_page}"
  COMMAND "${CMAKE_COMMAND}" -DFROM=dist/sphere.html -DTO=sphere_template.cc -DNAME=built_sphere_template
          -P "${embed_page}"
  COMMAND "${CMAKE_COMMAND}" -DFROM=dist/plan.html -DTO=plan_template.cc -DNAME=built_plan_template -P "${embed_page}"
  COMMAND "${CMAKE_COMMAND}" -DFROM=dist/layers.html -DTO=layers_template.cc -DNAME=built_layers_template
          -P "${embed_page}"
  WORKING_DIRECTORY "${web_build}"
  DEPENDS "${web_build}/installed" ${web_paths} "${embed_page}"
  COMMENT "Building the browser view"
  VERBATIM)

target_sources(quoin PRIVATE ${page_templates})
set_source_files_properties(view/no_templates.cc PROPERTIES COMPILE_DEFINITIONS QUOIN_HAS_VIEW)

if(QUOIN_TESTS)
  # Writes the pages that scripts/test_view opens in a browser.
  add_executable(view_pages "${web_source}/test/make_pages.cc" "${web_source}/test/make_pictures.cc"
    "${web_source}/test/make_plans.cc" "${web_source}/test/make_layers.cc")
  set_target_properties(view_pages PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")
  target_link_libraries(view_pages PRIVATE quoin quoin_warnings)
endif()
