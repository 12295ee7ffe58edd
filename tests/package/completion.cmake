# SPDX-License-Identifier: GPL-3.0-or-later
# The installed completion, loaded into bash as bash-completion loads it.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
find_program(BASH bash)
if(NOT BASH)
  message(NOTICE "skipped: there is no bash here")
  return()
endif()
file(REMOVE_RECURSE ${WORK}/completion)
file(WRITE ${WORK}/completion/notes.tex "")

# For the last of the words, as bash would write them.
function(expect_offer offer words)
  file(WRITE ${WORK}/completion/offer "source ${PREFIX}/share/bash-completion/completions/rigor
complete -p rigor
cd ${WORK}/completion
COMP_WORDS=(${words})
COMP_CWORD=$((\${#COMP_WORDS[@]} - 1))
_rigor
echo \"offered: \${COMPREPLY[*]}.\"
")
  run(0 ${BASH} --norc ${WORK}/completion/offer)
  expect("complete -F _rigor rigor\n")
  expect("offered: ${offer}.")
endfunction()

expect_offer("check" "rigor ch")
expect_offer("--sidecar" "rigor check --si")
expect_offer("notes.tex" "rigor check --sidecar n")
expect_offer("auto always never" "rigor check --color ''")
expect_offer("never" "rigor check --color = n")
expect_offer("notes.tex" "rigor check --strict no")
expect_offer("" "rigor nonsense --")
