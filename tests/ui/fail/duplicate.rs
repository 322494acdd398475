//! One name for two items, and a name that is not in camel case.
contact_elements::contact_elements! {
    rigid distance Ball(x, y, z; radius: "length" in (0, inf)) {
        d = sqrt(x*x + y*y + z*z) - radius;
    }
    curve Ball(t) in unit_line { N = [1 - t, t]; }
    element point_ball { slave: point; master: SphereDistance placed; normal: Penalty; }
}

fn main() {}
