// The library from C++11: options that are all zero, results that are moved, one type of progress.
// Usage: frf SCENE; prints what bindings.sh compares.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <hawser/hawser.h>

namespace {

void check(hawser_status status, const hawser_report &report)
{
	if (status != HAWSER_OK)
		throw std::runtime_error(report.message);
}

// Owns a result of the library; moving it copies the bytes.
template <typename T, void (*clear)(T *)> class Owned {
public:
	Owned() : value() {}
	~Owned() { clear(&value); }
	Owned(Owned &&other) : value(other.value) { other.value = T(); }
	Owned(const Owned &) = delete;
	Owned &operator=(const Owned &) = delete;
	T *get() { return &value; }
	T *operator->() { return &value; }

private:
	T value;
};
typedef Owned<hawser_scene, hawser_scene_clear> Scene;
typedef Owned<hawser_modes, hawser_modes_clear> Modes;
typedef Owned<hawser_rom, hawser_rom_clear> Rom;
typedef Owned<hawser_frf, hawser_frf_clear> Frf;

struct Watch {
	long calls, most;
	std::string first;
};

extern "C" int watch(void *data, const hawser_progress_state *state)
{
	Watch *watch = static_cast<Watch *>(data);
	char text[100];

	hawser_progress_text(state, text, sizeof text);
	if (watch->calls++ == 0)
		watch->first = text;
	return state->done >= watch->most;
}

// The name of the first row of a table.
template <typename Row> const char *first_of(const Row *(*table)(int), const char *Row::*name)
{
	int count = 0;

	while (table(count))
		count++;
	if (count < 2 || table(-1) || table(count + 1))
		throw std::runtime_error("a table without an end");
	return table(0)->*name;
}

void tables()
{
#define FIRST(table) std::printf(" %s", first_of(table, &table::name))
	std::printf("first rows: %s", first_of(hawser_scene_key, &hawser_scene_key::path));
	FIRST(hawser_plausible_rule);
	FIRST(hawser_statics_model);
	FIRST(hawser_modes_method);
	std::printf(" %s", first_of(hawser_complex_modes_method, &hawser_modes_method::name));
	FIRST(hawser_beam_method);
	FIRST(hawser_integrate_method);
	FIRST(hawser_frf_method);
	FIRST(hawser_map_quantity);
	FIRST(hawser_fidelity);
#undef FIRST
	std::printf("\n");
}

Frf trace(Rom &rom, double omega, Watch *data, hawser_report *report)
{
	hawser_frf_options options = hawser_frf_options();
	Frf frf;

	options.from = 0.95*omega;
	options.to = 1.05*omega;
	if (data)
		options.progress = {watch, data};
	check(hawser_frf_trace(frf.get(), rom.get(), &options, report), *report);
	return frf;
}

void run(const char *path)
{
	hawser_report report;
	hawser_statics statics;
	hawser_modes_options few = hawser_modes_options();
	std::vector<Modes> kept;
	Scene scene;
	Rom rom;
	Watch data = {0, 5, ""};

	check(hawser_scene_open(scene.get(), path, nullptr, 0, &report), report);
	check(hawser_statics_scene(&statics, scene.get(), &report), report);
	for (few.n = 2; few.n <= 4; few.n++) { // the vector grows, and moves what it holds
		kept.push_back(Modes());
		check(hawser_modes_solve(kept.back().get(), &statics, &few, &report), report);
	}
	for (Modes &modes : kept)
		std::printf("%d modes, %.10g rad/s\n", modes->n, modes->mode[0].omega/modes->time_unit);
	check(hawser_rom_build(rom.get(), kept[1].get(), scene.get(), &report), report);
	Frf whole = trace(rom, kept[1]->mode[0].omega, nullptr, &report);
	Frf part = trace(rom, kept[1]->mode[0].omega, &data, &report);
	std::printf("%s; %d of %d points, %s\n", data.first.c_str(), part->points, whole->points,
	            part->end == HAWSER_END_INTERRUPTED ? "interrupted" : "complete");
	std::printf("%s\n", hawser_sizeof("hawser_frf") == sizeof(hawser_frf) ? "sizes agree" : "sizes");
	tables();
}

} // namespace

int main(int argc, char **argv)
{
	try {
		run(argc > 1 ? argv[1] : "");
	} catch (const std::exception &e) {
		std::fprintf(stderr, "%s\n", e.what());
		return 1;
	}
	return 0;
}
