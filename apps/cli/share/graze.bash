# SPDX-License-Identifier: MIT
# Completion of graze for bash, written by tools/make_manual.py.
_graze() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} words
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W 'check view query simulate replay info convert bench generate pairs --help --version' -- "$word"))
    return
  fi
  case "$command ${COMP_WORDS[COMP_CWORD - 1]}" in
    'check --format') COMPREPLY=($(compgen -W 'table json ndjson csv' -- "$word")); return ;;
    'query --format') COMPREPLY=($(compgen -W 'table json ndjson csv' -- "$word")); return ;;
    'replay --format') COMPREPLY=($(compgen -W 'table json' -- "$word")); return ;;
    'info --format') COMPREPLY=($(compgen -W 'table json' -- "$word")); return ;;
    'bench --order') COMPREPLY=($(compgen -W 'sorted any' -- "$word")); return ;;
    'bench --format') COMPREPLY=($(compgen -W 'table json csv' -- "$word")); return ;;
    'generate --format') COMPREPLY=($(compgen -W 'csv json aabbs' -- "$word")); return ;;
    'pairs --format') COMPREPLY=($(compgen -W 'csv json' -- "$word")); return ;;
  esac
  case "$command" in
    check) words='-h --help --format --interior --contacts --within --svg --html --output --fail-on-contact --solid --strict' ;;
    view) words='-h --help --html --solid --strict' ;;
    query) words='-h --help --log --point --nearest --box --sphere --ray --t-max --cast --motion --contacts-with --nearest-to --first --layer --format --output --solid --strict' ;;
    simulate) words='-h --help --frames --seconds-per-frame --output --log --strict' ;;
    replay) words='-h --help --shrink --format --output' ;;
    info) words='-h --help --format --solid --strict' ;;
    convert) words='-h --help --scale --turn --solid --strict' ;;
    bench) words='-h --help --generate --seed --frames --method --order --threads --format' ;;
    generate) words='-h --help --seed --frames --output --format' ;;
    pairs) words='-h --help --generate --seed --frame --format --output' ;;
  esac
  case "$word" in
    -*) COMPREPLY=($(compgen -W "$words" -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}
complete -o filenames -F _graze graze
