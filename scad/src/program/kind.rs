//! The kinds of parts that programs of this importer have.

/// What a part of a program is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // solids by their names
pub enum Kind {
    Cylinder,
    Cuboid,
    Sphere,
    Cone,
    Torus,
    Polyhedron,
    ScaledCylinder,
    ScaledSphere,
    ScaledCone,
    ScaledTorus,
}

impl Kind {
    /// All kinds, in the order of their numbers here.
    pub const ALL: [Self; 10] = [
        Self::Cylinder,
        Self::Cuboid,
        Self::Sphere,
        Self::Cone,
        Self::Torus,
        Self::Polyhedron,
        Self::ScaledCylinder,
        Self::ScaledSphere,
        Self::ScaledCone,
        Self::ScaledTorus,
    ];

    /// Whether it is another solid, stretched.
    pub(super) fn is_scaled(self) -> bool {
        matches!(
            self,
            Self::ScaledCylinder | Self::ScaledSphere | Self::ScaledCone | Self::ScaledTorus
        )
    }

    /// Its type in Rust, for polyhedra of so many faces.
    #[must_use]
    pub fn solid(self, faces: usize) -> String {
        let name = format!("{self:?}");
        match (self, name.strip_prefix("Scaled")) {
            (Self::Polyhedron, _) => format!("Polyhedron<S, {faces}>"),
            (_, Some(inner)) => format!("Scaled<{inner}<S>>"),
            (_, None) => format!("{name}<S>"),
        }
    }
}
