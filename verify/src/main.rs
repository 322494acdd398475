fn main() {
    let n: u64 = std::env::args().nth(1).map_or(200, |a| a.parse().unwrap());
    let filter = std::env::args().nth(2).unwrap_or_default();
    use contact_verify::*;
    use configurations::Wanted;
    let subjects = subject::built_in().unwrap();
    let t = proof::tables::prove(&subjects, 1);
    println!("{t:?}");
    for s in &subjects {
        if !s.name().contains(&filter) { continue; }
        for w in [Wanted::Closed, Wanted::Open, Wanted::Outside] {
            let t0 = std::time::Instant::now();
            if let Some(r) = proof::random::prove(s, w, n, 7) {
                println!("{:30} {:?} R {:.1e} K {:.1e} W {:.1e} fail {} of {} {:?} {:?} {:.2}s", s.name(), w, r.residual.error, r.tangent.error, r.energy.error, r.finding.failed, r.finding.tried, r.statuses, r.features, t0.elapsed().as_secs_f64());
                for f in r.finding.failures.iter().take(2) { println!("     {f}"); }
            }
        }
    }
}
