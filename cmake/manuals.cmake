# Run at build time (cmake -P): manual pages and completion from the program's own tables.
file(MAKE_DIRECTORY ${MANUALS} ${COMPLETIONS})
function(say output)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${output} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
execute_process(COMMAND ${PROGRAM} --verbs OUTPUT_VARIABLE verbs OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" verbs "${verbs}")
say(${MANUALS}/goniolux.1 --man)
foreach(verb ${verbs})
  say(${MANUALS}/goniolux-${verb}.1 --man ${verb})
endforeach()
file(WRITE ${MANUALS}/goniolux-studio.1 ".TH GONIOLUX\\-STUDIO 1 \"\" \"\" \"Goniolux\"
.SH NAME
goniolux\\-studio \\- see, edit and calculate lighting projects
.SH SYNOPSIS
.B goniolux\\-studio
[PROJECT]
.SH DESCRIPTION
The window on the same projects and the same calculations as
.BR goniolux (1).
.SH SEE ALSO
.BR goniolux (1)
")
file(GLOB pages ${MANUALS}/*.1)
foreach(page ${pages})
  execute_process(COMMAND gzip -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
configure_file(${CHANGELOG} ${COMPLETIONS}/changelog COPYONLY)
execute_process(COMMAND gzip -9nf ${COMPLETIONS}/changelog COMMAND_ERROR_IS_FATAL ANY)
say(${COMPLETIONS}/goniolux.bash --completion bash)
say(${COMPLETIONS}/_goniolux --completion zsh)
say(${COMPLETIONS}/goniolux.fish --completion fish)
