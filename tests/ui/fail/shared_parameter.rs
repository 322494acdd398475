//! Law and geometry of one element have a parameter of the same name.
contact_elements::contact_elements! {
    rigid distance Pipe(x, y, z; m: "length" in (0, inf)) {
        d = sqrt(x*x + y*y) - m;
    }
    element PointPipe { slave: point; master: Pipe placed; normal: PowerLaw; }
}

fn main() {}
