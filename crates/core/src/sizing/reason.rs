//! Why elements are as long as they are.

/// Why elements are as long as they are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SizeReason {
    /// The length is given.
    Given,
    /// Pipe that hangs or rests on its tool joints.
    JointToJoint,
    /// Pipe without tool joints.
    PlainPipe,
    /// The bottom-hole assembly.
    Assembly,
    /// Next to a bend that turns with the string.
    RotatingBend,
    /// The body touches the wall between the joints.
    BodyContact,
    /// Compression near or beyond the critical load of sinusoidal buckling.
    Compression,
    /// An equilibrium shows that the bending turns there: a contact of the body begins or ends, or
    /// the hole bends otherwise.
    Refined,
}

impl SizeReason {
    /// Every reason.
    pub const ALL: [Self; 8] = [
        Self::Given,
        Self::JointToJoint,
        Self::PlainPipe,
        Self::Assembly,
        Self::RotatingBend,
        Self::BodyContact,
        Self::Compression,
        Self::Refined,
    ];

    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::JointToJoint => "joint to joint",
            Self::PlainPipe => "plain pipe",
            Self::Assembly => "assembly",
            Self::RotatingBend => "rotating bend",
            Self::BodyContact => "body contact",
            Self::Compression => "compression",
            Self::Refined => "refined",
        }
    }
}
