//! Time per contact of a batch, beside one call after the other and the hand-written peers, in one process.
//!
//! `contact-batch-cost [folder of the peers' libraries] [title of one table] [rounds]`; titles of tables of many
//! contacts: `threads`, `assembly`, `candidates`

mod assembly;
mod grid;
mod peers;
#[allow(dead_code, reason = "the tests need more of it")]
#[path = "../../../tests/src/random.rs"]
mod random;
mod states;
mod work;

use contact_elements::runtime::Width;
use peers::Peer;
use states::States;
use work::{Work, Workspace};

/// Measures so many rounds.
type Table = fn(usize);

/// One way to do some work.
struct Way<'a> {
    name: String,
    run: Box<dyn FnMut() + 'a>,
    times: Vec<f64>,
}

fn main() {
    let folder = std::env::args().nth(1);
    let only = std::env::args().nth(2);
    let peers: Vec<Peer> = folder.iter().flat_map(|folder| Peer::all(folder)).collect();
    let closed = States::new(8192, 1.0);
    let open = States::new(8192, 0.0);
    for (title, states, work) in [
        (
            "R and K, projection given",
            &closed,
            Work::tangent().given(),
        ),
        ("R and K, Newton", &closed, Work::tangent()),
        (
            "R and K, Newton, output and history",
            &closed,
            Work::tangent().reported(),
        ),
        ("R, projection given", &closed, Work::residual().given()),
        ("R, Newton", &closed, Work::residual()),
        ("open, R and K", &open, Work::tangent()),
        ("open, R", &open, Work::residual()),
    ] {
        if only.as_ref().is_some_and(|only| only != title) {
            continue;
        }
        table(title, states, work, &peers);
    }
    let many: [(&str, Table); 3] = [
        ("threads", assembly::threads),
        ("assembly", assembly::assembly),
        ("candidates", assembly::candidates),
    ];
    for (title, table) in many {
        if only.as_ref().is_none_or(|only| only == title) {
            table(rounds());
        }
    }
}

fn rounds() -> usize {
    let given = std::env::args().nth(3).and_then(|text| text.parse().ok());
    given.unwrap_or(31)
}

/// Time of this thread [ns]: what others do on the machine counts little.
fn now() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    1e9 * time.tv_sec as f64 + time.tv_nsec as f64
}

fn table(title: &str, states: &States, work: Work, peers: &[Peer]) {
    let mut ways = Vec::new();
    for peer in peers {
        ways.push(Way {
            name: peer.name.clone(),
            run: Box::new(|| peer.run(states, work.given)),
            times: vec![],
        });
    }
    let mut alone = Workspace::new(1);
    ways.push(Way {
        name: "one call each".into(),
        run: Box::new(move || alone.one_by_one(states, work)),
        times: vec![],
    });
    for width in [Width::One, Width::Four, Width::Eight] {
        if width > Width::widest() {
            continue;
        }
        for size in [8, 16, 256] {
            let mut workspace = Workspace::new(size);
            ways.push(Way {
                name: format!("batch of {size}, {width:?}"),
                run: Box::new(move || workspace.batches(states, work, width)),
                times: vec![],
            });
        }
    }
    for _ in 0..rounds() {
        for way in &mut ways {
            let start = now();
            (way.run)();
            way.times.push((now() - start) / states.count as f64);
        }
    }
    print(title, &mut ways);
}

fn print(title: &str, ways: &mut [Way<'_>]) {
    println!("\n{title}\n| way | ns, median | least |\n|---|---:|---:|");
    for way in ways {
        way.times.sort_by(f64::total_cmp);
        let median = way.times[way.times.len() / 2];
        println!("| {} | {median:.1} | {:.1} |", way.name, way.times[0]);
    }
}
