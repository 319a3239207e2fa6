"""Every number, figure, claim and system of the thesis: where its verdict comes from.

``A`` are claims, numbers and figures, ``S`` systems. An entry names comparisons
(``registry.REPRODUCTIONS``), or files that build or test it, or says why there is nothing to
compare.
"""

from __future__ import annotations

from dataclasses import dataclass

from .rows import UNCOMPARABLE


@dataclass(frozen=True)
class Entry:
    """One entry of the list.

    Parameters
    ----------
    words : str
        What it is.
    comparisons : tuple of str
        Comparisons with rows for it.
    files : tuple of str
        Files of the project that build it or test it.
    why : str
        Where neither is: why it cannot be compared.
    """

    words: str
    comparisons: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    why: str = ""

    @property
    def verdict(self) -> str:
        """Pointer or reason, in words."""
        if self.comparisons:
            return "rows of " + ", ".join(self.comparisons)
        if self.files:
            return "built and tested: " + ", ".join(self.files)
        return f"{UNCOMPARABLE}: {self.why}"


def by(words: str, *comparisons: str, files: tuple[str, ...] = ()) -> Entry:
    """An entry with comparisons."""
    return Entry(words, comparisons, files)


def built(words: str, *files: str) -> Entry:
    """An entry that the project builds and tests."""
    return Entry(words, (), files)


_T = "tests/test_"
_AUDIT = "tests/test_the_audit_covers_every_equation_and_its_verdicts_follow_from_checks.py"
_REDUCED = "tests/test_the_reduced_order_tests_behave_as_the_thesis_says.py"

CLAIMS: dict[str, Entry] = {
    "A1": by("tachometer gain (36)", "calibration"),
    "A2": by("sensor sheet (37), Figure 14", "calibration"),
    "A3": by("sensor with amplifier (38)", "calibration"),
    "A4": by("sensor's compliance (40)-(42)", "calibration", "breakaway"),
    "A5": by("mass ratio of coil and sensor", "calibration"),
    "A6": by("150 Hz Butterworth filter", "calibration"),
    "A7": by("supply steps, Figures 15, 16", "steps"),
    "A8": by("3 V step, Figure 17", "steps"),
    "A9": by("8 V step, Figure 18", "steps"),
    "A10": by("2 to 8 V step, Figure 20", "steps"),
    "A11": by("0 to 6 V step", "steps"),
    "A12": by("loop-back, Figure 21", "steps"),
    "A13": by("square waves, Figures 22, 23", "steps"),
    "A14": by("maker's and Gomes's time constants", "steps", "in-place"),
    "A15": by("246 dynamic tests", "friction-fits"),
    "A16": by("typical dynamic test, Figure 24", "friction-fits"),
    "A17": by("Table 3, Figure 26", "friction-fits"),
    "A18": by("equation (39), Figures 27, 28", "friction-fits"),
    "A19": by("Table 4", "friction-fits"),
    "A20": by("errors in per cent of full scale", "friction-fits"),
    "A21": by("which fit has the right shape", "friction-fits"),
    "A22": by("equation (43), Figures 31, 32", "breakaway"),
    "A23": by("typical breakaway run, Figures 29, 30", "breakaway"),
    "A24": by("breakaway above slip torque, Figure 33", "friction-fits"),
    "A25": by("torque bar, Figures 11, 12, 34", "torque-bar"),
    "A26": by("torque of the stock clutch", "torque-bar"),
    "A27": built("12 modes, 5 subcases of Case 7", _AUDIT,
                 _T + "karnopp_case_torques_equal_a_constrained_solve.py"),
    "A28": built("reduced-order tests, Figures 8, 9, 56-63", _REDUCED),
    "A29": built("exact one-coordinate curve, Figure 9", _REDUCED,
                 _T + "each_stuck_clutch_keeps_the_tip_on_its_curve.py"),
    "A30": by("clutch model of chapter 5", "steps",
              files=(_T + "torque_maps_from_the_thesis_and_from_tables.py",)),
    "A31": by("standard run", "tables", "baseline"),
    "A32": by("Tables 5, 6, baseline", "tables"),
    "A33": by("Tables 5, 6, feedback", "tables"),
    "A34": by("Table 6, velocity control", "tables"),
    "A35": by("orderings of Tables 5, 6", "tables", "found-by-exact"),
    "A36": by("slip velocities, Figure 38", "baseline", "found-by-exact"),
    "A37": by("jerk and acceleration, Figures 39, 40", "baseline"),
    "A38": by("gain sweep, Figures 43, 44", "gain-sweep", "found-by-exact"),
    "A39": by("torque of clutch 2, Figures 46, 47", "feedback"),
    "A40": by("sinusoid, gain 0.08, Figure 48", "tracking", "regulation"),
    "A41": by("sinusoid, gain 0.20, Figure 49", "tracking", "regulation"),
    "A42": by("regulation, Figure 50", "regulation"),
    "A43": by("desired heading (47), (48), Figures 51, 52", "velocity"),
    "A44": by("force directions, Figure 53", "velocity"),
    "A45": by("velocity control, Figures 54, 55", "velocity"),
    "A46": by("electromagnet (31)-(35)", "torque-bar"),
    "A47": by("paths, Figure 45", "feedback"),
}  # fmt: skip

SYSTEMS: dict[str, Entry] = {
    "S1": built("kinematics", _AUDIT, _T + "the_tip_jacobian_is_the_derivative_of_the_tip.py",
                _T + "inverse_kinematics_returns_to_the_pose_on_both_branches.py"),
    "S2": built("equations of motion", _AUDIT,
                _T + "kane_gives_the_same_inertia_and_velocity_terms.py"),
    "S3": built("coupling of four clutches", _AUDIT,
                _T + "reduced_equations_solve_the_constrained_system.py"),
    "S4": built("sensors", _T + "sensors_read_what_their_numbers_say.py"),
    "S5": by("Charles/Davis simulation", "ancestor"),
    "S6": built("first SimPTER", "simpter_hybrid/karnopp/first.py"),
    "S7": built("SimPTER in SIMULINK", "simpter_hybrid/karnopp/simulate.py",
                _T + "karnopp_of_the_reduced_order_tests_tends_to_the_exact_run.py"),
    "S8": by("one-clutch regulation", "regulation"),
    "S9": built("passive mouse", "simpter_hybrid/devices/force_feedback_mouse.py"),
    "S10": built("Coulomb stick-slip", _T + "event_times_equal_closed_forms.py"),
    "S11": built("Dahl's model", "simpter_hybrid/effects/dahl.py"),
    "S12": built("reset integrator", "simpter_hybrid/effects/reset_integrator.py"),
    "S13": built("bristles", "simpter_hybrid/effects/bristles.py"),
    "S14": built("Karnopp's model",
                 _T + "karnopp_finds_closed_form_events_as_its_band_shrinks.py"),
    "S15": built("constant torque of the validation", _REDUCED),
    "S16": built("lumped actuators",
                 _T + "the_lumped_actuator_holds_whenever_some_torques_can.py"),
    "S17": built("no current, no torque", "simpter_hybrid/kernel/instant.py",
                 "simpter_hybrid/karnopp/gates.py"),
    "S18": by("lag on the command (16)", "steps"),
    "S19": by("dead time from off to on", "steps"),
    "S20": by("modified quadratic", "friction-fits",
              files=(_T + "torque_maps_from_the_thesis_and_from_tables.py",)),
    "S21": built("slip torque (39)", _T + "torque_maps_from_the_thesis_and_from_tables.py"),
    "S22": built("breakaway (43)", _T + "torque_maps_from_the_thesis_and_from_tables.py"),
    "S23": by("electromagnet", "torque-bar"),
    "S24": by("saturating supply", "steps", "variants"),
    "S25": by("air gap", "steps"),
    "S26": built("impedance controller",
                 _T + "line_y24_comes_out_as_its_inferred_inputs_were_fitted.py"),
    "S27": built("Davis's translator",
                 _T + "torque_translators_come_as_near_as_the_clutches_allow.py"),
    "S28": built("Gomes's translator",
                 _T + "torque_translators_come_as_near_as_the_clutches_allow.py"),
    "S29": built("Gomes's blending", _T + "blending_fades_a_clutch_in_and_out.py"),
    "S30": by("Gomes's velocity controller", "velocity"),
    "S31": built("look-up table",
                 _T + "tables_of_clutch_controllers_invert_what_they_stand_for.py"),
    "S32": built("table with torque feedback",
                 _T + "torque_feedback_adds_gain_times_error_and_saturates.py"),
    "S33": built("velocity controller",
                 _T + "the_velocity_controller_follows_its_printed_equations.py"),
    "S34": by("velocity controller with gradual application", "velocity"),
    "S35": by("breakaway in place", "in-place"),
    "S36": by("step and sine tests in place", "in-place"),
    "S37": by("torque-bar rig", "torque-bar"),
    "S38": built("motorised testbed", "simpter_hybrid/rigs/testbed.py",
                 "simpter_hybrid/devices/testbed.py"),
    "S39": by("supply step", "steps"),
    "S40": built("clutch step", _T + "steps_of_the_testbed_equal_closed_forms.py"),
    "S41": built("offset step", _T + "steps_of_the_testbed_equal_closed_forms.py"),
    "S42": by("loop-back", "steps"),
    "S43": by("repeatability", "steps"),
    "S44": by("dynamic-torque map", "friction-fits"),
    "S45": by("breakaway ramp", "breakaway"),
    "S46": by("sinusoid tracking", "tracking"),
    "S47": by("high-gain instability", "tracking", "regulation"),
    "S48": built("reduced-order tests", _REDUCED),
    "S49": by("line-following run", "tables"),
    "S50": built("path-weighted error (44)",
                 _T + "thesis_measures_on_a_hand_computed_example.py"),
    "S51": built("acceleration (45)", _T + "thesis_measures_on_a_hand_computed_example.py"),
    "S52": built("jerk (46)", _T + "thesis_measures_on_a_hand_computed_example.py",
                 _T + "total_variation_equals_its_closed_form.py"),
    "S53": built("path length", _T + "thesis_measures_on_a_hand_computed_example.py"),
    "S54": by("count of transitions", "baseline", "found-by-exact"),
    "S55": by("torque-following error", "feedback"),
    "S56": by("fit error", "friction-fits"),
    "S57": by("lock-up by a single sinusoid", "lockup"),
    "S58": by("three causes", "feedback"),
    "S59": by("robustness to the table", "feedback"),
    "S60": by("worst-case time constant", "variants"),
    "S61": by("smoother velocity control", "velocity"),
    "S62": built("noise on the measured state", "simpter_hybrid/studies/measurements.py"),
    "S63": built("any number of coordinates and clutches",
                 _T + "every_device_is_exact_and_agrees_with_time_stepping.py"),
    "S64": by("torque-sensing clutch", "tables", "tracking"),
    "S65": Entry("velocity control on hardware", why="no hardware results exist to compare with"),
    "S66": built("standard repeatable force input", "simpter_hybrid/scenarios/standard-input.toml"),
    "S67": by("Delrin on steel", "variants"),
    "S68": by("supply of higher voltage", "variants"),
    "S69": by("fast-mode supply", "variants"),
    "S70": built("encoders", _T + "sensors_read_what_their_numbers_say.py"),
    "S71": built("tachometers", _T + "sensors_read_what_their_numbers_say.py"),
    "S72": by("other clutches and brakes", "variants"),
    "S73": by("integral and model-based torque control", "variants"),
}  # fmt: skip

ENTRIES = CLAIMS | SYSTEMS
