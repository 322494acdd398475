//! Which parameters move what, and where anything is curved.

use super::geometry::FormulatedGeometry;
use crate::linearise::shared::Kinematics;
use crate::model::{Element, Master, Slave};

/// What the closed forms need to know about the pair of `element`.
pub fn kinematics(
    element: &Element,
    slave: Option<&FormulatedGeometry>,
    master: Option<&FormulatedGeometry>,
) -> Kinematics {
    let (moving, curved, third) = match (&element.slave, slave, &element.master, master) {
        (_, _, Master::Point | Master::Distance { .. }, _) | (_, _, _, None) => {
            (vec![], vec![], vec![])
        }
        (Slave::Projected(_), Some(slave), of_master, Some(master)) => (
            vec![true, matches!(of_master, Master::Shape(_))],
            vec![slave.curved[0], false, master.curved[0]],
            vec![
                slave.third_remaining[0],
                false,
                false,
                master.third_remaining[0],
            ],
        ),
        (_, _, of_master, Some(master)) => (
            vec![matches!(of_master, Master::Shape(_)); master.declared.coordinates.len()],
            master.curved.clone(),
            master.third_remaining.clone(),
        ),
    };
    Kinematics {
        dimension: element.dimension,
        moving,
        curved,
        third,
        gap: element.gap,
        linearisation: element.linearisation,
    }
}
