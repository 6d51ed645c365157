# Completion of selvedge in bash: commands and options as its --help lists them, otherwise files.
_selvedge() {
    local word=${COMP_WORDS[COMP_CWORD]} program=${COMP_WORDS[0]} words=
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        words=$("$program" --help 2>/dev/null | sed -n 's/^  \(-h,\)\?\([a-z-][a-z-]*\) .*/\2/p')
    elif [[ $word == -* ]]; then
        words=$("$program" "${COMP_WORDS[1]}" --help 2>/dev/null | grep -o -- '--[a-z][a-z0-9-]*' | sort -u)
    fi
    if [[ -n $words ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    fi
}
complete -o bashdefault -o default -F _selvedge selvedge
