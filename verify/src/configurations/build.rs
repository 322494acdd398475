//! Sets slave and master so that the requested status should hold, for a problem of size one.
//!
//! A target is chosen on the master (and on a slave curve), the slave is turned to fit and then
//! shifted so that the relative position at the target is the chosen gap along the normal; for
//! states outside, the target lies on the boundary and the slave is moved on beyond it.

use super::flat;
use super::random::Stream;
use super::recipe::Recipe;
use super::state::Wanted;
use crate::oracle::geometry::{Region, Shape};
use crate::oracle::kinematics::{Frame, Relative};
use crate::oracle::pair::{GapKind, Master, Pair, Slave};
use crate::oracle::solve::search_window;
use crate::oracle::vector::{add, cross, dot, norm, scale, sub, unit};

/// A pair and its current node positions, size one.
#[derive(Debug, Clone)]
pub struct Built {
    /// The pair, `r0` included.
    pub pair: Pair,
    /// Slave nodes.
    pub slave: Vec<[f64; 3]>,
    /// Master nodes.
    pub master: Vec<[f64; 3]>,
}

const JITTER: f64 = 0.06;

/// Builds one attempt; `None` if it met a singularity.
pub fn build(recipe: &Recipe, wanted: Wanted, stream: &mut Stream) -> Option<Built> {
    let mut built = Built {
        pair: recipe.pair.clone(),
        slave: slave_template(&recipe.pair, stream),
        master: match &recipe.pair.master {
            Master::Point => vec![stream.cube(0.2)],
            Master::Shape(geometry) => jittered(&geometry.shape, 1.0, stream),
            Master::Parametric { .. } | Master::Distance { .. } => vec![],
        },
    };
    if built.pair.dimension == 2 {
        flatten(&mut built.slave);
        flatten(&mut built.master);
    }
    let (target, push) = draw_target(&built.pair, wanted, stream);
    let anchor = stream.index(built.pair.points());
    let level = match built.pair.master {
        Master::Distance { .. } => Some(on_level(&built.pair, recipe.gap, stream)?),
        _ => None,
    };
    let here = relative(&built, anchor, target)?;
    let axes = match level {
        Some(level) => axes_across(built.pair.dimension, level.1, stream),
        None if built.pair.dimension == 2 => planar_axes(&here, stream),
        None => spatial_axes(&built.pair, &here, stream),
    };
    turn_slave(&mut built.slave, axes);
    let wanted_position = match level {
        Some((position, _)) => position,
        None => wanted_relative(&mut built, anchor, target, push, recipe.gap, stream)?,
    };
    let found = relative(&built, anchor, target)?.position;
    let shift = sub(wanted_position, found);
    for node in 0..built.slave.len() {
        if built.pair.slave_is_position(node) {
            built.slave[node] = add(built.slave[node], shift);
        }
    }
    Some(built)
}

/// Nodes about the origin, positions and directions disturbed.
fn jittered(shape: &Shape, size: f64, stream: &mut Stream) -> Vec<[f64; 3]> {
    let nodes = flat::nodes(shape);
    nodes
        .into_iter()
        .map(|node| scale(add(node, stream.cube(JITTER)), size))
        .collect()
}

fn slave_template(pair: &Pair, stream: &mut Stream) -> Vec<[f64; 3]> {
    match &pair.slave {
        Slave::Point => vec![[0.0; 3]],
        Slave::Curve(geometry) => jittered(&geometry.shape, stream.uniform(0.7, 1.1), stream),
        Slave::Fixed {
            geometry, points, ..
        } => {
            let size = if points.len() > 1 {
                [0.3, 0.7]
            } else {
                [0.5, 1.0]
            };
            jittered(&geometry.shape, stream.uniform(size[0], size[1]), stream)
        }
        Slave::Rows { positions, .. } => positions
            .iter()
            .map(|_| {
                let [x, y, z] = stream.cube(0.4);
                [x, y, 0.2 * z]
            })
            .collect(),
    }
}

/// Two dimensions: (x, z) becomes (x, y).
fn flatten(nodes: &mut [[f64; 3]]) {
    for node in nodes {
        *node = [node[0], node[2], 0.0];
    }
}

/// Parameters of the target, and for [`Wanted::Outside`] the slopes `r·r_,i` that hold there.
fn draw_target(pair: &Pair, wanted: Wanted, stream: &mut Stream) -> ([f64; 2], [f64; 2]) {
    let region = pair.region();
    let window = search_window(pair);
    let mut z = [0, 1].map(|i| {
        let [low, high] = window[i];
        let margin = if region.bounds[i].is_some() {
            0.1 * (high - low)
        } else {
            0.0
        };
        stream.uniform(low + margin, high - margin)
    });
    if region.triangle {
        let (a, b) = (stream.uniform(0.08, 0.6), stream.uniform(0.1, 0.9));
        z = [a, b * (0.92 - a)];
    }
    if wanted != Wanted::Outside {
        return (z, [0.0; 2]);
    }
    outside_target(pair, &region, z, stream)
}

/// A point of the boundary, and slopes that make `r·r` fall beyond it.
fn outside_target(
    pair: &Pair,
    region: &Region,
    inside: [f64; 2],
    stream: &mut Stream,
) -> ([f64; 2], [f64; 2]) {
    if pair.parameters() == 1 {
        let Some([low, high]) = region.bounds[0] else {
            return (inside, [0.0; 2]);
        };
        let push = stream.uniform(0.05, 0.5);
        let upper = stream.sign() > 0.0;
        return if upper {
            ([high, 0.0], [-push, 0.0])
        } else {
            ([low, 0.0], [push, 0.0])
        };
    }
    let sides = region.sides();
    let chosen = stream.index(sides.len());
    let side = &sides[chosen];
    // covector that vanishes along the side and is positive outwards
    let outward = |d: [f64; 2]| [d[1], -d[0]];
    let mut push = outward(side.direction).map(|c| -c * stream.uniform(0.05, 0.5));
    let vertex = stream.index(3) == 0 && side.range.is_some();
    let s = match side.range {
        _ if vertex => 0.0,
        Some([low, high]) => low + (high - low) * stream.uniform(0.1, 0.9),
        None => {
            let along = usize::from(side.direction[0] == 0.0);
            (inside[along] - side.corner[along]) * side.direction[along]
        }
    };
    if vertex {
        let before = &sides[(chosen + sides.len() - 1) % sides.len()];
        let factor = stream.uniform(0.05, 0.5);
        for (entry, c) in push.iter_mut().zip(outward(before.direction)) {
            *entry -= factor * c;
        }
    }
    ([0, 1].map(|i| side.corner[i] + s * side.direction[i]), push)
}

/// Present relative position at the target.
fn relative(built: &Built, anchor: usize, target: [f64; 2]) -> Option<Relative<f64>> {
    let x = flat_positions(&built.pair, &built.slave, &built.master);
    let frame = Frame::new(&built.pair, anchor, &x, &vec![0.0; x.len()]);
    let relative = frame.relative(&frame.nodes, target);
    relative
        .position
        .iter()
        .all(|v| v.is_finite())
        .then_some(relative)
}

/// All unknowns in their order.
pub fn flat_positions(pair: &Pair, slave: &[[f64; 3]], master: &[[f64; 3]]) -> Vec<f64> {
    let components = |node: &[f64; 3]| {
        node.iter()
            .take(pair.dimension)
            .copied()
            .collect::<Vec<_>>()
    };
    slave.iter().chain(master).flat_map(components).collect()
}

/// Turns the slave from the coordinate axes to an orthonormal triad.
fn turn_slave(slave: &mut [[f64; 3]], axes: [[f64; 3]; 3]) {
    for node in slave {
        let [x, y, z] = *node;
        *node = add(add(scale(axes[0], x), scale(axes[1], y)), scale(axes[2], z));
    }
}

/// Two dimensions: x axis along the master's tangent, up to a tilt.
fn planar_axes(relative: &Relative<f64>, stream: &mut Stream) -> [[f64; 3]; 3] {
    let tangent = match relative.tangents[0] {
        t if norm(t) > 0.0 => unit(t),
        _ => planar(stream),
    };
    axes_across(2, [-tangent[1], tangent[0], 0.0], stream)
}

/// A triad whose flat side faces `normal`, up to a tilt: z axis in space, y axis in the plane.
fn axes_across(dimension: usize, normal: [f64; 3], stream: &mut Stream) -> [[f64; 3]; 3] {
    if dimension == 2 {
        let tilt = [stream.uniform(-0.2, 0.2), stream.uniform(-0.2, 0.2), 0.0];
        let second = unit(add(normal, tilt));
        return [[second[1], -second[0], 0.0], second, [0.0, 0.0, 1.0]];
    }
    let tilted = unit(add(normal, stream.cube(0.08)));
    let along = perpendicular(tilted, stream);
    [along, cross(tilted, along), tilted]
}

/// Space: triad whose x axis is a suitable tangential direction, flat side to the master.
fn spatial_axes(pair: &Pair, relative: &Relative<f64>, stream: &mut Stream) -> [[f64; 3]; 3] {
    let [first, second] = relative.tangents;
    let (normal, along) = match (&pair.slave, pair.master_parameters()) {
        (Slave::Curve(_), 1) => {
            let normal = perpendicular(second, stream);
            let angle = stream.uniform(0.6, 2.5);
            let side = cross(normal, unit(second));
            (
                normal,
                add(scale(unit(second), angle.cos()), scale(side, angle.sin())),
            )
        }
        (_, 1) => {
            let normal = perpendicular(first, stream);
            let side = cross(normal, unit(first));
            (
                normal,
                unit(add(unit(first), scale(side, stream.uniform(-0.4, 0.4)))),
            )
        }
        (_, 2) => return axes_across(3, unit(cross(first, second)), stream),
        _ => return axes_across(3, stream.direction(), stream),
    };
    let tilted = unit(add(normal, stream.cube(0.08)));
    let along = unit(sub(along, scale(tilted, dot(along, tilted))));
    [along, cross(tilted, along), tilted]
}

/// A random unit vector perpendicular to `v`.
fn perpendicular(v: [f64; 3], stream: &mut Stream) -> [f64; 3] {
    loop {
        let random = stream.direction();
        let across = cross(v, random);
        if norm(across) > 0.3 * norm(v) {
            return unit(across);
        }
        if norm(v) == 0.0 {
            return random;
        }
    }
}

/// The relative position to reach at the target: along the normal by the gap, and for states outside
/// pushed beyond the boundary. Sets `r0` of a distance.
fn wanted_relative(
    built: &mut Built,
    anchor: usize,
    target: [f64; 2],
    push: [f64; 2],
    gap: f64,
    stream: &mut Stream,
) -> Option<[f64; 3]> {
    let relative = relative(built, anchor, target)?;
    let [b1, b2] = relative.tangents;
    let p = built.pair.parameters();
    let normal = match built.pair.gap {
        GapKind::Signed => {
            let x = flat_positions(&built.pair, &built.slave, &built.master);
            let frame = Frame::new(&built.pair, anchor, &x, &vec![0.0; x.len()]);
            scale(frame.normal(&relative), gap + built.pair.r0)
        }
        GapKind::Distance | GapKind::Oriented => {
            let length = stream.uniform(0.3, 0.6);
            built.pair.r0 = match built.pair.gap {
                GapKind::Oriented => built.pair.orientation * length - gap,
                _ => length - gap,
            };
            let direction = match p {
                0 if built.pair.dimension == 2 => planar(stream),
                0 => stream.direction(),
                1 if built.pair.dimension == 2 => unit([b1[1], -b1[0], 0.0]),
                1 => perpendicular(b1, stream),
                _ => unit(cross(b1, b2)),
            };
            scale(direction, length * stream.sign())
        }
    };
    if push == [0.0; 2] {
        return Some(normal);
    }
    let (a, b, c) = (dot(b1, b1), dot(b1, b2), dot(b2, b2));
    if p == 1 {
        return Some(add(normal, scale(b1, push[0] / a)));
    }
    let det = a * c - b * b;
    let lengths = [a.sqrt(), c.sqrt()];
    let f = [push[0] * lengths[0], push[1] * lengths[1]];
    let tangential = add(
        scale(b1, (c * f[0] - b * f[1]) / det),
        scale(b2, (a * f[1] - b * f[0]) / det),
    );
    Some(add(normal, tangential))
}

fn planar(stream: &mut Stream) -> [f64; 3] {
    let angle = stream.uniform(0.0, std::f64::consts::TAU);
    [angle.cos(), angle.sin(), 0.0]
}

/// The normal turns little nearby: the point is far from an axis or apex, where the distance has a kink.
fn is_smooth(frame: &Frame<'_>, position: [f64; 3], normal: [f64; 3], stream: &mut Stream) -> bool {
    let mut step = scale(stream.direction(), 0.01);
    if frame.pair.dimension == 2 {
        step[2] = 0.0;
    }
    [1.0, -1.0].iter().all(|&side| {
        let near = Relative {
            position: add(position, scale(step, side)),
            tangents: [[0.0; 3]; 2],
        };
        let turned = sub(frame.normal(&near), normal);
        dot(turned, turned) < 0.2 * 0.2
    })
}

/// A random point at the given gap from a rigid distance, relative to its origin, and the normal
/// there.
fn on_level(pair: &Pair, gap: f64, stream: &mut Stream) -> Option<([f64; 3], [f64; 3])> {
    let zeros = vec![0.0; pair.unknowns()];
    let frame = Frame::new(pair, 0, &zeros, &zeros);
    let mut position = scale(stream.direction(), stream.uniform(0.5, 2.0));
    if pair.dimension == 2 {
        position[2] = 0.0;
    }
    for _ in 0..30 {
        let here = Relative {
            position,
            tangents: [[0.0; 3]; 2],
        };
        let miss = frame.gap(&here) - gap;
        let normal = frame.normal(&here);
        if miss.abs() < 1e-12 {
            return is_smooth(&frame, position, normal, stream).then_some((position, normal));
        }
        position = sub(position, scale(normal, miss));
    }
    None
}
