#!/bin/sh
# Title, ranges, size and script of pictures. SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# the script that gnuplot gets, by lines that set something, without its data
works "a script alone" statics "$chairlift" --gp plain.gp -q
works "a script with everything" statics "$chairlift" --gp all.gp --title "It's 50 % of a_b" --xrange 50:200 \
	--yrange :3 --size 12x8 -q
try "the size is that of the choice" grep -q '^set terminal svg name .hawser. size 454,302 ' all.gp
try "the title stands as it is" grep -q "^set label 1002 'It''s 50 % of a\\\\_b' at screen 0.5," all.gp
grep -A1 '^set xrange \[50:200\]' all.gp >ranges
try "the range of x is that of both panels" test "$(grep -c 50:200 ranges)" -eq 2
try "the range of y is that of the first panel" test "$(grep -c '^set yrange \[\*:3\]' all.gp)" -eq 1
try "and not of the second" grep -q '^set yrange \[\*:\*\]' all.gp
try "data are the same" test "$(sed -n '/<< END/,/^END/p' plain.gp)" = "$(sed -n '/<< END/,/^END/p' all.gp)"
works "a picture and its script" statics "$chairlift" --plot one.eps --gp one.gp --title T -q
try "EPS" grep -q '^%!PS-Adobe.*EPSF' one.eps
if command -v gnuplot >/dev/null; then
	try "gnuplot draws the script" sh -c 'gnuplot all.gp 2>/dev/null | grep -q "<svg"'
	works "a picture for LaTeX" statics "$chairlift" --plot tex.tex --title '[a_b] {50 %} & x^2 #1\' --units "m/s^2" -q
	try "its drawing is PDF" test "$(head -c 4 tex.pdf)" = %PDF
	try "LaTeX finds it" grep -q 'includegraphics\[.*\]{tex.pdf}' tex.tex
	try "the title stands as it is" grep -qF \
		'{\strut{}[a\_b] \{50 \%\} \& x\textasciicircum{}2 \#1\textbackslash{}}' tex.tex
	try "symbols are formulas" grep -qF '{\strut{}Height $\mathit{y}$ (m)}' tex.tex
	try "a minus is one" grep -qF '{\strut{}$-2$}' tex.tex
	works "indices and powers" trajectory "$top/notebooks-data/scenes/d-section-5.2.5.yaml" --plot powers.tex -q
	try "powers are raised" grep -qF '{\strut{}Acceleration (m/s$^2$)}' powers.tex
	try "nothing of gnuplot's markup is left" sh -c '! grep -q "Italic\|$(printf "\001")" tex.tex powers.tex'
	if command -v pdflatex >/dev/null; then
		printf '%s\n' '\documentclass{article}\usepackage{graphicx,color}\begin{document}' \
			'\input{tex}\input{powers}\end{document}' >paper.tex
		try "LaTeX sets both" sh -c 'pdflatex -interaction=nonstopmode paper.tex >latex.log'
	fi
fi

refuses_like 1 '--title is of a picture: give --plot FILE too' statics "$chairlift" --title x
refuses_like 1 '--title: write a text of 1 to 200 bytes' statics "$chairlift" --title "" --plot a.svg
refuses_like 1 '--title: the text has a control character.*' statics "$chairlift" --plot a.svg --title 'a
b'
refuses_like 1 '--xrange 3: write two numbers.*' statics "$chairlift" --plot a.svg --xrange 3
refuses_like 1 '--xrange nan:2: write two numbers.*' statics "$chairlift" --plot a.svg --xrange nan:2
refuses_like 1 '--yrange 2:2: the first number must be less.*' statics "$chairlift" --plot a.svg --yrange 2:2
refuses_like 1 '--size 12: write width and height in cm.*' statics "$chairlift" --plot a.svg --size 12
refuses_like 1 '--size 1x1: width and height must be from 3 to 120 cm' statics "$chairlift" --plot a.svg --size 1x1
refuses_like 1 'a b.tex: LaTeX has to read the name.*' statics "$chairlift" --plot 'a b.tex'
refuses_like 1 '--gp a.txt: the name of the script must end in .gp' statics "$chairlift" --gp a.txt
refuses_like 1 '--xrange 0:2: the axis is logarithmic: give limits above 0' irvine "$chairlift" --plot a.svg --xrange 0:2
# before a computation
refuses_like 1 '--yrange -1:2: the axis is logarithmic.*' frf no-such-scene --scale log --yrange -1:2 --plot a.svg
refuses_like 1 '--xrange :0: the axis is logarithmic.*' nnm no-such-scene --xrange :0 --plot a.svg
refuses_like 1 '--xrange -1:2: the axis is logarithmic.*' modes no-such-scene --over a=1:2:3 --log --xrange -1:2 --plot a.svg
try "no picture is left" test ! -e a.svg
done_testing
