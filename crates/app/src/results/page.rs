//! A page of results, to be shown inside the app.

/// What the frame of a page may do: its own scripts, and files that the reader asks for; its button
/// prints. It has an origin of its own, so that no request of it is taken for one of the app's, and
/// may send none.
pub(crate) const POLICY: &str = "sandbox allow-scripts allow-downloads allow-modals; \
    default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
    img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'; \
    frame-ancestors 'self'";

/// Links of a page lead to files beside it, which a frame without an origin cannot ask for: the app
/// around it is told of them.
const LINKS: &str = r##"<script>
addEventListener("click", (event) => {
  const link = event.target instanceof Element ? event.target.closest("a[href]") : null;
  const address = link?.getAttribute("href") ?? "#";
  if (/^(#|blob:|data:)/.test(address)) return;
  event.preventDefault();
  parent.postMessage({ file: decodeURIComponent(address) }, "*");
});
</script>
"##;

/// The page as it is shown.
pub(crate) fn page(mut html: Vec<u8>) -> Vec<u8> {
    html.extend_from_slice(LINKS.as_bytes());
    html
}
