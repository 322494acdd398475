//! Assembly of contacts on a grid of facets: threads, share of the kernels, candidates that are open.

use std::time::Instant;

use crate::grid::{Grid, Into, Room};
use crate::{Way, print};

/// 316² contacts.
const SIDE: usize = 316;
/// Grids of candidates: 10 · 316² ≈ 10⁶.
const GRIDS: u64 = 10;
/// One candidate in so many is closed.
const APART: usize = 100;

/// Rounds of all ways in turn; wall time per contact.
fn measure(ways: &mut [Way<'_>], rounds: usize, contacts: usize) {
    for _ in 0..rounds {
        for way in &mut *ways {
            let start = Instant::now();
            (way.run)();
            way.times
                .push(1e9 * start.elapsed().as_secs_f64() / contacts as f64);
        }
    }
}

fn way<'a>(name: &str, run: impl FnMut() + 'a) -> Way<'a> {
    Way {
        name: name.into(),
        run: Box::new(run),
        times: vec![],
    }
}

/// One thread and two, and what of the assembly the kernels take.
pub fn threads(rounds: usize) {
    for (title, into) in [
        ("R and K of every contact", Into::Own),
        ("R and K into CSR", Into::Csr),
        ("R into a vector", Into::Vector),
    ] {
        let grids = [0, 1, 2].map(|_| Grid::new(SIDE));
        let x = grids[0].positions(1, 5);
        let count = grids[0].count;
        let mut ways: Vec<Way<'_>> = ["no threads", "1 thread", "2 threads"]
            .into_iter()
            .zip(grids)
            .enumerate()
            .map(|(threads, (name, mut grid))| {
                let (x, mut room) = (&x, Room::default());
                way(name, move || {
                    let closed = grid.evaluate(x, into, threads as i32, &mut room);
                    assert_eq!(closed, grid.count);
                })
            })
            .collect();
        measure(&mut ways, rounds, count);
        print(&format!("{count} contacts, wall time, {title}"), &mut ways);
    }
}

/// Kernels alone against kernels and sums.
pub fn assembly(rounds: usize) {
    let grids = [0, 1, 2, 3].map(|_| Grid::new(SIDE));
    let (x, count) = (grids[0].positions(1, 5), grids[0].count);
    let map_time = 1e9 * grids[0].map_time / count as f64;
    let cases = [
        (
            "kernels, f and k of 256 contacts again and again",
            Into::Again(256),
        ),
        ("kernels, f and k of every contact", Into::Own),
        ("into CSR", Into::Csr),
        ("R alone, into the vector", Into::Vector),
    ];
    let mut ways: Vec<Way<'_>> = cases
        .into_iter()
        .zip(grids)
        .map(|((name, into), mut grid)| {
            let (x, mut room) = (&x, Room::default());
            way(name, move || {
                grid.evaluate(x, into, 0, &mut room);
            })
        })
        .collect();
    measure(&mut ways, rounds, count);
    print(
        &format!("assembly of {count} contacts, wall time; the map once: {map_time:.0} ns"),
        &mut ways,
    );
}

/// Many candidates, few of them closed, against the closed ones alone.
pub fn candidates(rounds: usize) {
    for (title, into) in [
        ("R and K into CSR", Into::Csr),
        ("R into a vector", Into::Vector),
    ] {
        let mut all = Grid::new(SIDE);
        let mut closed = all.thinned(APART);
        let x: Vec<Vec<f64>> = (0..GRIDS).map(|seed| all.positions(APART, seed)).collect();
        let (count, few) = (all.count, closed.count);
        let (x, mut rooms) = (&x, [(); 2].map(|()| Room::default()));
        let [room, own] = &mut rooms;
        let mut ways = vec![
            way("all candidates", move || {
                for x in x {
                    assert_eq!(all.evaluate(x, into, 0, room), few);
                }
            }),
            way("the closed ones alone", move || {
                for x in x {
                    assert_eq!(closed.evaluate(x, into, 0, own), few);
                }
            }),
        ];
        measure(&mut ways, rounds, GRIDS as usize * count);
        let title = format!(
            "{} candidates, {} closed, per candidate, {title}",
            10 * count,
            10 * few
        );
        print(&title, &mut ways);
    }
}
