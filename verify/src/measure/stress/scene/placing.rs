//! Places the slave over its target, and turns, scales and shifts everything.

use super::{Case, Scene};
use crate::configurations::Stream;
use crate::measure::stress::kinematics::Point;
use crate::oracle::geometry::{Placement, RigidDistance, RigidParametric};
use crate::oracle::octuple::Octuple;
use crate::oracle::pair::{GapKind, Master};
use crate::oracle::vector::{add, cross, dot, scale, sub, unit};

impl Scene {
    /// Distance L, with a sign where the gap has one, at which the principal curvature of the master (of the
    /// pair, for two curves) makes the projection singular, on the side of negative or positive L as it is
    /// used; nothing where it is flat.
    pub fn focal_distance(&self) -> Option<f64> {
        let point = Point::new(&self.pair, 0);
        let k = point.at(&self.nodes(), self.target.map(Octuple::from));
        let n = self.direction(&point)?.map(Octuple::from);
        let plain = |v: Octuple| v.to_f64();
        let a = |i: usize, j: usize| plain(dot(k.b[i], k.b[j]));
        let h = k.second.map(|second| plain(dot(n, second)));
        let values = if self.pair.parameters() == 1 {
            [h[0] / a(0, 0); 2]
        } else {
            let det = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
            let half = 0.5 * (a(1, 1) * h[0] - 2.0 * a(0, 1) * h[1] + a(0, 0) * h[2]) / det;
            let product = (h[0] * h[2] - h[1] * h[1]) / det;
            let root = (half * half - product).max(0.0).sqrt();
            [half - root, half + root]
        };
        // F = a + L h
        let sought = if self.pair.gap == GapKind::Signed {
            values[1]
        } else {
            values[0]
        };
        let distance = -1.0 / sought;
        let right = (distance < 0.0) == (self.pair.gap == GapKind::Signed);
        (right && distance.is_finite()).then_some(distance)
    }

    /// Unit vector along which the slave lies off the target.
    fn direction(&self, point: &Point<'_>) -> Option<[f64; 3]> {
        let z = self.target.map(Octuple::from);
        let k = point.at(&self.nodes(), z);
        let b = k.b.map(|b| b.map(Octuple::to_f64));
        let bent = k.second[0].map(Octuple::to_f64);
        if self.pair.gap == GapKind::Signed {
            return Some(point.distance(&k).1.map(Octuple::to_f64));
        }
        let unit_b = |b: [f64; 3]| scale(b, 1.0 / dot(b, b).sqrt());
        Some(match self.pair.dimension - self.pair.parameters() {
            1 => unit(cross(unit_b(b[0]), unit_b(b[1]))),
            // towards the centre of curvature: r,11 of the master has the sign of minus its curvature
            2 if self.pair.parameters() == 1 => {
                let t = unit_b(b[0]);
                unit(sub(scale(t, dot(t, bent)), bent))
            }
            2 => [0.6, 0.8, 0.0],
            _ => unit([0.3, -0.5, 0.7]),
        })
    }

    /// Moves the slave so that its point lies at the gap over the target.
    fn place(&mut self) -> Option<()> {
        if let Master::Distance { .. } = self.pair.master {
            // off the middle, from where every side is equally near
            self.slave[0] = add(self.slave[0], [0.5, 0.7, 0.6]);
        }
        for _ in 0..3 {
            let point = Point::new(&self.pair, 0);
            let k = point.at(&self.nodes(), self.target.map(Octuple::from));
            let r = k.r.map(Octuple::to_f64);
            let shift = if let Master::Distance { .. } = self.pair.master {
                let (length, n) = point.distance(&k);
                scale(
                    n.map(Octuple::to_f64),
                    self.gap + self.pair.r0 - length.to_f64(),
                )
            } else {
                sub(scale(self.direction(&point)?, self.gap + self.pair.r0), r)
            };
            for (i, node) in self.slave.iter_mut().enumerate() {
                if self.pair.slave_is_position(i) {
                    *node = add(*node, shift);
                }
            }
        }
        Some(())
    }

    /// Turns, scales and shifts everything.
    fn motion(&mut self, stream: &mut Stream) {
        let angle = stream.uniform(0.3, 1.2);
        let quaternion = match (self.turned, self.pair.dimension) {
            (false, _) => [1.0, 0.0, 0.0, 0.0],
            (_, 2) => [angle.cos(), 0.0, 0.0, angle.sin()],
            _ => stream.quaternion(),
        };
        let frame = Placement::Spatial {
            origin: [0.0; 3],
            quaternion,
        };
        let rows = frame.rotation();
        let turned = |v: [f64; 3]| rows.map(|row| self.scale * dot(row, v));
        // a general position: coordinates that happen to be small carry more digits than others
        let place = stream.cube(if self.turned { 1.0 } else { 0.0 });
        let shift = [0, 1, 2].map(|c| {
            if c < self.pair.dimension {
                self.scale * place[c] + self.shift
            } else {
                0.0
            }
        });
        let moved = |v: [f64; 3], position| {
            if position {
                add(turned(v), shift)
            } else {
                turned(v)
            }
        };
        for (i, node) in self.slave.iter_mut().enumerate() {
            *node = moved(*node, self.pair.slave_is_position(i));
        }
        for (i, node) in self.master.iter_mut().enumerate() {
            *node = moved(*node, self.pair.master_is_position(i));
        }
        self.pair.r0 *= self.scale;
        self.gap *= self.scale;
        scale_radii(&mut self.pair.master, self.scale);
        self.move_rigid(quaternion, shift, rows);
    }

    /// Sets the placement of a rigid master and scales those of its parameters that are lengths.
    fn move_rigid(&mut self, turn: [f64; 4], shift: [f64; 3], rows: [[f64; 3]; 3]) {
        if let Master::Parametric { placement, .. } | Master::Distance { placement, .. } =
            &mut self.pair.master
        {
            match placement {
                Placement::Identity => {}
                Placement::Spatial { origin, quaternion } => (*origin, *quaternion) = (shift, turn),
                Placement::Planar { origin, direction } => {
                    *origin = [shift[0], shift[1]];
                    *direction = [rows[0][0], rows[1][0]];
                }
            }
        }
        if let Master::Parametric { surface, .. } = &self.pair.master {
            match surface {
                RigidParametric::Plane => self.target = self.target.map(|z| z * self.scale),
                RigidParametric::Cylinder { .. } => self.target[1] *= self.scale,
                _ => {}
            }
        }
    }

    /// Places the slave, moves everything and adds what the points remember.
    pub fn case(mut self, stream: &mut Stream) -> Option<Case> {
        self.place()?;
        self.motion(stream);
        let d = self.pair.dimension;
        let all = self.slave.iter().chain(&self.master);
        let positions: Vec<f64> = all.flat_map(|node| node[..d].to_vec()).collect();
        let region = self.pair.region();
        let off = |i: usize| self.start * region.extent(i) * if i == 0 { 1.0 } else { -1.0 };
        let p = self.pair.parameters();
        let start = |i: usize| if i < p { self.target[i] + off(i) } else { 0.0 };
        let mut case = Case {
            start: [start(0), start(1)],
            target: self.target,
            friction: vec![],
            is_projection_data: self.is_projection_data,
            pair: self.pair,
            positions,
        };
        if case.pair.tangential.is_some() {
            case.friction = case.remembered(self.load, self.gap, self.scale)?;
        }
        case.positions.iter().all(|v| v.is_finite()).then_some(case)
    }
}

fn scale_radii(master: &mut Master, s: f64) {
    match master {
        Master::Parametric { surface, .. } => match surface {
            RigidParametric::Cylinder { radius }
            | RigidParametric::Sphere { radius }
            | RigidParametric::Circle { radius } => *radius *= s,
            RigidParametric::Torus { major: a, minor: b }
            | RigidParametric::Helix {
                radius: a,
                pitch_over_2pi: b,
            } => (*a, *b) = (*a * s, *b * s),
            _ => {}
        },
        Master::Distance { body, .. } => match body {
            RigidDistance::Circle { radius }
            | RigidDistance::Cylinder { radius }
            | RigidDistance::Sphere { radius } => *radius *= s,
            RigidDistance::Torus { major, minor } => (*major, *minor) = (*major * s, *minor * s),
            _ => {}
        },
        _ => {}
    }
}
