# Run by cpack when the components are installed in their folders: adds what Debian's policy asks of every package (a
# copyright file, a changelog) and compresses the man pages.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, if that is set

function(compress file)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
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
endwhile()
