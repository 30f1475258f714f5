/* output/drawing/perspective.c - see perspective.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/drawing/perspective.h"

#define AZIMUTH 0.35   /* rad */
#define ELEVATION 0.6  /* rad */
#define DISTANCE 3.0   /* of the eye, over the size of the box */
#define ASLANT 0.65    /* rad, between the normal of a plane and the eye, horizontally */
#define LOW 0.3        /* rad, elevation of the eye before a vertical plane */
#define MARGIN 0.04    /* of a panel, at each side */
#define ARROW_CM 0.6   /* of an axis */
#define NAME_CM 0.22   /* from its end to the middle of its name */

void hawser__box_add(struct hawser__box *box, const double *x, int size)
{
	for (int k = 0; k < size; k++) {
		box->low[k] = box->any ? fmin(box->low[k], x[k]) : x[k];
		box->high[k] = box->any ? fmax(box->high[k], x[k]) : x[k];
	}
	box->any = 1;
}

void hawser__eye_look(struct hawser__eye *eye, const struct hawser__box *box, enum hawser__view_of of,
                      const double normal[3])
{
	double size = 0.0;

	for (int k = 0; k < 3; k++) {
		eye->middle[k] = (box->low[k] + box->high[k])/2.0;
		size = fmax(size, box->high[k] - box->low[k]);
	}
	eye->size = size > 0.0 ? size : 1.0;
	eye->azimuth = box->high[2] - box->low[2] > 1e-6*eye->size || of == HAWSER__ASLANT ? AZIMUTH : 0.0;
	eye->elevation = eye->azimuth > 0.0 ? ELEVATION : 0.0;
	if (of != HAWSER__ASLANT || !normal || fabs(normal[1]) > 0.5)
		return;
	/* before the plane, on the side from which x is to the right, or z to the left */
	eye->azimuth = atan2(normal[0], normal[2]);
	if (cos(eye->azimuth) < -1e-9)
		eye->azimuth += eye->azimuth < 0.0 ? M_PI : -M_PI;
	eye->azimuth += ASLANT;
	eye->elevation = LOW;
}

void hawser__eye_see(double to[2], const struct hawser__eye *eye, const double x[3])
{
	double a = x[0] - eye->middle[0], b = x[1] - eye->middle[1], c = x[2] - eye->middle[2];
	double right = a*cos(eye->azimuth) - c*sin(eye->azimuth);
	double near = a*sin(eye->azimuth) + c*cos(eye->azimuth);
	double up = b*cos(eye->elevation) - near*sin(eye->elevation);
	double far = DISTANCE*eye->size - near*cos(eye->elevation) - b*sin(eye->elevation);
	double scale = eye->elevation > 0.0 ? DISTANCE*eye->size/far : 1.0;

	to[0] = right*scale;
	to[1] = up*scale;
}

void hawser__eye_fit(FILE *script, const struct hawser__box *seen, double width_cm, double height_cm)
{
	double wide = seen->high[0] - seen->low[0], tall = seen->high[1] - seen->low[1];
	double scale = fmax(wide/width_cm, tall/height_cm)/(1.0 - 2.0*MARGIN);
	double x = (seen->low[0] + seen->high[0])/2.0, y = (seen->low[1] + seen->high[1])/2.0;

	scale = scale > 0.0 ? scale : 1.0;
	fprintf(script, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", x - 0.5*scale*width_cm,
	        x + 0.5*scale*width_cm, y - 0.5*scale*height_cm, y + 0.5*scale*height_cm);
}

void hawser__eye_axes(FILE *script, const struct hawser__eye *eye, const struct hawser__corner *at)
{
	double origin[2];

	hawser__eye_see(origin, eye, eye->middle);
	for (int k = 0; k < 3; k++) {
		double x[3] = {eye->middle[0], eye->middle[1], eye->middle[2]}, to[2], cm[2], name;

		x[k] += 0.01*eye->size;
		hawser__eye_see(to, eye, x);
		for (int i = 0; i < 2; i++)
			cm[i] = ARROW_CM*(to[i] - origin[i])/(0.01*eye->size);
		if (hypot(cm[0], cm[1]) < 0.1) /* towards the eye */
			continue;
		name = 1.0 + NAME_CM/hypot(cm[0], cm[1]);
		fprintf(script, "set arrow from screen %.4f, screen up(%.4f) to screen %.4f, screen up(%.4f) "
		        "size screen 0.006,20,60 filled lw 0.8 lc rgb '#606060'\n"
		        "set label '{/:Italic %c}' at screen %.4f, screen up(%.4f) center tc rgb '#606060'\n",
		        at->x/at->width, at->y/at->height, (at->x + cm[0])/at->width,
		        (at->y + cm[1])/at->height, "xyz"[k], (at->x + name*cm[0])/at->width,
		        (at->y + name*cm[1])/at->height);
	}
}
