//! What the paper says of its figures, of the presets that stand for them.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

use bough::params::{PRESETS, Params};
use bough::{History, Plant};

fn params(id: &str) -> Params {
    Params::of_preset(PRESETS.iter().find(|preset| preset.id == id).unwrap())
}

fn plant(id: &str) -> Plant {
    let preset = PRESETS.iter().find(|preset| preset.id == id).unwrap();
    grown(&params(id), preset.step)
}

fn grown(params: &Params, step: Option<u32>) -> Plant {
    History::new(params).unwrap().at(step.unwrap_or(u32::MAX))
}

/// Elevation of every segment, degrees.
fn elevations(plant: &Plant) -> Vec<f64> {
    let turns = plant.segments.rotation.chunks_exact(4);
    turns.map(|turn| (2.0 * turn[2].atan2(turn[3])).to_degrees()).collect()
}

fn weightless(id: &str) -> Plant {
    let mut params = params(id);
    params.loads.gravity = 0.0;
    grown(&params, None)
}

#[test]
fn every_preset_converges_to_a_stable_plant() {
    for preset in PRESETS {
        let report = plant(preset.id).report;
        assert_eq!((report.stable, report.unstable_since), (Some(true), None), "{}", preset.id);
        assert!(report.worst_step_residual <= 1e-10, "{}: {report:?}", preset.id);
    }
}

#[test]
fn figure_2_ends_as_named() {
    for (id, sought) in [("2a", 90.0), ("2b", 45.0), ("2c", 0.0), ("2d", -45.0), ("2e", -90.0)] {
        let plant = plant(&format!("figure-{id}"));
        let tip = *elevations(&plant).last().unwrap();
        println!("figure 2, class {sought} deg: tip at {tip:.3} deg");
        // exp(-9) of the way is left by the tropism, 0.02 deg; the weight bends less than q / 6 = 0.5 deg.
        assert!((tip - sought).abs() < 0.5);
    }
}

#[test]
fn figure_8_leans_over_as_it_grows() {
    let tips = ["a", "b", "c", "d"].map(|age| {
        let plant = plant(&format!("figure-8{age}"));
        let elevations = elevations(&plant);
        // The base starts at 50 degrees, less half a segment's bending.
        assert!(elevations[0] < 50.0 && elevations[0] > 40.0);
        // No S: elevation falls all the way.
        assert!(elevations.windows(2).all(|pair| pair[1] < pair[0]));
        *elevations.last().unwrap()
    });
    assert!(tips[0] > 45.0 && tips[1] > 20.0 && tips[2] < 0.0 && tips[3] < -45.0, "{tips:?}");
}

#[test]
fn figure_13_is_an_s_with_one_inflection() {
    let plant = plant("figure-13c");
    let bends = &plant.segments.curvature;
    let significant = bends.iter().filter(|bend| bend.abs() > 1e-9);
    let signs: Vec<bool> = significant.map(|bend| *bend > 0.0).collect();
    let inflections = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert_eq!(inflections, 1);
    assert!(!signs[0], "old wood sags, young wood turns up");
    // The newest rest direction is the one sought; the weight of one segment bends the tip off it by ~ 1/n.
    let apart = [40, 80, 160, 320].map(|segments| {
        let mut params = params("figure-13c");
        params.axis.segment_length *= f64::from(params.axis.segments) / f64::from(segments);
        params.axis.segments = segments;
        let plant = grown(&params, None);
        let elevations = elevations(&plant);
        let [.., below, tip] = elevations[..] else { panic!("two segments") };
        let joint = params.axis.segment_length;
        let rest = below + (plant.segments.rest_curvature.last().unwrap() * joint).to_degrees();
        println!("{segments} segments: newest rest direction {rest:.9} deg, tip {tip:.5} deg");
        // At birth; afterwards nothing but the weight of the segment itself has moved its bearer.
        let settled = (below - rest).abs() + (tip - rest).abs();
        assert!((45.0 - tip).abs() < 10.0 && settled < 20.0);
        45.0 - tip
    });
    for pair in apart.windows(2) {
        assert!((1.8..2.2).contains(&(pair[0] / pair[1])), "{apart:?}");
    }
}

/// The newest segment's rest direction is 45 degrees at the moment it is attached, in every step.
#[test]
fn figure_13_attaches_new_wood_at_45_degrees() {
    let params = params("figure-13c");
    let mut history = History::new(&params).unwrap();
    for step in 2..=40 {
        let before = elevations(&history.at(step - 1));
        let after = history.at(step);
        let rest = after.segments.rest_curvature.last().unwrap() * params.axis.segment_length;
        let direction = before.last().unwrap() + rest.to_degrees();
        assert!((direction - 45.0).abs() < 1e-9, "step {step}: {direction}");
    }
}

#[test]
fn figure_17_c_bends_more_than_b() {
    let [b, c] = ["figure-17b", "figure-17c"].map(plant);
    assert!(c.tip(0)[1] < b.tip(0)[1] - 0.2);
    for (b, c) in elevations(&b).iter().zip(elevations(&c)).take(39) {
        assert!(c < *b);
    }
    // Pipes taper: the base is as many pipes thick as the axis has segments.
    assert!((b.segments.radius[0] / b.segments.radius[39] - 40_f64.sqrt()).abs() < 1e-12);
}

#[test]
fn figure_18_starts_as_stated_and_the_thinner_child_turns_away_more() {
    for (id, start) in [("figure-18a", -60.0), ("figure-18b", 60.0)] {
        let mut first = params(id);
        first.loads.gravity = 0.0;
        assert!((elevations(&grown(&first, None))[0] - start).abs() < 1e-9);
        let plant = plant(id);
        let free = weightless(id);
        let directions = elevations(&free);
        let ratio = plant.params.branching.girth_ratio;
        let axes = plant.polylines.offsets.len() - 1;
        for thicker in (1..axes).step_by(2) {
            let start_of =
                |axis: usize| plant.segments.axis.iter().position(|&of| of as usize == axis).unwrap();
            let turn = |axis: usize| {
                let child = start_of(axis);
                (directions[child] - directions[plant.segments.parent[child] as usize]).abs()
            };
            let (radius, thin) =
                (plant.segments.radius[start_of(thicker)], plant.segments.radius[start_of(thicker + 1)]);
            assert!((thin / radius - ratio).abs() < 1e-12);
            if ratio < 1.0 {
                assert!(turn(thicker + 1) > turn(thicker) + 10.0);
            } else {
                assert!((turn(thicker + 1) - turn(thicker)).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn figure_20_b_ends_nearer_the_vector_than_a() {
    let [a, b] = ["figure-20a", "figure-20b"].map(|id| elevations(&plant(id))[0]);
    assert!(a > 15.0 && a < 45.0 && b > 80.0 && b < 90.0, "{a} {b}");
    // Equation 73 on the clamp's length, half a segment.
    let expected =
        |strength: f64| 90.0 - bough::growth::turned(80_f64.to_radians(), strength * 0.1).to_degrees();
    assert!((a - expected(4.0)).abs() < 1e-12 && (b - expected(30.0)).abs() < 1e-12);
}

#[test]
fn figure_21_turns_to_its_vector() {
    let [a, b] = ["figure-21a", "figure-21b"].map(weightless);
    for segment in 0..a.segments.parent.len() {
        if a.segments.order[segment] > 0 {
            let off = |plant: &Plant| (elevations(plant)[segment] - 45.0).abs();
            assert!(off(&b) < off(&a), "segment {segment}");
        }
    }
    // c tends to the horizontal: along every axis the direction comes nearer to it, without weight.
    let c = weightless("figure-21c");
    let directions = elevations(&c);
    for segment in 0..directions.len() {
        let parent = c.segments.parent[segment];
        let same_axis = parent >= 0 && c.segments.axis[parent as usize] == c.segments.axis[segment];
        if same_axis && c.segments.order[segment] > 0 {
            assert!(directions[segment].abs() < directions[parent as usize].abs());
        }
    }
}

#[test]
fn figures_13_d_and_17_d_stand_around_a_stem() {
    for id in ["figure-13d", "figure-17d"] {
        let plant = plant(id);
        let lines = &plant.polylines;
        let axes = lines.offsets.len() - 1;
        let mut below = (0.0, 0);
        for axis in 1..axes {
            let points =
                &lines.points[3 * lines.offsets[axis] as usize..3 * lines.offsets[axis + 1] as usize];
            let turn = (axis - 1) as f64 * 137.5_f64.to_radians();
            for point in points.chunks_exact(3) {
                // In the vertical plane through the stem with its own azimuth, on one side of it.
                let across = point[0] * turn.sin() + point[2] * turn.cos();
                let out = point[0] * turn.cos() - point[2] * turn.sin();
                assert!(across.abs() < 1e-12 && out > -1e-12, "{id}, axis {axis}");
            }
            let birth = (0..plant.segments.axis.len())
                .filter(|&segment| plant.segments.axis[segment] as usize == axis)
                .map(|segment| plant.segments.birth[segment])
                .min()
                .unwrap();
            assert!(points[1] > below.0 && birth > below.1, "{id}: lower ones are older");
            below = (points[1], birth);
        }
        // The lowest axis is the single axis of the other figures, turned and lifted, to the last bit.
        let mut single = params(id);
        single.arrangement.pattern = bough::params::ArrangementPattern::Single;
        let alone = grown(&single, None);
        let first = lines.offsets[1] as usize;
        assert_eq!(lines.points[3 * first + 3], alone.polylines.points[3]);
        assert_eq!(plant.segments.moment[axes - 1], alone.segments.moment[0]);
    }
}

#[test]
fn a_bare_trunk_lifts_what_stands_around_a_stem() {
    let mut params = Params::default();
    params.axis.segments = 12;
    params.arrangement.pattern = bough::params::ArrangementPattern::Stem;
    params.arrangement.count = 4;
    let low = grown(&params, None);
    params.arrangement.trunk = 2.5;
    let high = grown(&params, None);
    assert_eq!(high.segments.length[0], 2.5 + params.arrangement.spacing);
    let points = low.polylines.points.chunks(3).zip(high.polylines.points.chunks(3));
    for (point, (low, high)) in points.enumerate() {
        let lifted = if point == 0 { 0.0 } else { 2.5 };
        assert_eq!((low[0], low[2]), (high[0], high[2]));
        assert!((high[1] - low[1] - lifted).abs() < 1e-14);
    }
    assert_eq!(low.segments.moment, high.segments.moment);
    // The stem itself is of wood too: cylinders as heavy as they are long and thick.
    for segment in (0..high.segments.axis.len()).filter(|segment| high.segments.axis[*segment] == 0) {
        let [length, radius] = [high.segments.length[segment], high.segments.radius[segment]];
        let mass = params.material.density * core::f64::consts::PI * radius * radius * length;
        assert!((high.segments.mass[segment] - mass).abs() < 1e-12 * mass);
    }
}
