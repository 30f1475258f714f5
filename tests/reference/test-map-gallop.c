/* The critical speed of the wind as a map over the angle of the ice and the tension: an iced
 * conductor's values, those of an independent projection on parabolic cables; where lift rises with
 * the angle nothing grows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/map.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static const char conductor[] =
	"cable: {EA: 25 MN, rho: 1.6 kg/m}\nspan: {d: 300 m, h: 0 m}\n"
	"tension: {H: 30 kN, state: loaded}\ndamping: {ratio: 0.005}\nload: {static: {mass: 0.4 kg/m}}\n"
	"wind: {speed: 3 m/s, density: 1.225 kg/m^3, diameter: 32 mm, drag: [1, 0.2, 1.5],\n"
	"       lift: [0.1, -1.8, 0, 8]}\nmodel: {modes: 4}\n";

CASE(reference_map_gallop)
{
	struct hawser_report report = {.message = ""};
	struct hawser_map_source source = {.key = {"wind.angle", "tension.H"},
		.quantity = "critical-speed"};
	struct hawser_map_sample sample;
	struct hawser_map_field field;
	struct hawser_scene scene;
	double margin[2];
	void *worker;

	if (!ok(!read_bytes(&scene, conductor, strlen(conductor), NULL, 0, &report), "a scene %s",
	        report.message))
		return done_testing();
	source.scene = &scene;
	if (ok(!hawser_map_gallop_open(&field, &source, &report) &&
	       !field.open(&worker, field.context, &report), "a field %s", report.message)) {
		ok(!field.point(worker, &sample, margin, 0.0, 30e3, &report) && sample.number == 0 &&
		   margin[1] < 0.0, "above the wind's speed %s", report.message);
		close_to(sample.value, 3.03908, 1e-4, "critical speed with 30 kN");
		ok(!field.point(worker, &sample, margin, 0.0, 60e3, &report) && sample.number == 1 &&
		   margin[0] > 0.0, "below it %s", report.message);
		close_to(sample.value, 2.65982, 1e-4, "with 60 kN");
		ok(!field.point(worker, &sample, NULL, 0.3, 30e3, &report) &&
		   sample.code == HAWSER_MAP_NO_STATE, "none at 0.3 rad: %s", report.message);
		ok(!field.point(worker, &sample, NULL, 0.0, -1.0, &report) &&
		   sample.code == HAWSER_MAP_REFUSED, "no tension: %s", report.message);
		field.close(worker);
	}
	hawser_map_gallop_close(&field);
	source.key[0] = "wind.speed";
	ok(hawser_map_gallop_open(&field, &source, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "wind.speed is what"), "%s", report.message);
	hawser_scene_clear(&scene);
	return done_testing();
}
