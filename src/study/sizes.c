/* study/sizes.c - see hawser/sizes.h. The table has every structure of the public headers;
 * tests/checks/bindings.sh compares.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <hawser/accuracy.h>
#include <hawser/backbone.h>
#include <hawser/nnm.h>
#include <hawser/beam.h>
#include <hawser/beam_motion.h>
#include <hawser/campbell.h>
#include <hawser/certificate.h>
#include <hawser/choose.h>
#include <hawser/damped.h>
#include <hawser/decay.h>
#include <hawser/folds.h>
#include <hawser/cover.h>
#include <hawser/frf.h>
#include <hawser/friction.h>
#include <hawser/hill.h>
#include <hawser/identify.h>
#include <hawser/integrate.h>
#include <hawser/irvine.h>
#include <hawser/line.h>
#include <hawser/rod.h>
#include <hawser/rod_motion.h>
#include <hawser/ropeway.h>
#include <hawser/line_modes.h>
#include <hawser/ropeway_modes.h>
#include <hawser/line_rom.h>
#include <hawser/net_rom.h>
#include <hawser/obstacles.h>
#include <hawser/drag.h>
#include <hawser/tow.h>
#include <hawser/transient.h>
#include <hawser/water.h>
#include <hawser/waves.h>
#include <hawser/locus.h>
#include <hawser/basin.h>
#include <hawser/lyapunov.h>
#include <hawser/map.h>
#include <hawser/modes.h>
#include <hawser/net.h>
#include <hawser/net_equilibria.h>
#include <hawser/net_modes.h>
#include <hawser/net_motion.h>
#include <hawser/net_plan.h>
#include <hawser/net_span.h>
#include <hawser/net_waves.h>
#include <hawser/normal_form.h>
#include <hawser/orbit.h>
#include <hawser/scene_family.h>
#include <hawser/plan.h>
#include <hawser/plausible.h>
#include <hawser/primary.h>
#include <hawser/progress.h>
#include <hawser/law.h>
#include <hawser/rom.h>
#include <hawser/scales.h>
#include <hawser/scene.h>
#include <hawser/span_motion.h>
#include <hawser/statics.h>
#include <hawser/status.h>
#include <hawser/study.h>
#include <hawser/torus.h>
#include <hawser/sizes.h>

#define ROW(name) {#name, sizeof(struct name)}

static const struct row {
	const char *name;
	size_t size;
} rows[] = {
	ROW(hawser_accuracy),
	ROW(hawser_accuracy_bases),
	ROW(hawser_accuracy_fixed),
	ROW(hawser_accuracy_omission),
	ROW(hawser_accuracy_motion),
	ROW(hawser_accuracy_options),
	ROW(hawser_accuracy_try),
	ROW(hawser_certificate),
	ROW(hawser_certified),
	ROW(hawser_answer),
	ROW(hawser_attached),
	ROW(hawser_contact),
	ROW(hawser_contact_reply),
	ROW(hawser_friction_counts),
	ROW(hawser_friction_options),
	ROW(hawser_friction_problem),
	ROW(hawser_bending),
	ROW(hawser_attachment),
	ROW(hawser_wind),
	ROW(hawser_auto_options),
	ROW(hawser_backbone),
	ROW(hawser_backbone_options),
	ROW(hawser_backbone_point),
	ROW(hawser_backbone_branch),
	ROW(hawser_nnm),
	ROW(hawser_nnm_options),
	ROW(hawser_nnm_curve),
	ROW(hawser_beam),
	ROW(hawser_beam_boundary),
	ROW(hawser_beam_boundary_options),
	ROW(hawser_beam_boundary_point),
	ROW(hawser_beam_eigenvalue),
	ROW(hawser_beam_event),
	ROW(hawser_beam_family),
	ROW(hawser_beam_integrals),
	ROW(hawser_beam_limits),
	ROW(hawser_beam_method),
	ROW(hawser_beam_motion),
	ROW(hawser_beam_motion_options),
	ROW(hawser_beam_scene_key),
	ROW(hawser_beam_station),
	ROW(hawser_beam_sweep),
	ROW(hawser_beam_sweep_options),
	ROW(hawser_campbell),
	ROW(hawser_campbell_crossover),
	ROW(hawser_campbell_options),
	ROW(hawser_campbell_resonance),
	ROW(hawser_campbell_station),
	ROW(hawser_carrier),
	ROW(hawser_case),
	ROW(hawser_choice),
	ROW(hawser_choice_mode),
	ROW(hawser_critical),
	ROW(hawser_cubic),
	ROW(hawser_damped),
	ROW(hawser_damped_event),
	ROW(hawser_damped_mode),
	ROW(hawser_damped_options),
	ROW(hawser_damped_source),
	ROW(hawser_damped_sweep),
	ROW(hawser_damped_sweep_options),
	ROW(hawser_decay),
	ROW(hawser_document),
	ROW(hawser_doubt),
	ROW(hawser_equivalent),
	ROW(hawser_fidelity),
	ROW(hawser_fidelity_choice),
	ROW(hawser_export_format),
	ROW(hawser_folds),
	ROW(hawser_folds_curve),
	ROW(hawser_folds_event),
	ROW(hawser_folds_level),
	ROW(hawser_folds_lost),
	ROW(hawser_folds_options),
	ROW(hawser_folds_point),
	ROW(hawser_folds_starts),
	ROW(hawser_frame_point),
	ROW(hawser_cover),
	ROW(hawser_frf),
	ROW(hawser_frf_event),
	ROW(hawser_hopf),
	ROW(hawser_frf_method),
	ROW(hawser_frf_options),
	ROW(hawser_frf_point),
	ROW(hawser_grid),
	ROW(hawser_half_power),
	ROW(hawser_harmonic),
	ROW(hawser_heights),
	ROW(hawser_held),
	ROW(hawser_hill_boundary),
	ROW(hawser_hill_chart),
	ROW(hawser_hill_field),
	ROW(hawser_hill_options),
	ROW(hawser_hill_tongue),
	ROW(hawser_history_factor),
	ROW(hawser_history_signal),
	ROW(hawser_identified),
	ROW(hawser_identified_key),
	ROW(hawser_identified_mode),
	ROW(hawser_identify_options),
	ROW(hawser_integrate_method),
	ROW(hawser_integrate_options),
	ROW(hawser_irvine),
	ROW(hawser_irvine_branch),
	ROW(hawser_irvine_crossover),
	ROW(hawser_irvine_options),
	ROW(hawser_irvine_station),
	ROW(hawser_landmark),
	ROW(hawser_landmark_options),
	ROW(hawser_line),
	ROW(hawser_line_carrier),
	ROW(hawser_line_contact),
	ROW(hawser_line_freedom),
	ROW(hawser_line_mass),
	ROW(hawser_line_modes),
	ROW(hawser_line_modes_options),
	ROW(hawser_line_modes_piece),
	ROW(hawser_line_modes_point),
	ROW(hawser_line_rom_options),
	ROW(hawser_line_lift),
	ROW(hawser_line_piece),
	ROW(hawser_line_sheave),
	ROW(hawser_line_statics),
	ROW(hawser_rod),
	ROW(hawser_rod_drive),
	ROW(hawser_rod_frame),
	ROW(hawser_rod_load),
	ROW(hawser_rod_motion),
	ROW(hawser_rod_motion_options),
	ROW(hawser_rod_options),
	ROW(hawser_rod_point),
	ROW(hawser_rod_scheme),
	ROW(hawser_rod_segment),
	ROW(hawser_rod_statics),
	ROW(hawser_rod_winch),
	ROW(hawser_ropeway),
	ROW(hawser_ropeway_case),
	ROW(hawser_ropeway_contact),
	ROW(hawser_ropeway_lane),
	ROW(hawser_ropeway_lane_range),
	ROW(hawser_ropeway_modes_options),
	ROW(hawser_ropeway_options),
	ROW(hawser_ropeway_range),
	ROW(hawser_ropeway_span),
	ROW(hawser_ropeway_span_range),
	ROW(hawser_ropeway_statics),
	ROW(hawser_ropeway_tower),
	ROW(hawser_ropeway_tower_range),
	ROW(hawser_ropeway_track),
	ROW(hawser_ropeway_track_crossover),
	ROW(hawser_ropeway_track_options),
	ROW(hawser_ropeway_track_point),
	ROW(hawser_ropeway_track_sample),
	ROW(hawser_ropeway_worst),
	ROW(hawser_load_piece),
	ROW(hawser_locus),
	ROW(hawser_locus_curve),
	ROW(hawser_locus_event),
	ROW(hawser_locus_options),
	ROW(hawser_locus_point),
	ROW(hawser_basin),
	ROW(hawser_basins),
	ROW(hawser_lyapunov),
	ROW(hawser_lyapunov_options),
	ROW(hawser_map),
	ROW(hawser_map_boundary),
	ROW(hawser_tongue),
	ROW(hawser_tongues),
	ROW(hawser_map_condensed),
	ROW(hawser_map_field),
	ROW(hawser_map_line),
	ROW(hawser_map_options),
	ROW(hawser_map_point),
	ROW(hawser_map_quantity),
	ROW(hawser_map_sample),
	ROW(hawser_map_shift),
	ROW(hawser_map_source),
	ROW(hawser_map_start),
	ROW(hawser_match_options),
	ROW(hawser_measured),
	ROW(hawser_mode),
	ROW(hawser_modes),
	ROW(hawser_modes_error),
	ROW(hawser_modes_method),
	ROW(hawser_modes_options),
	ROW(hawser_modulation),
	ROW(hawser_monomial),
	ROW(hawser_motion),
	ROW(hawser_motions),
	ROW(hawser_motions_options),
	ROW(hawser_motions_run),
	ROW(hawser_net),
	ROW(hawser_net_at),
	ROW(hawser_net_cable),
	ROW(hawser_net_contact),
	ROW(hawser_net_contact_given),
	ROW(hawser_net_decision),
	ROW(hawser_net_dynamics),
	ROW(hawser_net_failure),
	ROW(hawser_net_load),
	ROW(hawser_net_winch),
	ROW(hawser_net_absorber),
	ROW(hawser_net_body),
	ROW(hawser_net_wound),
	ROW(hawser_net_member),
	ROW(hawser_net_method),
	ROW(hawser_net_node),
	ROW(hawser_net_options),
	ROW(hawser_net_plane),
	ROW(hawser_net_point),
	ROW(hawser_net_frame),
	ROW(hawser_net_equilibrium),
	ROW(hawser_net_equilibria),
	ROW(hawser_net_equilibria_options),
	ROW(hawser_net_mesh_error),
	ROW(hawser_net_stiffness),
	ROW(hawser_net_modes),
	ROW(hawser_net_motion),
	ROW(hawser_net_motion_options),
	ROW(hawser_net_parted),
	ROW(hawser_net_path),
	ROW(hawser_net_plan),
	ROW(hawser_net_rom_motion),
	ROW(hawser_net_rom_options),
	ROW(hawser_net_plan_cable),
	ROW(hawser_net_plan_job),
	ROW(hawser_net_plan_options),
	ROW(hawser_net_probe),
	ROW(hawser_net_scheme),
	ROW(hawser_net_span_error),
	ROW(hawser_net_span_motion),
	ROW(hawser_net_span_motion_options),
	ROW(hawser_net_span_options),
	ROW(hawser_net_span_statics),
	ROW(hawser_net_statics),
	ROW(hawser_net_symmetry),
	ROW(hawser_net_waves),
	ROW(hawser_net_waves_options),
	ROW(hawser_obstacle),
	ROW(hawser_obstacles),
	ROW(hawser_obstacles_limit),
	ROW(hawser_obstacles_path),
	ROW(hawser_obstacles_statics),
	ROW(hawser_drag),
	ROW(hawser_path),
	ROW(hawser_path_largest),
	ROW(hawser_ring),
	ROW(hawser_ring_drag),
	ROW(hawser_tow),
	ROW(hawser_tow_body),
	ROW(hawser_tow_motion),
	ROW(hawser_tow_options),
	ROW(hawser_tow_point),
	ROW(hawser_tow_range),
	ROW(hawser_tow_sample),
	ROW(hawser_tow_segment),
	ROW(hawser_tow_state),
	ROW(hawser_tow_steady),
	ROW(hawser_waypoint),
	ROW(hawser_orbit_cost),
	ROW(hawser_normal_form),
	ROW(hawser_parameter),
	ROW(hawser_passing),
	ROW(hawser_passing_row),
	ROW(hawser_plan),
	ROW(hawser_plan_decision),
	ROW(hawser_plan_mode),
	ROW(hawser_plan_resonance),
	ROW(hawser_plan_row),
	ROW(hawser_plausible_rule),
	ROW(hawser_plugin),
	ROW(hawser_primary),
	ROW(hawser_primary_curve),
	ROW(hawser_profile_point),
	ROW(hawser_progress),
	ROW(hawser_progress_state),
	ROW(hawser_quad),
	ROW(hawser_ramp),
	ROW(hawser_ramp_term),
	ROW(hawser_report),
	ROW(hawser_resonance),
	ROW(hawser_rom),
	ROW(hawser_rom_contacts),
	ROW(hawser_rom_family),
	ROW(hawser_rom_history),
	ROW(hawser_rom_inertia),
	ROW(hawser_rom_known),
	ROW(hawser_rom_range),
	ROW(hawser_law_point),
	ROW(hawser_rom_line),
	ROW(hawser_rom_moment),
	ROW(hawser_rom_motion),
	ROW(hawser_rom_plane),
	ROW(hawser_rom_shapes),
	ROW(hawser_rom_source),
	ROW(hawser_scene),
	ROW(hawser_scene_key),
	ROW(hawser_span),
	ROW(hawser_spectrum_window),
	ROW(hawser_statics),
	ROW(hawser_statics_error),
	ROW(hawser_statics_model),
	ROW(hawser_study_curve),
	ROW(hawser_study_error),
	ROW(hawser_study_kind_error),
	ROW(hawser_surface),
	ROW(hawser_surge),
	ROW(hawser_sweep),
	ROW(hawser_sweep_options),
	ROW(hawser_term),
	ROW(hawser_tori),
	ROW(hawser_tori_options),
	ROW(hawser_tori_point),
	ROW(hawser_trajectory),
	ROW(hawser_transient),
	ROW(hawser_transient_energy),
	ROW(hawser_transient_options),
	ROW(hawser_transient_place),
	ROW(hawser_transient_range),
	ROW(hawser_transient_row),
	ROW(hawser_water),
	ROW(hawser_water_buoy),
	ROW(hawser_water_level),
	ROW(hawser_jonswap),
	ROW(hawser_wave),
	ROW(hawser_wave_flow),
	ROW(hawser_waves),
	ROW(hawser_waves_given),
	ROW(hawser_water_line),
};

size_t hawser_sizeof(const char *name)
{
	for (size_t i = 0; i < sizeof rows/sizeof *rows; i++)
		if (strcmp(rows[i].name, name) == 0)
			return rows[i].size;
	return 0;
}
