# Run by cpack when the components are installed in their folders: adds what Debian's policy asks of every package (a
# copyright file, a changelog), compresses the man pages, and has no link in the Markdown pages to what is not packaged.
cmake_policy(SET CMP0009 NEW)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, if that is set

function(compress file)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Of a link to a file that is in the source and not in the package the text remains.
function(leave_out_links page folder)
  cmake_path(GET page PARENT_PATH here)
  cmake_path(RELATIVE_PATH here BASE_DIRECTORY ${folder} OUTPUT_VARIABLE inside)
  file(READ ${page} rest)
  string(REPLACE "[LICENSE](LICENSE)" "[copyright](copyright)" rest "${rest}")
  set(done "")
  while(rest MATCHES "\\[([^][\n]*)\\]\\(([^() #]+)[^() ]*\\)")
    set(link "${CMAKE_MATCH_0}")
    set(words "${CMAKE_MATCH_1}")
    set(target "${CMAKE_MATCH_2}")
    string(FIND "${rest}" "${link}" start)
    string(LENGTH "${link}" length)
    string(SUBSTRING "${rest}" 0 ${start} before)
    math(EXPR end "${start} + ${length}")
    string(SUBSTRING "${rest}" ${end} -1 rest)
    if(EXISTS "${CPACK_DUMBBELL_FOLDER}/${inside}/${target}" AND NOT EXISTS "${here}/${target}")
      set(link "${words}")
    endif()
    string(APPEND done "${before}${link}")
  endwhile()
  file(WRITE ${page} "${done}${rest}")
endfunction()

set(packages ${CPACK_DUMBBELL_PACKAGES})
while(packages)
  list(POP_FRONT packages component name)
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component})
  set(folder ${root}${CPACK_PACKAGING_INSTALL_PREFIX}/share/doc/${name})
  file(READ ${CPACK_DUMBBELL_FOLDER}/LICENSE licence)
  string(REGEX REPLACE "^MIT License\n\nCopyright \\(c\\) ([^\n]*)\n\n" "" text "${licence}")
  set(holder "${CMAKE_MATCH_1}")
  string(STRIP "${text}" text)
  string(REGEX REPLACE "\n\n" "\n.\n" text "${text}")
  string(REPLACE "\n" "\n " text "${text}")
  file(WRITE ${folder}/copyright
    "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n"
    "Upstream-Name: dumbbell\n\n"
    "Files: *\nCopyright: ${holder}\nLicense: Expat\n ${text}\n")
  file(WRITE ${folder}/changelog
    "dumbbell (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
    "  * Version ${CPACK_PACKAGE_VERSION}.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  compress(${folder}/changelog)
  file(GLOB pages ${root}${CPACK_PACKAGING_INSTALL_PREFIX}/share/man/man*/*.[1-9])
  foreach(page IN LISTS pages)
    compress(${page})
  endforeach()
  file(REMOVE ${folder}/LICENSE)  # says the same as copyright
  file(GLOB_RECURSE pages ${folder}/*.md)
  foreach(page IN LISTS pages)
    leave_out_links(${page} ${folder})
  endforeach()
endwhile()
