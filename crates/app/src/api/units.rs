//! All units, and the unit of each dimension in each set.

use std::collections::BTreeMap;

use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::units::{self, DimensionUnits};

use super::Json;
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(units))
}

/// All dimensions by name.
#[utoipa::path(
    get,
    path = "/api/units",
    responses((status = 200, body = BTreeMap<String, DimensionUnits>))
)]
async fn units() -> Json<BTreeMap<String, DimensionUnits>> {
    Json(units::units())
}
