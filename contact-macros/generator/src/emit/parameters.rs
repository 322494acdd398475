//! The parameter list of an element: laws, offset, orientation, geometry, weights, point, axis, directors,
//! placement.

use proc_macro2::TokenStream;
use quote::quote;

use super::number;
use crate::model::{Axis, Body, Element, Gap, Geometry, Master, Parameter, Reference, Rule, Slave};

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

/// The parameter list with the offsets of its groups.
pub struct Parameters {
    /// All entries in order.
    pub entries: Vec<Entry>,
    tangential: usize,
    rolling: usize,
    r0: usize,
    orientation: Option<usize>,
    geometry: usize,
    master_weights: usize,
    slave_weights: usize,
    point: usize,
    axis: Option<usize>,
    directors: Option<usize>,
    angle: Option<usize>,
    placement: Option<usize>,
}

impl Parameters {
    /// The list of `element`.
    pub fn new(element: &Element) -> Self {
        let mut entries: Vec<Entry> = element.law.parameters.iter().map(declared).collect();
        let tangential = entries.len();
        let friction = element.tangential.as_ref();
        entries.extend(
            friction
                .iter()
                .flat_map(|t| &t.law.parameters)
                .map(declared),
        );
        let rolling = entries.len();
        let rolls = element.rolling.iter();
        entries.extend(rolls.flat_map(|r| &r.law.parameters).map(declared));
        let infinity = f64::INFINITY;
        let signed = element.gap != Gap::Distance;
        let lowest = if signed { -infinity } else { 0.0 };
        let r0 = entries.len();
        entries.push(Entry {
            closed: true,
            ..free("r0", "length", lowest, infinity)
        });
        let orientation = signed.then(|| {
            entries.push(Entry {
                closed: true,
                ..free("orientation", "1", -1.0, 1.0)
            });
            entries.len() - 1
        });
        let geometry = entries.len();
        let (rigid, placed) = rigid(element);
        entries.extend(rigid.iter().flat_map(|g| &g.parameters).map(declared));
        let master_weights = entries.len();
        entries.extend(weights("master", master_shape(element)));
        let slave_weights = entries.len();
        entries.extend(weights("slave", slave_shape(element)));
        let point = entries.len();
        if let Slave::Integrated {
            geometry,
            rule: Rule::Given,
        } = &element.slave
        {
            for i in 0..geometry.coordinates.len() {
                entries.push(free(&format!("eta_{}", i + 1), "1", -infinity, infinity));
            }
            entries.push(free("weight", "1", 0.0, infinity));
        }
        let axis = friction
            .is_some_and(|t| t.axis == Some(Axis::Convected))
            .then_some(entries.len());
        if axis.is_some() {
            entries.extend(["axis_1", "axis_2"].map(|name| free(name, "1", -infinity, infinity)));
        }
        let given = element.rolling.as_ref();
        let directors = given
            .is_some_and(|rolling| rolling.reference == Reference::Director)
            .then_some(entries.len());
        if directors.is_some() {
            entries.extend(DIRECTORS.map(|name| free(name, "1", -infinity, infinity)));
        }
        let angle = element.angle.is_some().then_some(entries.len());
        if angle.is_some() {
            entries.extend(["angle_low", "angle_high"].map(|name| Entry {
                closed: true,
                ..free(name, "rad", 0.0, std::f64::consts::FRAC_PI_2)
            }));
        }
        let placement = placed.then_some(entries.len());
        if placed {
            entries.extend(placement_entries(element.dimension));
        }
        Self {
            entries,
            tangential,
            rolling,
            r0,
            orientation,
            geometry,
            master_weights,
            slave_weights,
            point,
            axis,
            directors,
            angle,
            placement,
        }
    }

    /// Offset of the window of angles.
    pub fn angle(&self) -> Option<usize> {
        self.angle
    }

    /// Offset of the parameters of the law of rolling.
    pub fn rolling(&self) -> usize {
        self.rolling
    }

    /// Offset of the directors of two curves.
    pub fn directors(&self) -> Option<usize> {
        self.directors
    }

    /// Offset of the geometry's parameters.
    pub fn geometry(&self) -> usize {
        self.geometry
    }

    /// Offset of r0.
    pub fn r0(&self) -> usize {
        self.r0
    }

    /// Offset of the master's weights.
    pub fn master_weights(&self) -> usize {
        self.master_weights
    }

    /// Offset of the slave's weights.
    pub fn slave_weights(&self) -> usize {
        self.slave_weights
    }

    /// Offset of the parameters of a given integration point.
    pub fn point(&self) -> usize {
        self.point
    }

    /// Offset of the components of a convected axis.
    pub fn axis(&self) -> usize {
        self.axis.unwrap_or(self.entries.len())
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.entries.len()
    }

    /// The `Layout` constant.
    pub fn layout(&self) -> TokenStream {
        let option = |value: Option<usize>| match value {
            Some(value) => quote! { Some(#value) },
            None => quote! { None },
        };
        let (r0, geometry) = (self.r0, self.geometry);
        let (master, slave, point) = (self.master_weights, self.slave_weights, self.point);
        let (orientation, placement) = (option(self.orientation), option(self.placement));
        let (tangential, axis) = (self.tangential, option(self.axis));
        let count = self.entries.len();
        quote! {
            runtime::Layout {
                tangential: #tangential,
                r0: #r0,
                orientation: #orientation,
                geometry: #geometry,
                master_weights: #master,
                slave_weights: #slave,
                point: #point,
                axis: #axis,
                placement: #placement,
                count: #count,
            }
        }
    }

    /// The descriptor's list.
    pub fn list(&self) -> TokenStream {
        let entries = self.entries.iter().map(|entry| {
            let name = format!("{}\0", entry.name);
            let unit = format!("{}\0", entry.unit);
            let (lower, upper) = (number(entry.lower), number(entry.upper));
            let closed = entry.closed;
            quote! {
                ::contact_elements::abi::Parameter {
                    name: #name, unit: #unit, lower: #lower, upper: #upper, closed: #closed,
                }
            }
        });
        quote! { &[#(#entries),*] }
    }
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

fn weights(side: &str, geometry: Option<&Geometry>) -> Vec<Entry> {
    match geometry.map(|geometry| &geometry.body) {
        Some(Body::Shape {
            functions,
            rational: true,
            ..
        }) => (0..functions.len())
            .map(|a| free(&format!("{side}_weight_{a}"), "1", 0.0, f64::INFINITY))
            .collect(),
        _ => vec![],
    }
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

/// The rigid geometry of an element and whether it is placed.
pub fn rigid(element: &Element) -> (Option<&Geometry>, bool) {
    match &element.master {
        Master::Rigid { geometry, placed } | Master::Distance { geometry, placed } => {
            (Some(geometry), *placed)
        }
        _ => (None, false),
    }
}

/// The master's shape functions, if it has any.
pub fn master_shape(element: &Element) -> Option<&Geometry> {
    match &element.master {
        Master::Shape(geometry) => Some(geometry),
        _ => None,
    }
}

/// The slave's shape functions, if it has any.
pub fn slave_shape(element: &Element) -> Option<&Geometry> {
    match &element.slave {
        Slave::Projected(geometry) | Slave::Integrated { geometry, .. } => Some(geometry),
        _ => None,
    }
}
