//! Affine maps of space and of the plane, in `f64`.

use scancsg::geom::{Vec3, vec3};

/// A point or a direction.
pub type Vector = Vec3<f64>;

/// A point of the plane.
pub type Point = [f64; 2];

/// The length of a vector.
#[must_use]
pub fn length(vector: Vector) -> f64 {
    vector.dot(vector).sqrt()
}

/// An affine map of space: `p ↦ x·p.x + y·p.y + z·p.z + shift`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Map {
    /// The images of the coordinate axes.
    pub columns: [Vector; 3],
    /// The image of the origin.
    pub shift: Vector,
}

impl Map {
    /// The map that moves nothing.
    pub const IDENTITY: Self = Self {
        columns: [vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0)],
        shift: vec3(0.0, 0.0, 0.0),
    };

    /// A shift.
    #[must_use]
    pub fn translation(shift: Vector) -> Self {
        Self { shift, ..Self::IDENTITY }
    }

    /// A map that makes everything so many times as large.
    #[must_use]
    pub fn scaling(factor: f64) -> Self {
        Self { columns: Self::IDENTITY.columns.map(|axis| axis * factor), ..Self::IDENTITY }
    }

    /// The map of a matrix of three or four rows of four numbers, as a node `multmatrix` has it.
    #[must_use]
    pub fn of_rows(rows: [[f64; 4]; 3]) -> Self {
        let column = |index: usize| Vec3::from(rows.map(|row| row[index]));
        Self { columns: [column(0), column(1), column(2)], shift: column(3) }
    }

    /// The image of a direction.
    #[must_use]
    pub fn direction(&self, own: Vector) -> Vector {
        let [x, y, z] = self.columns;
        x * own.x + y * own.y + z * own.z
    }

    /// The image of a point.
    #[must_use]
    pub fn point(&self, own: Vector) -> Vector {
        self.direction(own) + self.shift
    }

    /// This map behind another one: `p ↦ self(first(p))`.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        Self {
            columns: first.columns.map(|column| self.direction(column)),
            shift: self.point(first.shift),
        }
    }

    /// By how much it changes volumes; below zero for one that mirrors.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        let [x, y, z] = self.columns;
        x.dot(y.cross(z))
    }

    /// The normals of planes, mapped: the cofactors of the matrix, which turn a normal into one of
    /// another length.
    #[must_use]
    pub fn normal(&self, own: Vector) -> Vector {
        let [x, y, z] = self.columns;
        let sign = if self.determinant() < 0.0 { -1.0 } else { 1.0 };
        (y.cross(z) * own.x + z.cross(x) * own.y + x.cross(y) * own.z) * sign
    }

    /// The factor by which it scales all lengths, if it is the same for all to `tolerance` of it.
    #[must_use]
    pub fn uniform_scale(&self, tolerance: f64) -> Option<f64> {
        let [x, y, z] = self.columns;
        let scale = self.determinant().abs().cbrt();
        let is_near = |got: f64, want: f64| (got - want).abs() <= tolerance * scale * scale;
        let square = scale * scale;
        let is_uniform = [x, y, z].iter().all(|column| is_near(column.dot(*column), square))
            && [x.dot(y), y.dot(z), z.dot(x)].iter().all(|product| is_near(*product, 0.0));
        (is_uniform && scale > 0.0).then_some(scale)
    }

    /// What it does to the plane z = 0, without what it does to z.
    #[must_use]
    pub fn flat(&self) -> FlatMap {
        let [x, y, _] = self.columns;
        FlatMap { columns: [[x.x, x.y], [y.x, y.y]], shift: [self.shift.x, self.shift.y] }
    }
}

/// An affine map of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatMap {
    /// The images of the coordinate axes.
    pub columns: [Point; 2],
    /// The image of the origin.
    pub shift: Point,
}

impl FlatMap {
    /// The image of a point.
    #[must_use]
    pub fn point(&self, [u, v]: Point) -> Point {
        let [x, y] = self.columns;
        [x[0] * u + y[0] * v + self.shift[0], x[1] * u + y[1] * v + self.shift[1]]
    }

    /// This map behind another one.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        let own = |column: Point| Self { shift: [0.0; 2], ..*self }.point(column);
        Self { columns: first.columns.map(own), shift: self.point(first.shift) }
    }

    /// By how much it changes areas.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        let [x, y] = self.columns;
        x[0] * y[1] - x[1] * y[0]
    }

    /// As [`Map::uniform_scale`].
    #[must_use]
    pub fn uniform_scale(&self, tolerance: f64) -> Option<f64> {
        let [x, y] = self.columns;
        let square = self.determinant().abs();
        let is_near = |got: f64, want: f64| (got - want).abs() <= tolerance * square;
        let is_uniform = is_near(x[0] * x[0] + x[1] * x[1], square)
            && is_near(y[0] * y[0] + y[1] * y[1], square)
            && is_near(x[0] * y[0] + x[1] * y[1], 0.0);
        (is_uniform && square > 0.0).then_some(square.sqrt())
    }

    /// The map of space that does this in every plane along z = 0.
    #[must_use]
    pub fn upright(&self) -> Map {
        let [x, y] = self.columns;
        Map {
            columns: [vec3(x[0], x[1], 0.0), vec3(y[0], y[1], 0.0), vec3(0.0, 0.0, 1.0)],
            shift: vec3(self.shift[0], self.shift[1], 0.0),
        }
    }
}

/// How far the six digits of a `.csg` file let a matrix be off from what was meant.
pub const SIX_DIGITS: f64 = 4e-6;
