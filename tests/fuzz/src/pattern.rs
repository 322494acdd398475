//! A sparse matrix and the elements that go into it, and what both scatter maps have to say of it.

use crate::element::Element;
use crate::entropy::Entropy;
use crate::harness::Checked;
use crate::state::State;

/// A pattern and the elements that go into it.
#[derive(Debug)]
pub struct Pattern {
    /// As passed to the library.
    pub n: i64,
    /// As passed to the library.
    pub nslave: i32,
    /// Nodes of an element.
    pub nodes: usize,
    /// Nodes of each element.
    pub connectivity: Vec<i32>,
    /// As passed to the library.
    pub rows: i64,
    /// Where each row begins, and the end of the last.
    pub start: Vec<i64>,
    /// Columns, row by row.
    pub column: Vec<i32>,
}

/// Node and component of an unknown of an element.
pub fn place(element: &Element, nodes: usize, unknown: usize) -> (usize, usize) {
    let (d, positions) = (element.dimension(), nodes - element.multipliers);
    match unknown.checked_sub(positions * d) {
        Some(multiplier) => (positions + multiplier, 0),
        None => (unknown / d, unknown % d),
    }
}

impl Pattern {
    /// Every row has a column for every row.
    pub fn full(element: &Element, state: &State, count: usize, entropy: &mut Entropy) -> Self {
        let (d, nodes) = (element.dimension(), state.nodes);
        let global = nodes + entropy.below(nodes * count);
        let rows = global * d;
        let mut connectivity = Vec::with_capacity(count * nodes);
        for _ in 0..count {
            let first = entropy.below(global);
            connectivity.extend((0..nodes).map(|a| ((first + a) % global) as i32));
        }
        Self {
            n: count as i64,
            nslave: state.nslave as i32,
            nodes,
            connectivity,
            rows: rows as i64,
            start: (0..=rows).map(|row| (row * rows) as i64).collect(),
            column: (0..rows * rows).map(|at| (at % rows) as i32).collect(),
        }
    }

    /// One change.
    pub fn change(&mut self, element: &Element, entropy: &mut Entropy) {
        match entropy.below(10) {
            0 => self.n = entropy.pick(&[0, -1, i64::MIN, i64::MAX, 1 << 60]),
            1 if element.interpolated() => {
                self.nslave = entropy.pick(&[0, -1, i32::MAX, 1 << 30]);
            }
            1 => self.nslave = entropy.strange_i32(self.nslave),
            2 => {
                let at = entropy.below(self.connectivity.len());
                self.connectivity[at] = entropy.strange_i32(self.connectivity[at]);
            }
            3 => {
                // the last one is the length of the columns
                let at = entropy.below(self.start.len() - 1);
                self.start[at] = entropy.pick(&[-1, i64::MIN, i64::MAX, 0, self.start[at] + 1]);
            }
            4 => {
                let at = entropy.below(self.column.len());
                self.column[at] = entropy.strange_i32(self.column[at]);
            }
            5 => {
                if let Some(last) = self.start.last_mut() {
                    *last = entropy.pick(&[-1, i64::MIN, i64::MAX, 0]);
                }
            }
            6 => self.rows = entropy.pick(&[-1, i64::MIN, i64::MAX, 0, self.rows - 1]),
            _ => {
                let row = entropy.below(self.start.len() - 1);
                let column = entropy.below(self.start.len() - 1) as i32;
                let d = element.dimension();
                // of one row, or of all rows of a node
                let (first, count) = entropy.pick(&[(row, 1), (row / d * d, d)]);
                (first..first + count).for_each(|row| self.leave_out(row, column));
            }
        }
        // fewer rows end where their last one ends
        if let Some(&last) = usize::try_from(self.rows)
            .ok()
            .and_then(|r| self.start.get(r))
        {
            let room = i64::try_from(self.column.len()).unwrap_or(0);
            if last > room && last < 1 << 60 {
                self.rows = 0;
            }
        }
    }

    /// Takes an entry out of a row.
    fn leave_out(&mut self, row: usize, column: i32) {
        let Some((start, own)) = self.row(row as i64) else {
            return;
        };
        let Some(at) = own.iter().position(|&other| other == column) else {
            return;
        };
        // a matrix has an entry
        if self.column.len() > 1 {
            self.column.remove(start + at);
            for start in &mut self.start[row + 1..] {
                *start = start.wrapping_sub(1);
            }
        }
    }

    /// Where a row begins, and its columns; `None` if there is no such row.
    fn row(&self, row: i64) -> Option<(usize, &[i32])> {
        let at = usize::try_from(row).ok().filter(|_| row < self.rows)?;
        let start = usize::try_from(*self.start.get(at)?).ok()?;
        let end = usize::try_from(*self.start.get(at + 1)?).ok()?;
        Some((start, self.column.get(start..end)?))
    }

    /// Row of an element's unknown.
    fn row_of(&self, element: &Element, e: usize, unknown: usize) -> i64 {
        let (a, component) = place(element, self.nodes, unknown);
        let node = i64::from(self.connectivity[e * self.nodes + a]);
        node * element.dimension() as i64 + component as i64
    }

    /// Elements that the map was made of.
    fn count(&self) -> usize {
        usize::try_from(self.n).unwrap_or(0)
    }

    /// The place of every entry is in its row and has its column.
    pub fn check(&self, element: &Element, map: &[i64]) -> Checked {
        let unknowns = element.unknowns(self.nodes);
        for (at, &place) in map.iter().enumerate() {
            let (e, i, j) = (
                at / (unknowns * unknowns),
                at / unknowns % unknowns,
                at % unknowns,
            );
            let (row, column) = (self.row_of(element, e, i), self.row_of(element, e, j));
            let found = self.row(row).and_then(|(start, columns)| {
                let own = usize::try_from(place).ok()?.checked_sub(start)?;
                columns.get(own)
            });
            if found.is_none_or(|&found| i64::from(found) != column) {
                return Err(format!("map entry {at}: {place} is not ({row}, {column})"));
            }
        }
        Ok(())
    }

    /// What a map of blocks says of every entry.
    pub fn expanded(element: &Element, nodes: usize, blocks: &[i64]) -> Vec<i64> {
        let unknowns = element.unknowns(nodes);
        let mut map = Vec::new();
        for own in blocks.chunks(nodes * (nodes + 1)) {
            for i in 0..unknowns {
                let (a, row) = place(element, nodes, i);
                let node = &own[a * (nodes + 1)..(a + 1) * (nodes + 1)];
                for j in 0..unknowns {
                    let (b, column) = place(element, nodes, j);
                    let down = node[nodes].wrapping_mul(row as i64);
                    map.push(node[b].wrapping_add(down).wrapping_add(column as i64));
                }
            }
        }
        map
    }

    /// Codes of both functions, of which none had to refuse its pointers: where the rows in use are those of a matrix,
    /// both find the same missing, and blocks are found where all rows of a node have the same columns.
    pub fn check_codes(&self, element: &Element, [map, blocks]: [i32; 2]) -> Checked {
        const INDEX: i32 = -8;
        let mut rows = Vec::new();
        for e in 0..self.count().min(self.connectivity.len() / self.nodes) {
            for unknown in 0..element.unknowns(self.nodes) {
                let is_first = place(element, self.nodes, unknown).1 == 0;
                rows.push((
                    is_first,
                    self.row(self.row_of(element, e, unknown)).map(|row| row.1),
                ));
            }
        }
        let is_sorted = |columns: &[i32]| columns.windows(2).all(|pair| pair[0] < pair[1]);
        let are_rows = rows
            .iter()
            .all(|(_, columns)| columns.is_some_and(is_sorted));
        if !are_rows {
            return Ok(());
        }
        let are_alike = rows
            .windows(2)
            .all(|pair| pair[1].0 || pair[0].1 == pair[1].1);
        let as_expected = match map {
            0 if are_alike => blocks == 0,
            0 => blocks == 0 || blocks == INDEX,
            _ => blocks == map,
        };
        match as_expected {
            true => Ok(()),
            false => Err(format!("csr_map: {map}, csr_blocks: {blocks}")),
        }
    }
}
