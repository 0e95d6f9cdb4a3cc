# SPDX-License-Identifier: Apache-2.0
# Prints what zsh offers at the end of command lines, one a line, and an empty line after those of each: starts an interactive zsh
# on a terminal of its own, loads the completion system with FOLDER in front, and presses Tab behind each line.
#
#   zsh -f matches.zsh FOLDER 'quoin ' ...
emulate -R zsh
zmodload zsh/zpty || exit 1
folder=$1

zpty shell zsh -f -i
send() { zpty -w shell "$1" }
until_seen() {
  local text
  while zpty -r shell text "*$1*"; do
    [[ $text == *$1* ]] && { REPLY=$text; return 0 }
  done
  return 1
}

send "PROMPT= RPROMPT=; unsetopt zle_bracketed_paste prompt_cr; fpath=(${(q)folder} \$fpath); autoload -Uz compinit; compinit -u -D"
# Every match goes through compadd: it says what it was given, and nothing is inserted.
send 'compadd() {
  if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then builtin compadd "$@"; return; fi
  local -a hits; builtin compadd -A hits "$@"; print -l -- "match:"$^hits; }'
send 'report() { print "match""es begin"; _main_complete; print "match""es end"; compstate[insert]=; compstate[list]=; }'
send 'zle -C report complete-word report; bindkey "^I" report; print "re""ady"'
until_seen ready || exit 1
for line in "${@:2}"; do
  zpty -n -w shell "$line"$'\t'
  until_seen 'matches end' || exit 1
  matches=(${${(M)${(f)REPLY//$'\r'/}:#match:*}#match:})
  (( $#matches )) && print -rl -- $matches | sort -u
  print
  zpty -n -w shell $'\C-u'
done
zpty -d shell
