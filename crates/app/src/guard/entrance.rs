//! The pages at which a link is exchanged for the cookie of the session.
//!
//! `GET /enter` is public and contains no secret. Its script moves the code from the fragment of
//! the address into a form, replaces the address, and sends the form; the file that the program
//! opens contains the filled form itself. Thus no address that the server receives, and none that
//! the history of the browser keeps, has the code.

use axum::{
    http::{HeaderName, StatusCode, header},
    response::{Html, IntoResponse, Response},
};

/// Place of the exchange.
pub(crate) const PATH: &str = "/enter";

/// Place of its script; the policy allows no script within a page.
pub(crate) const SCRIPT_PATH: &str = "/enter.js";

/// Maximum size of a form, bytes.
pub(crate) const LONGEST_FORM: usize = 1 << 10;

const SCRIPT: &str = "\"use strict\";\n\
    const code = location.hash.slice(1);\n\
    history.replaceState(null, \"\", location.pathname);\n\
    const form = document.forms[0];\n\
    if (code !== \"\" && form) {\n  form.elements.code.value = code;\n  form.submit();\n}\n";

const POLICY: (HeaderName, &str) = (
    header::CONTENT_SECURITY_POLICY,
    "default-src 'none'; script-src 'self'; base-uri 'none'; form-action 'self'; \
     frame-ancestors 'none'",
);

const HEAD: &str = "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">\
    <meta name=\"viewport\" content=\"width=device-width\">\
    <meta name=\"color-scheme\" content=\"light dark\">\
    <meta name=\"referrer\" content=\"no-referrer\"><title>wholestring</title>";

/// The page of `GET /enter`.
pub(crate) fn page() -> Response {
    let page = format!(
        "{HEAD}<main><h1>wholestring</h1><form method=\"post\" action=\"{PATH}\" autocomplete=\"off\">\
         <p><label>The link of the program ends in <code>#</code> and a code. Code: \
         <input name=\"code\" required></label> <button>Open</button></p></form></main>\
         <script src=\"{SCRIPT_PATH}\"></script></html>"
    );
    ([POLICY], Html(page)).into_response()
}

/// The script of that page.
pub(crate) fn script() -> Response {
    ([(header::CONTENT_TYPE, "text/javascript; charset=utf-8")], SCRIPT).into_response()
}

/// The page of a file on disk, which sends the code to `action`.
pub(super) fn form(action: &str, code: &str) -> String {
    format!(
        "{HEAD}<main><form method=\"post\" action=\"{action}\">\
         <input type=\"hidden\" name=\"code\" value=\"{code}\">\
         <p>wholestring is opened. <button>Open</button></p></form></main>\
         <script>document.forms[0].submit()</script></html>\n"
    )
}

/// The code in a sent form; its letters need no decoding.
pub(crate) fn code(form: &[u8]) -> Option<&str> {
    let form = std::str::from_utf8(form).ok()?;
    form.split('&').find_map(|pair| pair.strip_prefix("code="))
}

/// Sends the browser on to the app, with the cookie if it needs one.
///
/// It is a page and no redirect: a redirect would still count as sent by the file on disk, and the
/// browser would keep a `SameSite=Strict` cookie back.
pub(crate) fn admitted(cookie: Option<String>) -> Response {
    let page = format!(
        "{HEAD}<meta http-equiv=\"refresh\" content=\"0;url=/\">\
         <main><p><a href=\"/\">wholestring</a></p></main></html>"
    );
    let cookie = cookie.map(|cookie| [(header::SET_COOKIE, cookie)]);
    ([POLICY], cookie, Html(page)).into_response()
}

/// The answer to a code that admits nobody.
pub(crate) fn used() -> Response {
    let page = format!(
        "{HEAD}<main><h1>wholestring</h1><p>This link is used up: each link lets in one browser, once, \
         and ends with the program that made it. The terminal of the program shows a new link.</p>\
         </main></html>"
    );
    (StatusCode::FORBIDDEN, [POLICY], Html(page)).into_response()
}

/// The answer to a browser that has not been let in.
pub(crate) fn stranger() -> Response {
    let page = format!(
        "{HEAD}<main><h1>wholestring</h1><p>This page belongs to whoever started the program. Use the \
         link that it printed: it ends in <code>{PATH}#</code> and a code, lets in one browser, \
         once, and is new with every start.</p></main></html>"
    );
    (StatusCode::UNAUTHORIZED, [POLICY], Html(page)).into_response()
}
