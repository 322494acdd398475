//! Assembly of contacts on a grid of facets: threads, share of the kernels, candidates that are open.

use std::time::{Duration, Instant};

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

/// One thread and two. Rounds count in which both processors were free, by arithmetic alone before and after.
pub fn threads(rounds: usize) {
    for (title, into) in [
        ("R and K of every contact", Into::Own),
        ("R and K into CSR, a place for every entry", Into::Csr),
        ("R and K into CSR, by blocks", Into::Blocks),
        ("R into a vector", Into::Vector),
    ] {
        let mut grid = Grid::new(SIDE);
        let (x, count, mut room) = (grid.positions(1, 5), grid.count, Room::default());
        let mut times = [vec![], vec![], vec![]];
        let mut ratios = vec![];
        for _ in 0..rounds {
            // others' turn: a scheduler that gives this process all it wants takes it back for longer otherwise
            std::thread::sleep(Duration::from_millis(100));
            let free = both_free();
            let own = [0, 1, 2].map(|threads| {
                let (start, used) = (Instant::now(), processor_time());
                let closed = grid.evaluate(&x, into, threads, &mut room);
                assert_eq!(closed, count);
                [start.elapsed().as_secs_f64(), processor_time() - used]
            });
            if free && both_free() {
                for (times, own) in times.iter_mut().zip(own) {
                    times.push(own);
                }
                ratios.push([own[0][0] / own[2][0], own[2][1] / own[0][1]]);
            }
        }
        println!(
            "\n{count} contacts, {title}; {} of {rounds} rounds",
            ratios.len()
        );
        println!(
            "| way | ns, wall, median | least | ns, processors, median |\n|---|---:|---:|---:|"
        );
        for (name, times) in ["no threads", "1 thread", "2 threads"]
            .into_iter()
            .zip(&times)
        {
            let [wall, used] = [0, 1].map(|i| sorted(times, i, 1e9 / count as f64));
            let [Some(least), Some(median), Some(used)] = [
                wall.first(),
                wall.get(wall.len() / 2),
                used.get(used.len() / 2),
            ] else {
                continue;
            };
            println!("| {name} | {median:.0} | {least:.0} | {used:.0} |");
        }
        let [wall, used] = [0, 1].map(|i| sorted(&ratios, i, 1.0));
        let half = wall.len() / 2;
        if let (Some(wall), Some(most), Some(used)) = (wall.get(half), wall.last(), used.get(half))
        {
            println!(
                "\n2 threads {wall:.2} times as fast, at most {most:.2}; processor time times {used:.2}"
            );
        }
    }
}

fn sorted(times: &[[f64; 2]], which: usize, scale: f64) -> Vec<f64> {
    let mut list: Vec<f64> = times.iter().map(|times| scale * times[which]).collect();
    list.sort_by(f64::total_cmp);
    list
}

/// Time of all threads of this process [s].
fn processor_time() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// True where two threads do twice as much as one.
fn both_free() -> bool {
    let spin = || {
        let (start, mut value) = (Instant::now(), 1u64);
        for i in 0..40_000_000 {
            value = value
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(i);
        }
        std::hint::black_box(value);
        start.elapsed().as_secs_f64()
    };
    let alone = spin();
    let start = Instant::now();
    std::thread::scope(|scope| {
        scope.spawn(spin);
        spin();
    });
    2.0 * alone / start.elapsed().as_secs_f64() > 1.8
}

/// Kernels alone against kernels and sums.
pub fn assembly(rounds: usize) {
    let grids = [0, 1, 2, 3, 4].map(|_| Grid::new(SIDE));
    let (x, count) = (grids[0].positions(1, 5), grids[0].count);
    let [map, blocks] = grids[0].map_times.map(|time| 1e9 * time / count as f64);
    let cases = [
        (
            "kernels, f and k of 256 contacts again and again",
            Into::Again(256),
        ),
        ("kernels, f and k of every contact", Into::Own),
        ("into CSR, a place for every entry", Into::Csr),
        ("into CSR, by blocks", Into::Blocks),
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
        &format!(
            "assembly of {count} contacts, wall time; the maps once: {map:.0} ns, {blocks:.0} ns"
        ),
        &mut ways,
    );
}

/// Many candidates, few of them closed, against the closed ones alone.
pub fn candidates(rounds: usize) {
    for (title, into) in [
        ("R and K into CSR, a place for every entry", Into::Csr),
        ("R and K into CSR, by blocks", Into::Blocks),
        ("R into a vector", Into::Vector),
    ] {
        let mut all = Grid::new(SIDE);
        let mut screened = Grid::new(SIDE);
        screened.screens = true;
        let mut closed = all.thinned(APART);
        let x: Vec<Vec<f64>> = (0..GRIDS).map(|seed| all.positions(APART, seed)).collect();
        let (count, few) = (all.count, closed.count);
        let (x, mut rooms) = (&x, [(); 3].map(|()| Room::default()));
        let [room, screened_room, own] = &mut rooms;
        let mut ways = vec![
            way("all candidates", move || {
                for x in x {
                    assert_eq!(all.evaluate(x, into, 0, room), few);
                }
            }),
            way("all candidates, screened", move || {
                for x in x {
                    assert_eq!(screened.evaluate(x, into, 0, screened_room), few);
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
