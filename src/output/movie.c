/* output/movie.c - see movie.h.
 *
 * gnuplot writes all frames to its standard output: as one animated GIF, or as one PNG after another,
 * which ffmpeg reads as a stream of pictures. Both play 20 frames a second.
 *
 * An element is a piece of line in the colour of its tension, or of slackness. Of long chains several
 * elements are one piece, so that a frame has a few thousand. The colours end at the tension that a
 * tenth of the frames exceeds: a cable that whips would leave all others in one colour.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/report.h"
#include "output/movie.h"
#include "output/perspective.h"
#include "output/program.h"
#include "output/style.h"

#define PLAYED "20"   /* frames a second */
#define DELAY "5"     /* 1/100 s between them */
#define WIDTH 16.0    /* cm, of a frame */
#define HEIGHT 10.0   /* cm */
#define LEFT 0.5      /* cm, of the panel: a margin */
#define RIGHT 13.4    /* cm, before the scale of colours */
#define BOTTOM 0.5    /* cm, a margin */
#define TOP 9.0       /* cm, below the time */
enum { PIXELS_CM = 50, PIECES = 3000, FEW = 600 }; /* most pieces of a frame; few are drawn thick */
#define OFTEN 0.9     /* part of the frames whose largest tension has a colour of its own */
#define SLACK "#009E73"

struct hawser__movie {
	const char *path;
	FILE *kept; /* of each frame: time, tensions, places */
	int apart, frames, nodes, elements;
	int (*end)[2];        /* [elements] */
	double *most;         /* [room] largest tension of each frame */
	double *x, *T;        /* [3*nodes], [elements] of the frame that is read */
	int room;
	struct hawser__box box;
};

static int is_mp4(const char *path)
{
	size_t length = strlen(path);

	return length > 4 && strcasecmp(path + length - 4, ".mp4") == 0;
}

enum hawser_status hawser__movie_check(const char *path, struct hawser_report *report)
{
	size_t length = path ? strlen(path) : 0;
	enum hawser_status status;

	if (!path)
		return HAWSER_OK;
	if (length < 5 || (!is_mp4(path) && strcasecmp(path + length - 4, ".gif") != 0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "picture", "cannot tell the kind of animation "
		                    "from the name %s: it must end in .gif or .mp4", path);
	status = hawser__program_check(&hawser__gnuplot, report);
	if (!status && is_mp4(path))
		status = hawser__program_check(&hawser__ffmpeg, report);
	return status ? status : hawser__file_check(path, report);
}

static enum hawser_status no_file(struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, "picture",
	                    "cannot write a temporary file for the animation: %s", strerror(errno));
}

enum hawser_status hawser__movie_open(struct hawser__movie **made, const char *path, int rows,
                                      int frames, struct hawser_report *report)
{
	struct hawser__movie *movie = calloc(1, sizeof *movie);

	*made = movie;
	if (!movie)
		return hawser__no_memory(report, "picture");
	movie->path = path;
	movie->apart = rows > frames ? (rows + frames - 1)/frames : 1;
	movie->room = rows/movie->apart + 2;
	movie->most = malloc((size_t)movie->room*sizeof *movie->most);
	movie->kept = tmpfile();
	if (!movie->most)
		return hawser__no_memory(report, "picture");
	return movie->kept ? HAWSER_OK : no_file(report);
}

void hawser__movie_clear(struct hawser__movie *movie)
{
	if (!movie)
		return;
	if (movie->kept)
		fclose(movie->kept);
	free(movie->end);
	free(movie->most);
	free(movie->x);
	free(movie->T);
	free(movie);
}

int hawser__movie_frames(const struct hawser__movie *movie)
{
	return movie->frames;
}

static enum hawser_status first(struct hawser__movie *movie, const struct hawser_net_frame *frame,
                                struct hawser_report *report)
{
	size_t elements = (size_t)frame->elements;

	movie->nodes = frame->nodes;
	movie->elements = frame->elements;
	movie->end = malloc((elements + 1)*sizeof *movie->end);
	movie->x = malloc((3*(size_t)frame->nodes + 1)*sizeof *movie->x);
	movie->T = malloc((elements + 1)*sizeof *movie->T);
	if (!movie->end || !movie->x || !movie->T)
		return hawser__no_memory(report, "picture");
	memcpy(movie->end, frame->end, elements*sizeof *movie->end);
	return HAWSER_OK;
}

enum hawser_status hawser__movie_add(struct hawser__movie *movie, const struct hawser_net_frame *frame,
                                     struct hawser_report *report)
{
	size_t elements = (size_t)frame->elements, nodes = (size_t)frame->nodes;
	double most = 0.0;

	if (frame->row % movie->apart != 0 || movie->frames == movie->room)
		return HAWSER_OK;
	if (!movie->end) {
		enum hawser_status status = first(movie, frame, report);

		if (status)
			return status;
	}
	for (int i = 0; i < frame->nodes; i++)
		hawser__box_add(&movie->box, frame->x[i], 3);
	for (int e = 0; e < frame->elements; e++)
		most = fmax(most, frame->T[e]);
	movie->most[movie->frames++] = most;
	return fwrite(&frame->t, sizeof frame->t, 1, movie->kept) == 1 &&
	       fwrite(frame->T, sizeof *frame->T, elements, movie->kept) == elements &&
	       fwrite(frame->x, sizeof *frame->x, nodes, movie->kept) == nodes
		? HAWSER_OK : no_file(report);
}

/* --- drawing --- */

static int ascending(const void *a, const void *b)
{
	const double *p = a, *q = b;

	return (*p > *q) - (*p < *q);
}

static double end_of_colours(struct hawser__movie *movie)
{
	int at = (int)(OFTEN*(movie->frames - 1));

	qsort(movie->most, (size_t)movie->frames, sizeof *movie->most, ascending);
	return movie->most[at] > 0.0 ? movie->most[at] : 1.0;
}

/* Number of elements from `from` on that are drawn as one piece. */
static int piece(const struct hawser__movie *movie, int from, int most)
{
	int count = 1;

	while (count < most && from + count < movie->elements &&
	       movie->end[from + count - 1][1] == movie->end[from + count][0])
		count++;
	return count;
}

static void place(double to[2], const struct hawser__movie *movie, const struct hawser__eye *eye,
                  int node)
{
	hawser__eye_see(to, eye, movie->x + 3*(size_t)node);
}

/* Pieces that are slack, or that are taut, with tensions in units of `per` newton. */
static void pieces(FILE *script, const struct hawser__movie *movie, const struct hawser__eye *eye,
                   int slack, double per)
{
	int long_as = 1 + movie->elements/PIECES;

	fprintf(script, "$%s << END\nNaN NaN NaN\n", slack ? "slack" : "taut");
	for (int e = 0, count; e < movie->elements; e += count) {
		double T = 0.0, a[2], b[2];
		int loose = 0;

		count = piece(movie, e, long_as);
		for (int i = e; i < e + count; i++) {
			T += movie->T[i]/count;
			loose += movie->T[i] <= 0.0;
		}
		if ((2*loose > count) != slack)
			continue;
		place(a, movie, eye, movie->end[e][0]);
		place(b, movie, eye, movie->end[e + count - 1][1]);
		fprintf(script, "%.5g %.5g %.4g\n%.5g %.5g %.4g\n\n", a[0], a[1], T/per, b[0], b[1], T/per);
	}
	fputs("END\n", script);
}

static void nodes_data(FILE *script, const struct hawser__movie *movie, const struct hawser__eye *eye,
                       const unsigned char *supports, int nodes)
{
	fputs("$supports << END\nNaN NaN\n", script);
	for (int i = 0; i < nodes; i++) {
		double to[2];

		place(to, movie, eye, i);
		if (supports[i])
			fprintf(script, "%.5g %.5g\n", to[0], to[1]);
	}
	fputs("END\n", script);
}

/* What all frames have in common. */
static void setting(FILE *script, const struct hawser__movie *movie, const struct hawser__eye *eye,
                    const struct hawser__box *seen, double top, double per)
{
	const struct hawser__corner corner = {14.6, 0.9, WIDTH, HEIGHT};

	fprintf(script, is_mp4(movie->path)
	        ? "set terminal pngcairo size %d,%d enhanced font 'Sans,11' background '#ffffff'\n"
	        : "set terminal gif animate delay " DELAY " loop 0 enhanced font 'Sans,11' size %d,%d "
	          "background '#ffffff'\n", (int)(WIDTH*PIXELS_CM), (int)(HEIGHT*PIXELS_CM));
	fputs(hawser__picture_look, script);
	fprintf(script, "set lmargin at screen %.4f\nset rmargin at screen %.4f\nset bmargin at screen "
	        "%.4f\nset tmargin at screen %.4f\n", LEFT/WIDTH, RIGHT/WIDTH, BOTTOM/HEIGHT, TOP/HEIGHT);
	fprintf(script, "unset border\nunset xtics\nunset ytics\nunset grid\n"
	        "set palette defined (0 '#4575B4', 1 '#91BFDB', 2 '#FEE090', 3 '#FC8D59', 4 '#D73027')\n"
	        "set colorbox user origin 0.88, 0.26 size 0.02, 0.6\nset cbrange [0:%.9g]\n"
	        "set cblabel 'Tension {/:Italic T} (%s)' offset 0.5, 0\n"
	        "set key on at screen 0.985, screen 0.93 right center horizontal noreverse Right\n",
	        top/per, per > 1.0 ? "kN" : "N");
	hawser__eye_fit(script, seen, RIGHT - LEFT, TOP - BOTTOM);
	hawser__eye_axes(script, eye, &corner);
}

static enum hawser_status read_frame(double *t, struct hawser__movie *movie,
                                     struct hawser_report *report)
{
	size_t elements = (size_t)movie->elements, numbers = 3*(size_t)movie->nodes;

	return fread(t, sizeof *t, 1, movie->kept) == 1 &&
	       fread(movie->T, sizeof *movie->T, elements, movie->kept) == elements &&
	       fread(movie->x, sizeof *movie->x, numbers, movie->kept) == numbers
		? HAWSER_OK : no_file(report);
}

/* The box on the picture that all frames fill. */
static enum hawser_status range(struct hawser__box *seen, struct hawser__movie *movie,
                                const struct hawser__eye *eye, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	double t;

	rewind(movie->kept);
	for (int k = 0; k < movie->frames && !status; k++) {
		status = read_frame(&t, movie, report);
		for (int i = 0; i < movie->nodes && !status; i++) {
			double to[2];

			place(to, movie, eye, i);
			hawser__box_add(seen, to, 2);
		}
	}
	rewind(movie->kept);
	return status;
}

static enum hawser_status write_script(FILE *script, struct hawser__movie *movie,
                                       const unsigned char *supports, int nodes,
                                       struct hawser_report *report)
{
	double top = end_of_colours(movie), per = top >= 1e4 ? 1e3 : 1.0, t = 0.0;
	double line = movie->elements <= FEW ? 3.0 : 2.0;
	struct hawser__box seen = {.any = 0};
	struct hawser__eye eye;
	enum hawser_status status;

	hawser__eye_look(&eye, &movie->box, HAWSER__IN_SPACE, NULL);
	status = range(&seen, movie, &eye, report);
	if (!status)
		setting(script, movie, &eye, &seen, top, per);
	for (int k = 0; k < movie->frames && !status; k++) {
		status = read_frame(&t, movie, report);
		if (status)
			break;
		pieces(script, movie, &eye, 0, per);
		pieces(script, movie, &eye, 1, per);
		nodes_data(script, movie, &eye, supports, nodes);
		fprintf(script, "set label 99 '{/:Italic t} = %.3f s' at screen 0.03, screen 0.93 left\n"
		        "plot $taut using 1:2:3 with lines lw %g lc palette notitle, $slack using 1:2 with "
		        "lines lw %g lc rgb '" SLACK "' notitle, $supports using 1:2 with points pt 9 ps 1.2 "
		        "lc rgb 'black' notitle, NaN with lines lw 3 lc rgb '" SLACK "' title 'slack'\n", t,
		        line, line);
	}
	return status;
}

static enum hawser_status encode(FILE *pictures, FILE *out, const sigset_t *signals,
                                 struct hawser_report *report)
{
	static const char *const arguments[] = {
		"-hide_banner", "-loglevel", "error", "-nostdin", "-y", "-f", "image2pipe", "-framerate",
		PLAYED, "-c:v", "png", "-i", "pipe:0", "-pix_fmt", "yuv420p", "-f", "mp4", "/dev/fd/1"};

	rewind(pictures);
	return hawser__program_run(&hawser__ffmpeg, arguments, sizeof arguments/sizeof *arguments, pictures,
	                           out, signals, report);
}

static enum hawser_status draw(FILE *script, const struct hawser__movie *movie,
                               const struct hawser__file *file, struct hawser_report *report)
{
	static const char *const defaults[] = {"-d"};
	FILE *pictures = is_mp4(movie->path) ? tmpfile() : NULL;
	enum hawser_status status;
	sigset_t signals = file->signals;

	if (is_mp4(movie->path) && !pictures)
		return no_file(report);
	if (!file->blocked)
		pthread_sigmask(SIG_SETMASK, NULL, &signals);
	fflush(file->stream);
	rewind(script);
	status = hawser__program_run(&hawser__gnuplot, defaults, 1, script,
	                             pictures ? pictures : file->stream, &signals, report);
	if (!status && pictures)
		status = encode(pictures, file->stream, &signals, report);
	if (pictures)
		fclose(pictures);
	return status;
}

enum hawser_status hawser__movie_finish(struct hawser__movie *movie, const unsigned char *supports,
                                        int nodes, struct hawser_report *report)
{
	struct hawser__file file = {0};
	FILE *script = tmpfile();
	enum hawser_status status = script ? write_script(script, movie, supports, nodes, report)
		: no_file(report);

	if (!status && (fflush(script) != 0 || ferror(script)))
		status = no_file(report);
	if (!status)
		status = hawser__file_begin(&file, movie->path, report);
	if (!status)
		status = draw(script, movie, &file, report);
	if (script)
		fclose(script);
	if (!status)
		return hawser__file_commit(&file, report);
	hawser__file_abort(&file);
	return status;
}
