/* output/drawing/gnuplot.c - pictures, drawn by the external program gnuplot.
 *
 * gnuplot reads a script from a temporary file, and its standard output is the file of the picture.
 * File names of the user therefore never occur in a script, no pipe can block, and no picture is
 * left if gnuplot fails. The environment variable HAWSER_GNUPLOT names another gnuplot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/report.h"
#include "output/drawing/figure.h"
#include "output/output.h"
#include "output/drawing/picture_choice.h"
#include "output/drawing/style.h"

extern char **environ;

/* gnuplot's terminal commands, with the same appearance for all formats. The size of letters is
 * multiplied by the factor of a smaller picture. */
static const struct terminal {
	const char *extension, *setting;
	double per_cm; /* size units per centimetre */
	double letters; /* factor of the font's size */
} terminals[] = {
	{".svg", "svg name 'hawser' size %.0f,%.0f enhanced font 'sans-serif,12' fontscale %.3g "
	         "background '#ffffff' linewidth 1.3", 96.0/2.54, 1.0},
	{".png", "pngcairo size %.0f,%.0f enhanced font 'Sans,9' fontscale %.3g linewidth 3.2 "
	         "pointscale 2.5 background '#ffffff'", 100.0, 2.65},
	{".pdf", "pdfcairo size %.2fcm,%.2fcm enhanced font 'Sans,9' fontscale %.3g "
	         "linewidth 1.6 pointscale 0.7 background '#ffffff'", 1.0, 0.75},
	{".eps", "epscairo size %.2fcm,%.2fcm enhanced font 'Sans,9' fontscale %.3g "
	         "linewidth 1.6 pointscale 0.7 background '#ffffff'", 1.0, 0.75},
	{".tex", "cairolatex pdf input colourtext size %.2fcm,%.2fcm font ',9' fontscale %.3g "
	         "linewidth 1.6 pointscale 0.7", 1.0, 0.75},
	{".gp", "svg name 'hawser' size %.0f,%.0f enhanced font 'sans-serif,12' fontscale %.3g "
	        "background '#ffffff' linewidth 1.3", 96.0/2.54, 1.0},
	{".gif", "unknown", 1.0, 1.0}, /* animate.c sets another when it knows the time of a frame */
};
/* Rows: two files, for LaTeX; the script, not a picture; an animation, which --plot does not make. */
enum { LATEX = 4, SCRIPT, GIF };
#define LETTERS 9.0         /* pt: of the font above, for LaTeX */

static const struct terminal *terminal_for(const char *path)
{
	size_t length = strlen(path), i;

	if (strcmp(path, "-") == 0)
		return &terminals[0];
	for (i = 0; i < sizeof terminals/sizeof *terminals; i++) {
		size_t tail = strlen(terminals[i].extension);

		if (length > tail && strcasecmp(path + length - tail, terminals[i].extension) == 0)
			return &terminals[i];
	}
	return NULL;
}

/* Write the path of gnuplot into found[size]; returns 0 if it is not found. */
static int find_program(char *found, size_t size)
{
	const char *wanted = getenv("HAWSER_GNUPLOT"), *folder = getenv("PATH"), *end;

	if (wanted && *wanted && strchr(wanted, '/'))
		return snprintf(found, size, "%s", wanted) < (int)size && access(found, X_OK) == 0;
	if (!wanted || !*wanted)
		wanted = "gnuplot";
	for (; folder && *folder; folder = *end ? end + 1 : end) {
		end = strchrnul(folder, ':');
		if (snprintf(found, size, "%.*s/%s", (int)(end - folder), folder, wanted) < (int)size &&
		    access(found, X_OK) == 0)
			return 1;
	}
	return 0;
}

static enum hawser_status missing(struct hawser_report *report)
{
	const char *wanted = getenv("HAWSER_GNUPLOT");

	return hawser__fail(report, HAWSER_ERR_PROGRAM, "picture",
	                    "cannot draw: no gnuplot program found%s%s; install gnuplot "
	                    "(Debian: gnuplot-nox), or write the numbers with --tsv",
	                    wanted ? " at HAWSER_GNUPLOT=" : "", wanted ? wanted : "");
}

enum hawser_status hawser__picture_check(const char *path, struct hawser_report *report)
{
	char program[PATH_MAX];

	if (!path)
		return HAWSER_OK;
	if (!terminal_for(path) || terminal_for(path) == &terminals[GIF])
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "picture",
		                    "cannot tell the kind of picture from the name %s: it must end in "
		                    ".svg, .png, .pdf, .eps or .tex, or .gp for a script of gnuplot (or be "
		                    "- for SVG on standard output)", path);
	if (terminal_for(path) != &terminals[SCRIPT] && !find_program(program, sizeof program))
		return missing(report);
	if (terminal_for(path) == &terminals[LATEX]) {
		enum hawser_status status = hawser__latex_check(path, report);

		if (status)
			return status;
	}
	return hawser__file_check(path, report);
}

enum hawser_status hawser__picture_check_gif(const char *path, struct hawser_report *report)
{
	char program[PATH_MAX];

	return find_program(program, sizeof program) ? hawser__file_check(path, report) : missing(report);
}

static enum hawser_status no_file(struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, "picture",
	                    "cannot write a temporary file for gnuplot: %s", strerror(errno));
}

enum hawser_status hawser__picture_begin(struct hawser__picture *picture, const char *path,
                                         double width_cm, double height_cm,
                                         struct hawser_report *report)
{
	memset(picture, 0, sizeof *picture);
	picture->path = path;
	picture->scale = HAWSER__NO_SCALE;
	picture->width = width_cm;
	picture->height = height_cm;
	if (!terminal_for(path)) {
		enum hawser_status status = hawser__picture_check(path, report);

		return status ? status : HAWSER_ERR_ARGUMENT;
	}
	picture->script = tmpfile();
	return picture->script ? HAWSER_OK : no_file(report);
}

/* Put before the script what needs the height with all rows of the legend: the terminal, and the place
 * up(y) of what stands at the part y of the height that the picture was begun with. */
static enum hawser_status complete(struct hawser__picture *picture, struct hawser_report *report)
{
	const struct terminal *terminal = terminal_for(picture->path);
	double height = picture->height + picture->more, size[2];
	double smaller = hawser__picture_size(size, picture->width, height);
	FILE *whole = tmpfile(), *body = picture->script;
	char text[4096]; /* a page at a time */
	size_t length;

	if (!whole)
		return no_file(report);
	picture->script = whole;
	fputs("set terminal ", whole);
	fprintf(whole, terminal->setting, size[0]*terminal->per_cm, size[1]*terminal->per_cm,
	        smaller*terminal->letters);
	fprintf(whole, "\nup(y) = %.9g*(%.9g*y + %.9g)/%.9g\n%s", hawser__picture_below_title(height),
	        picture->height, picture->more, height, hawser__picture_look);
	rewind(body);
	while ((length = fread(text, 1, sizeof text, body)) > 0)
		(void)!fwrite(text, 1, length, whole);
	length = (size_t)ferror(body);
	fclose(body);
	picture->height = height;
	return length || fflush(whole) != 0 || ferror(whole) ? no_file(report) : HAWSER_OK;
}

void hawser__picture_panel(struct hawser__picture *picture, double left, double right,
                           double bottom, double top)
{
	picture->left = left;
	picture->middle = 0.5*(bottom + top);
	hawser__frames_ask(picture);
	fprintf(picture->script,
	        "set lmargin at screen %.4f\nset rmargin at screen %.4f\n"
	        "set bmargin at screen up(%.4f)\nset tmargin at screen up(%.4f)\n", left, right,
	        bottom, top);
}

void hawser__picture_ylabel(struct hawser__picture *picture, const char *format, ...)
{
	va_list args;

	fputs("set label 1000 '", picture->script);
	va_start(args, format);
	vfprintf(picture->script, format, args);
	va_end(args);
	fprintf(picture->script, "' at screen %.4f, screen up(%.4f) center rotate by 90\n",
	        picture->left - 0.107, picture->middle);
}

/* A step of 1, 2 or 5 times a power of ten. */
void hawser__picture_tics(struct hawser__picture *picture, char axis, double low, double high,
                          int most)
{
	double least = (high - low)/most, size = fmax(fabs(low), fabs(high)), power, step;
	int digits = least > 0.0 ? (int)ceil(log10(size/least)) : 0;

	if (!(least > 0.0))
		return;
	/* enough digits to distinguish the labels, and few enough tics that long labels fit */
	if (digits > 3)
		least *= 0.25*(digits < 20 ? digits : 20);
	if (digits > 5)
		fprintf(picture->script, "set format %c '%%.%dg'\n", axis, digits + 1 < 17 ? digits + 1 : 17);
	power = pow(10.0, floor(log10(least)));
	step = least <= power ? power : least <= 2.0*power ? 2.0*power
	     : least <= 5.0*power ? 5.0*power : 10.0*power;
	fprintf(picture->script, "set %ctics %.9g\n", axis, step);
}

/* Labels at powers of ten, MOST_DECADES of them at most; up to a ratio of the ends at 1, 2 and 5
 * as well. gnuplot itself may label no power of ten there (5.4), or steps between them (6.0). */
void hawser__picture_log_tics(struct hawser__picture *picture, const char *axis, double low,
                              double high, double fine)
{
	enum { MOST_DECADES = 6 };
	static const int step[] = {1, 2, 5};
	const double same = 1e-9; /* round-off of ends */
	const char *comma = "";
	double decades = ceil(log10(high/low)/MOST_DECADES);

	fprintf(picture->script, "set logscale %s\n", axis);
	if (high > fine*low) {
		fprintf(picture->script, "set %stics %.9g\nset format %s '10^{%%L}'\n", axis,
		        pow(10.0, decades), axis);
		return;
	}
	fprintf(picture->script, "set format %s '%%g'\nset %stics (", axis, axis);
	for (double power = pow(10.0, floor(log10(low))); power <= high*(1.0 + same); power *= 10.0)
		for (int k = 0; k < 3; k++)
			if (step[k]*power >= low*(1.0 - same) && step[k]*power <= high*(1.0 + same)) {
				fprintf(picture->script, "%s%.9g", comma, step[k]*power);
				comma = ", ";
			}
	fputs(")\n", picture->script);
}

void hawser__picture_abort(struct hawser__picture *picture)
{
	if (picture->script)
		fclose(picture->script);
	picture->script = NULL;
}

/* 1 if gnuplot may be running, and its process id; 0: none. */
static volatile sig_atomic_t drawing;
static volatile pid_t gnuplot;

int hawser__picture_stop(void)
{
	if (drawing && gnuplot > 0)
		kill(gnuplot, SIGKILL);
	return drawing;
}

/* Wait for gnuplot with interrupts unblocked, see hawser__picture_stop. The process id is cleared
 * before the system can reuse it. */
static int wait_for(pid_t child, int *state, const sigset_t *signals)
{
	sigset_t held;
	siginfo_t info;
	int error = 0;

	gnuplot = child;
	drawing = 1;
	pthread_sigmask(SIG_SETMASK, signals, &held);
	while (waitid(P_PID, (id_t)child, &info, WEXITED | WNOWAIT) < 0 && errno == EINTR)
		;
	pthread_sigmask(SIG_SETMASK, &held, NULL);
	drawing = 0;
	gnuplot = 0;
	while (!error && waitpid(child, state, 0) < 0)
		if (errno != EINTR)
			error = errno;
	return error;
}

/* Start gnuplot with the signal mask of the caller, so that an interrupt ends it although
 * interrupts are blocked in this process. */
static int spawn(pid_t *child, const char *program, int in, int out, int complaints,
                 const sigset_t *signals)
{
	char name[] = "gnuplot", defaults[] = "-d";
	char *arguments[] = {name, defaults, NULL};
	posix_spawn_file_actions_t actions;
	posix_spawnattr_t attributes;
	int error;

	posix_spawn_file_actions_init(&actions);
	posix_spawnattr_init(&attributes);
	posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
	posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
	posix_spawn_file_actions_adddup2(&actions, complaints, STDERR_FILENO);
	posix_spawnattr_setsigmask(&attributes, signals);
	posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
	error = posix_spawn(child, program, &actions, &attributes, arguments, environ);
	posix_spawnattr_destroy(&attributes);
	posix_spawn_file_actions_destroy(&actions);
	return error;
}

/* First line of gnuplot's messages that is neither blank nor a caret, nor an answer to
 * hawser__frames_ask. */
static void first_complaint(char *line, int size, FILE *complaints)
{
	rewind(complaints);
	while (fgets(line, size, complaints)) {
		line[strcspn(line, "\n")] = '\0';
		if (line[strspn(line, " \t^")] != '\0' && !hawser__frames_answer(line))
			return;
	}
	snprintf(line, (size_t)size, "no message");
}

static enum hawser_status run(FILE *script, FILE *out, FILE *complaints, const sigset_t *signals,
                              struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	char program[PATH_MAX], line[200];
	int error, state = 0;
	pid_t child;

	if (!find_program(program, sizeof program))
		return missing(report);
	error = spawn(&child, program, fileno(script), fileno(out), fileno(complaints), signals);
	if (!error)
		error = wait_for(child, &state, signals);
	first_complaint(line, sizeof line, complaints);
	if (error)
		status = hawser__fail(report, HAWSER_ERR_PROGRAM, "picture", "cannot run %s: %s", program,
		                      strerror(error));
	else if (WIFSIGNALED(state))
		status = hawser__fail(report, HAWSER_ERR_PROGRAM, "picture",
		                      "%s was ended by signal %d; no picture is written", program,
		                      WTERMSIG(state));
	else if (WEXITSTATUS(state) != 0)
		status = hawser__fail(report, HAWSER_ERR_PROGRAM, "picture",
		                      "%s failed with status %d (%s); no picture is written", program,
		                      WEXITSTATUS(state), line);
	return status;
}

/* Write an SVG picture through a temporary file. */
static enum hawser_status draw_svg(const struct hawser__picture *picture, FILE *to, FILE *complaints,
                                   const sigset_t *signals, struct hawser_report *report)
{
	enum hawser_status status;
	FILE *raw = tmpfile();
	double size[2];

	if (!raw)
		return no_file(report);
	hawser__picture_size(size, picture->width, picture->height);
	status = run(picture->script, raw, complaints, signals, report);
	if (!status) {
		rewind(raw);
		hawser__picture_head(to, raw);
		hawser__frames_write(to, complaints, floor(size[1]*terminals[0].per_cm + 0.5));
		hawser__picture_spaces(to, raw);
	}
	if (!status && ferror(raw))
		status = no_file(report);
	fclose(raw);
	return status;
}

/* Run gnuplot in its own folder, and write both files of a picture for LaTeX. */
static enum hawser_status draw_latex(const struct hawser__picture *picture, FILE *to,
                                     FILE *complaints, const sigset_t *signals,
                                     struct hawser_report *report)
{
	struct hawser__latex latex;
	double size[2], smaller = hawser__picture_size(size, picture->width, picture->height);
	enum hawser_status status = hawser__latex_begin(&latex, picture->script, report);

	if (!status)
		status = run(latex.script, complaints, complaints, signals, report);
	if (!status)
		status = hawser__latex_write(&latex, to, picture->path,
		                             LETTERS*smaller*terminals[LATEX].letters, report);
	hawser__latex_clear(&latex);
	return status;
}

static enum hawser_status copy_script(FILE *to, FILE *script, struct hawser_report *report)
{
	char text[4096]; /* a page at a time */
	size_t length;

	fputs("# A script of gnuplot with its data: gnuplot SCRIPT >picture.svg, or with another line\n"
	      "# \"set terminal\", such as \"set terminal pdfcairo\"\n", to);
	while ((length = fread(text, 1, sizeof text, script)) > 0)
		(void)!fwrite(text, 1, length, to); /* the commit reports a short write */
	return ferror(script) ? no_file(report) : HAWSER_OK;
}

static enum hawser_status draw(const struct hawser__picture *picture,
                               const struct hawser__file *file, const sigset_t *signals,
                               struct hawser_report *report)
{
	FILE *complaints;
	enum hawser_status status;

	if (terminal_for(picture->path) == &terminals[SCRIPT])
		return copy_script(file->stream, picture->script, report);
	complaints = tmpfile();
	if (!complaints)
		return no_file(report);
	status = terminal_for(picture->path) == &terminals[0]
	             ? draw_svg(picture, file->stream, complaints, signals, report)
	         : terminal_for(picture->path) == &terminals[LATEX]
	             ? draw_latex(picture, file->stream, complaints, signals, report)
	             : run(picture->script, file->stream, complaints, signals, report);
	fclose(complaints);
	return status;
}

enum hawser_status hawser__picture_finish(struct hawser__picture *picture,
                                          struct hawser_report *report)
{
	struct hawser__file file = {0};
	enum hawser_status status;
	sigset_t now;

	hawser__frames_ask(picture);
	fputs("unset multiplot\n", picture->script);
	status = fflush(picture->script) != 0 || ferror(picture->script) ? no_file(report)
	                                                                 : complete(picture, report);
	if (status) {
		hawser__picture_abort(picture);
		return status;
	}
	rewind(picture->script);
	status = hawser__file_begin(&file, picture->path, report);
	if (!status) {
		fflush(file.stream);
		pthread_sigmask(SIG_SETMASK, NULL, &now);
		status = draw(picture, &file, file.blocked ? &file.signals : &now, report);
	}
	if (!status)
		status = hawser__file_commit(&file, report);
	else
		hawser__file_abort(&file);
	hawser__picture_abort(picture);
	return status;
}
