//! A page of results, to be shown inside the app.

/// Policy of the frame of a page: its own scripts, downloads that the reader requests, and printing
/// by its button. It has an origin of its own, so that its requests are not taken for those of the
/// app, and may send none.
pub(crate) const POLICY: &str = "sandbox allow-scripts allow-downloads allow-modals; \
    default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
    img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'; \
    frame-ancestors 'self'";

/// Links of a page lead to neighbouring files, which a frame without an origin cannot request, so
/// that they are posted to the surrounding app. The page prints when the app requests it.
const SCRIPT: &str = r##"<script>
addEventListener("click", (event) => {
  const link = event.target instanceof Element ? event.target.closest("a[href]") : null;
  const address = link?.getAttribute("href") ?? "#";
  if (/^(#|blob:|data:)/.test(address)) return;
  event.preventDefault();
  parent.postMessage({ file: decodeURIComponent(address) }, "*");
});
addEventListener("message", (event) => {
  if (event.source === parent && event.data === "print") print();
});
</script>
"##;

/// Start of a page's own policy, which would block the app's script.
const OWN_POLICY: &[u8] = b"<meta http-equiv=\"Content-Security-Policy\" content=\"";

/// The page as shown: with the app's script, and with the app's policy in place of its own.
pub(crate) fn page(mut html: Vec<u8>) -> Vec<u8> {
    if let Some(begin) = html.windows(OWN_POLICY.len()).position(|part| part == OWN_POLICY)
        && let Some(length) = html[begin..].iter().position(|byte| *byte == b'>')
    {
        html.drain(begin..=begin + length);
    }
    html.extend_from_slice(SCRIPT.as_bytes());
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_policy_of_a_page_gives_way_to_ours() {
        let own = String::from_utf8_lossy(OWN_POLICY);
        let html = format!("<head>{own}default-src 'none'\">\n<p>");
        let html = String::from_utf8(page(html.into_bytes())).expect("a text");
        assert_eq!(html, format!("<head>\n<p>{SCRIPT}"));
        assert_eq!(page(b"<p>".to_vec()), [&b"<p>"[..], SCRIPT.as_bytes()].concat());
    }
}
