//! Static torque and drag.
