#!/bin/sh
# The runner of decks finds what it is there to find. Usage: self_test.sh <fabricsh> <root of the tree>
set -u
program=$1 root=$2
status=0

# deck <words that the runner must say, empty: it is content> with the deck on standard input
deck() {
  cat >deck.lua
  said=$("$program" --quiet "$root/tests/deck/run.lua" "$program" "$root" deck.lua 2>&1)
  code=$?
  wanted=1
  [ -n "$1" ] || wanted=0
  case $said in *"$1"*) [ $code -eq $wanted ] && return ;; esac
  echo "FAILED: expected '$1', got exit code $code and: $said"
  status=1
}

curve='curves = { { x = { 0, 1 }, y = { 0, 1 }, label = "rise" } }'
echo 'print "fine"' | deck ''
echo 'require "fabric".warn "thin ice"' | deck 'a warning that the deck does not announce: warning: deck.lua:1: thin ice'
printf -- '-- warns: thin ice\nrequire "fabric".warn "thin ice"' | deck ''
printf -- '-- warns: thin ice\n' | deck "announced and not said: 'thin ice'"
echo 'print "curve  out/curve.csv"' | deck "it names 'out/curve.csv', which is not there"
echo 'require "fabric".write("out/curve.csv", "E") print "curve  out/curve.csv."' | deck ''
page() { echo "require 'fabric'.write('out/page.html', '<style>$1</style><pre>x</pre><svg/>') print 'see out/page.html'"; }
page 'svg{max-width:100%}' | deck "'out/page.html': lines of <pre> make it wider than a screen"
page 'pre{white-space:pre-wrap}' | deck "'out/page.html': figures make it wider than a small screen"
page 'pre{white-space:pre-wrap}svg{max-width:100%}' | deck ''
echo 'error "broken"' | deck 'it ended with exit 1'
printf -- '-- warns: thin ice\nprint "SKIPPED: no ice"' | deck ''
# A checkout that has no records of others beside it.
rm -rf alone && mkdir alone && cp -r "$root/scripts" alone/
for name in identify_bias real/biaxial real/glass real/knit real/nylon real/yarn_lengths; do
  for how in --quiet --check; do
    said=$("$program" $how "alone/scripts/lab/$name.lua" 2>&1) && case $said in SKIPPED:*) continue ;; esac
    echo "FAILED: $how $name.lua without records: $said"
    status=1
  done
done
echo 'print "of scripts/thesis/uniaxial.lua"' | deck ''
command -v gnuplot >/dev/null || { echo "SKIPPED: gnuplot is not installed" && exit $status; }
echo "require 'fabric'.plot { file = 'out/a.svg', title = 'one', $curve }" | deck ''
echo "pcall(require 'fabric'.plot, { file = 'out/a.svg', xunit = 'ell', $curve })" | deck "figure 'out/a.svg' was asked for and is not there"
spoil() { echo "require 'fabric'.plot { file = 'out/a.svg', title = 'one', xlabel = 'E', xunit = '%', $curve }
  local f = io.open 'out/a.svg' local svg = f:read 'a' f:close() require 'fabric'.write('out/a.svg', (svg:gsub($1)))"; }
spoil "'>rise<', '>r\\302se<'" | deck "figure 'out/a.svg' is no SVG: at byte"
spoil "'>rise<', '>r&se<'" | deck "a bare '&'"
spoil "'</svg>', ''" | deck "'<svg>' is not closed"
spoil "'>rise<', '>r\\1se<'" | deck "a control character"
spoil "'>E, %%<', '>E<'" | deck "figure 'out/a.svg' lacks the label 'E, %'"
spoil "'gnuplot_plot_1', 'x'" | deck "figure 'out/a.svg' has 0 curves of 1"
exit $status
