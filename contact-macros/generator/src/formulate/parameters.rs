//! The parameter list of an element: laws, offset, orientation, geometry, weights, point, axis, directors,
//! placement.

use crate::model::{Axis, Element, Gap, Geometry, Master, Parameter, Reference, Rule, Slave};

/// Directions from which the angles about two curves are measured.
const DIRECTORS: [&str; 6] = [
    "slave_director_x",
    "slave_director_y",
    "slave_director_z",
    "master_director_x",
    "master_director_y",
    "master_director_z",
];

/// One parameter as the descriptor shows it.
pub struct Entry {
    /// Name in the C interface.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Least value.
    pub lower: f64,
    /// Largest value.
    pub upper: f64,
    /// Whether the bounds themselves are allowed.
    pub closed: bool,
}

/// Offsets of the groups of a parameter list; each group may be empty.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// Parameters of the tangential law.
    pub tangential: usize,
    /// Parameters of the law of rolling.
    pub rolling: usize,
    /// r0.
    pub r0: usize,
    /// Orientation of a signed gap.
    pub orientation: Option<usize>,
    /// Parameters of a rigid geometry.
    pub geometry: usize,
    /// Weights of a rational master.
    pub master_weights: usize,
    /// Weights of a rational slave.
    pub slave_weights: usize,
    /// Coordinates and weight of a given integration point.
    pub point: usize,
    /// Components of a convected axis.
    pub axis: Option<usize>,
    /// Directors of two curves.
    pub directors: Option<usize>,
    /// Window of angles.
    pub angle: Option<usize>,
    /// Placement of a rigid master.
    pub placement: Option<usize>,
}

/// The parameter list with the offsets of its groups.
#[derive(Default)]
pub struct Parameters {
    /// All entries in order.
    pub entries: Vec<Entry>,
    /// Where each group begins.
    pub layout: Layout,
}

impl Parameters {
    /// The list of `element`.
    pub fn new(element: &Element) -> Self {
        let mut list = Self::default();
        list.laws(element);
        list.gap(element);
        list.geometries(element);
        list.given_point(element);
        list.directions(element);
        list.placement(element);
        list
    }

    /// Adds a group and returns its offset.
    fn group(&mut self, entries: impl IntoIterator<Item = Entry>) -> usize {
        let start = self.entries.len();
        self.entries.extend(entries);
        start
    }

    fn laws(&mut self, element: &Element) {
        self.group(element.law.parameters.iter().map(declared));
        let friction = element.tangential.iter();
        let friction = friction.flat_map(|own| &own.law.parameters).map(declared);
        self.layout.tangential = self.group(friction);
        let rolling = element.rolling.iter();
        let rolling = rolling.flat_map(|own| &own.law.parameters).map(declared);
        self.layout.rolling = self.group(rolling);
    }

    fn gap(&mut self, element: &Element) {
        let signed = element.gap != Gap::Distance;
        let lowest = if signed { f64::NEG_INFINITY } else { 0.0 };
        let closed = |name, unit, lower, upper| Entry {
            closed: true,
            ..free(name, unit, lower, upper)
        };
        self.layout.r0 = self.group([closed("r0", "length", lowest, f64::INFINITY)]);
        self.layout.orientation =
            signed.then(|| self.group([closed("orientation", "1", -1.0, 1.0)]));
    }

    fn geometries(&mut self, element: &Element) {
        let rigid = element.master.rigid().into_iter();
        let rigid = rigid.flat_map(|geometry| &geometry.parameters);
        self.layout.geometry = self.group(rigid.map(declared));
        let master = match &element.master {
            Master::Shape(geometry) => weights("master", geometry),
            _ => vec![],
        };
        self.layout.master_weights = self.group(master);
        let slave = element.slave.geometry();
        self.layout.slave_weights = self.group(slave.map_or(vec![], |own| weights("slave", own)));
    }

    fn given_point(&mut self, element: &Element) {
        let mut entries = vec![];
        if let Slave::Integrated {
            geometry,
            rule: Rule::Given,
        } = &element.slave
        {
            entries.extend((0..geometry.coordinates.len()).map(|i| any(&format!("eta_{}", i + 1))));
            entries.push(free("weight", "1", 0.0, f64::INFINITY));
        }
        self.layout.point = self.group(entries);
    }

    fn directions(&mut self, element: &Element) {
        let axis = element.tangential.as_ref().and_then(|own| own.axis);
        self.layout.axis =
            (axis == Some(Axis::Convected)).then(|| self.group(["axis_1", "axis_2"].map(any)));
        let reference = element.rolling.as_ref().map(|own| own.reference);
        self.layout.directors =
            (reference == Some(Reference::Director)).then(|| self.group(DIRECTORS.map(any)));
        self.layout.angle = element.angle.map(|_| {
            self.group(["angle_low", "angle_high"].map(|name| Entry {
                closed: true,
                ..free(name, "rad", 0.0, std::f64::consts::FRAC_PI_2)
            }))
        });
    }

    fn placement(&mut self, element: &Element) {
        self.layout.placement = element
            .master
            .is_placed()
            .then(|| self.group(placement_entries(element.dimension)));
    }
}

/// A dimensionless parameter without bounds.
fn any(name: &str) -> Entry {
    free(name, "1", f64::NEG_INFINITY, f64::INFINITY)
}

fn declared(parameter: &Parameter) -> Entry {
    Entry {
        name: parameter.name.to_string(),
        unit: parameter.unit.clone(),
        lower: parameter.lower,
        upper: parameter.upper,
        closed: parameter.closed,
    }
}

fn free(name: &str, unit: &str, lower: f64, upper: f64) -> Entry {
    Entry {
        name: name.to_string(),
        unit: unit.to_string(),
        lower,
        upper,
        closed: false,
    }
}

fn weights(side: &str, geometry: &Geometry) -> Vec<Entry> {
    let count = if geometry.is_rational() {
        geometry.nodes()
    } else {
        0
    };
    (0..count)
        .map(|a| free(&format!("{side}_weight_{a}"), "1", 0.0, f64::INFINITY))
        .collect()
}

fn placement_entries(dimension: usize) -> Vec<Entry> {
    let names: &[(&str, &str)] = if dimension == 3 {
        &[
            ("origin_x", "length"),
            ("origin_y", "length"),
            ("origin_z", "length"),
            ("quaternion_w", "1"),
            ("quaternion_x", "1"),
            ("quaternion_y", "1"),
            ("quaternion_z", "1"),
        ]
    } else {
        &[
            ("origin_x", "length"),
            ("origin_y", "length"),
            ("direction_x", "1"),
            ("direction_y", "1"),
        ]
    };
    names
        .iter()
        .map(|(name, unit)| free(name, unit, f64::NEG_INFINITY, f64::INFINITY))
        .collect()
}
