# Writes OUT, a header with the commit of the source tree at build time; leaves it alone when nothing has changed.
# Behind -dirty stands a hash of what differs from the commit (files that git does not follow aside), so that two states
# of the work in progress are two programs. In a tree that git does not follow, but that `git archive` has made, it is
# what that has put into the line below; else "unknown".
set(archived "$Format:%h$")
get_filename_component(SOURCE ${SOURCE} REALPATH)
execute_process(COMMAND git rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCE}
                OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT top STREQUAL SOURCE)  # a tree within somebody else's
  set(top "")
endif()
set(commit "")
if(top)
  execute_process(COMMAND git describe --always --dirty --abbrev=12 --exclude=* WORKING_DIRECTORY ${SOURCE}
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
elseif(NOT archived MATCHES "Format")
  set(commit "${archived}")
endif()
if(commit MATCHES "-dirty$")
  execute_process(COMMAND git diff HEAD --full-index --no-ext-diff --no-color WORKING_DIRECTORY ${SOURCE}
                  OUTPUT_VARIABLE changes ERROR_QUIET)
  string(SHA1 changes "${changes}")
  string(SUBSTRING ${changes} 0 8 changes)
  string(APPEND commit "-${changes}")
endif()
if(NOT commit)
  set(commit "unknown")
endif()
set(text "#pragma once\n#define DOB_COMMIT \"${commit}\"\n")
set(old "")
if(EXISTS ${OUT})
  file(READ ${OUT} old)
endif()
if(NOT old STREQUAL text)
  file(WRITE ${OUT} "${text}")
endif()
