//! Results side by side.

use axum::extract::{Query, State};
use serde::Deserialize;
use utoipa::IntoParams;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_units::UnitSet;

use super::{Json, blocking, error::ApiError};
use crate::{
    app::App,
    results::{Compared, compare},
};

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(compared))
}

/// Maximum number of compared results.
const MOST: usize = 6;

/// Parameters of a comparison.
#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(crate) struct Asked {
    /// Ids of results, separated by commas: two to six.
    ids: String,
    /// The units: `si`, `metric` or `field`.
    #[serde(default)]
    units: Option<String>,
}

/// Comparison of two to six results: differing inputs, numbers, and curves against depth.
#[utoipa::path(
    get,
    path = "/api/compare",
    params(Asked),
    responses(
        (status = 200, body = Compared),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn compared(
    State(app): State<App>,
    Query(query): Query<Asked>,
) -> Result<Json<Compared>, ApiError> {
    blocking(move || {
        let ids: Vec<&str> = query.ids.split(',').filter(|id| !id.is_empty()).collect();
        if !(2..=MOST).contains(&ids.len()) {
            let count = ids.len();
            return Err(ApiError::bad_input(format!(
                "two to {MOST} results are compared, not {count}"
            )));
        }
        let units = query.units.as_deref().unwrap_or("si").parse::<UnitSet>();
        let units = units.map_err(|error| ApiError::bad_input(error.to_string()))?;
        let places = ids.into_iter().map(|id| app.workspace.results_of(id));
        let places: Vec<_> = places.collect::<Result<_, _>>()?;
        Ok(Json(compare(&places, units)))
    })
    .await
}
