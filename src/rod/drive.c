/* rod/drive.c - see run.h.
 *
 * The spin grows as that of Simo and Vu-Quoc's rotor (1988): the acceleration is 1 - cos(2 pi t/T), so
 * that angle, speed and acceleration are continuous at both ends of the rise.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "rod/run.h"
#include "rod/so3.h"

enum hawser_status hawser__rod_drive_open(struct hawser__rod_drive *drive, int *open,
                                          const struct hawser__rod_mesh *mesh, int end, double until,
                                          struct hawser_report *report)
{
	const struct hawser_rod_drive *as = &mesh->rod->drive[end];
	double R[9], v[3];
	enum hawser_status status = HAWSER_OK;

	memset(drive, 0, sizeof *drive);
	drive->as = as;
	drive->place = mesh->goal[end];
	*open = as->speed != 0.0 || as->path;
	hawser__quaternion_matrix(R, drive->place.q);
	hawser__apply_left(drive->along, R, as->axis);
	if (!as->path)
		return HAWSER_OK;
	status = hawser__support_read(&drive->table, as->path, report);
	if (status)
		return status;
	if (drive->table.t[0] > 0.0 || drive->table.t[drive->table.rows - 1] < until)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "%s: the path of the %s of the rod is "
		                    "given from %g s to %g s, and the run is from 0 to %g s: make it end "
		                    "earlier, or the table longer", as->path, end ? "end" : "start",
		                    drive->table.t[0], drive->table.t[drive->table.rows - 1], until);
	hawser__support_at(drive->from, v, &drive->table, 0.0);
	return HAWSER_OK;
}

void hawser__rod_drive_clear(struct hawser__rod_drive *drive)
{
	hawser__support_clear(&drive->table);
}

void hawser__rod_drive_at(void *data, struct hawser__rod_guide *to, double t)
{
	const struct hawser__rod_drive *drive = data;
	const struct hawser_rod_drive *as = drive->as;
	double per = as->rise > 0.0 ? 2.0*acos(-1.0)/as->rise : 0.0, by[4], turn[3];
	double angle, speed = as->speed, rate = 0.0;

	memset(to, 0, sizeof *to);
	angle = speed*(t - 0.5*as->rise);
	if (t < as->rise) {
		angle = as->speed/as->rise*(0.5*t*t - (1.0 - cos(per*t))/(per*per));
		speed = as->speed/as->rise*(t - sin(per*t)/per);
		rate = as->speed/as->rise*(1.0 - cos(per*t));
	}
	for (int k = 0; k < 3; k++) {
		turn[k] = angle*as->axis[k];
		to->spin[k] = speed*drive->along[k];
		to->rate[k] = rate*drive->along[k];
		to->x[k] = drive->place.x[k];
	}
	hawser__quaternion_exp(by, turn);
	hawser__quaternion_mul(to->q, by, drive->place.q);
	if (drive->table.rows) {
		double x[3];

		hawser__support_at(x, to->v, &drive->table, t);
		hawser__support_acceleration(to->a, &drive->table, t);
		for (int k = 0; k < 3; k++)
			to->x[k] += x[k] - drive->from[k];
	}
}
