//! The settings of a connection: what copying adds to the ends of a base URL and a token is
//! taken off, any other fault is an error that repeats no secret.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use crate::worker::Failure;
use proctor_client::apis::configuration::Configuration;
use proctor_client::apis::ResponseContent;
use proctor_client::models::Run;

const REDIRECTS_MAX: usize = 5;
/// A gateway that answers so never lets this request pass.
const UNPASSABLE: [u16; 13] = [400, 405, 411, 413, 414, 415, 416, 417, 421, 426, 431, 501, 505];
/// Whether a server of Proctor has answered this program.
pub static HAS_ANSWERED: AtomicBool = AtomicBool::new(false);
const QUOTES: [(char, char); 5] = [('"', '"'), ('\'', '\''), ('`', '`'), ('\u{201c}', '\u{201d}'), ('\u{2018}', '\u{2019}')];

/// An error with its causes: the operating system's is the last.
pub fn reasons(error: &dyn std::error::Error) -> String {
    error.source().map_or(error.to_string(), |cause| format!("{error}: {}", reasons(cause)))
}

/// The control plane of one server.
pub fn at(url: &str, token: &str) -> Result<Configuration, Failure> {
    connect(url, token).map_err(Failure::Wrong)
}

/// The data plane that a run names.
pub fn data(control: &Configuration, run: &Run) -> Result<Configuration, Failure> {
    at(&run.endpoint, control.bearer_access_token.as_deref().unwrap_or_default())
}

fn connect(base_url: &str, token: &str) -> Result<Configuration, String> {
    let base_path = clean_base_url(base_url)?;
    let mut builder = reqwest::Client::builder().timeout(Duration::from_secs(60)).redirect(near());
    if is_this_machine(&base_path) {
        builder = builder.no_proxy(); // whatever the environment names
    }
    let client = builder.build().map_err(|error| error.to_string())?;
    let bearer_access_token = Some(clean_token(token)?);
    Ok(Configuration { base_path, client, bearer_access_token, ..Configuration::default() })
}

/// Why an answer without a problem brought nothing. It may soon be gone, if it is the fault of
/// a gateway, or, where a server of Proctor has answered before, a page that is not the server's.
pub fn failure_of<T>(answer: &ResponseContent<T>) -> Failure {
    let status = answer.status.as_u16();
    let kind = answer.headers.get("content-type").and_then(|kind| kind.to_str().ok()).unwrap_or_default();
    let is_page = kind.to_ascii_lowercase().starts_with("text/html");
    let is_of_proctor = answer.headers.contains_key("proctor-version");
    let is_final = UNPASSABLE.contains(&status) || (answer.status.is_success() && !is_page);
    let is_of_gateway = status == 429 || status >= 500;
    let is_passing = HAS_ANSWERED.load(Ordering::Relaxed) && !is_of_proctor;
    let what = if is_page { "a page, text/html" } else { "no message of Proctor" };
    let why = format!("{} answered {}: {what}. {}", who_answered(&answer.url), answer.status, hint(answer));
    if !is_final && (is_of_gateway || is_passing) { Failure::Lost(why) } else { Failure::Wrong(why) }
}

/// The server, and the proxy that may have answered in its place.
fn who_answered(sent: &reqwest::Url) -> String {
    let who = sent.origin().ascii_serialization();
    let names = ["http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY"];
    let proxy = names.iter().find_map(|name| reqwest::Url::parse(&std::env::var(name).ok()?).ok());
    match proxy {
        // Nothing changes what a tunnel has.
        Some(proxy) if sent.scheme() == "http" && !is_this_machine(sent.as_str()) => {
            format!("{who}, or the proxy {} in its place,", proxy.origin().ascii_serialization())
        }
        _ => who,
    }
}

/// What to change, where an answer shows that the base URL is wrong.
fn hint<T>(answer: &ResponseContent<T>) -> String {
    let location = answer.headers.get("location").and_then(|place| answer.url.join(place.to_str().ok()?).ok());
    let Some(mut place) = location.filter(|_| answer.status.is_redirection()) else {
        return "Check that the URL is that of a Proctor server; a network that wants a sign-in in a browser answers so, too.".to_owned();
    };
    let _ = (place.set_username(""), place.set_password(None)); // they may be a secret
    let sent = answer.url.as_str();
    let target = sent.find("/v1").map_or(sent, |at| &sent[at..]);
    match place.as_str().strip_suffix(target) {
        Some(base) => format!("The server has moved to {base}: give that as the base URL."),
        None => format!("It redirects to {}: a network may want a sign-in in a browser.", place.origin().ascii_serialization()),
    }
}

/// Redirections within an origin that keep the method; others would lose the body, or show
/// the token to another server.
fn near() -> reqwest::redirect::Policy {
    reqwest::redirect::Policy::custom(|attempt| {
        let is_near = attempt.previous().last().is_some_and(|from| from.origin() == attempt.url().origin());
        let keeps_method = matches!(attempt.status().as_u16(), 307 | 308);
        if is_near && keeps_method && attempt.previous().len() <= REDIRECTS_MAX {
            attempt.follow()
        } else {
            attempt.stop()
        }
    })
}

fn is_this_machine(base_url: &str) -> bool {
    let place = place_of(base_url).unwrap_or_default();
    ["localhost", "127.", "[::1]"].iter().any(|host| place.starts_with(host))
}

fn place_of(url: &str) -> Option<&str> {
    let (scheme, rest) = url.split_once("://")?;
    let is_http = scheme.eq_ignore_ascii_case("http") || scheme.eq_ignore_ascii_case("https");
    is_http.then(|| rest.split(['/', '?', '#']).next().unwrap_or_default())
}

fn is_invisible(c: char) -> bool {
    let is_mark = matches!(c, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2064}' | '\u{feff}');
    c.is_whitespace() || c.is_control() || is_mark
}

fn trimmed(text: &str) -> &str {
    let inner = text.trim_matches(is_invisible);
    let inside = QUOTES.iter().find_map(|(open, close)| inner.strip_prefix(*open)?.strip_suffix(*close));
    inside.map_or(inner, trimmed)
}

fn clean_token(text: &str) -> Result<String, String> {
    let mut token = trimmed(text);
    for word in ["authorization:", "bearer "] {
        if token.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word)) {
            token = token[word.len()..].trim_start();
        }
    }
    let Some((at, c)) = token.chars().enumerate().find(|(_, c)| !('!'..='~').contains(c)) else {
        return Ok(token.to_owned());
    };
    let what = match c {
        ' ' => "a space".to_owned(),
        c if is_invisible(c) => format!("an invisible character (U+{:04X})", u32::from(c)),
        _ => "a character that is not ASCII".to_owned(),
    };
    let count = token.chars().count();
    Err(format!("the token has {what} at position {} of {count}: copy it again, as it was printed", at + 1))
}

fn clean_base_url(text: &str) -> Result<String, String> {
    let url = trimmed(text).trim_end_matches('/');
    let place = place_of(url).ok_or("the base URL must be like http://127.0.0.1:8460 or https://robots.example/path")?;
    let fault = if place.contains('@') {
        "has a user or a password, which no request would carry: a server is given a token"
    } else if place.contains('%') {
        "names a network interface (a zone id, behind %), which only this machine knows: use another address, or the name of the server"
    } else if place.matches(':').count() > 1 && !place.starts_with('[') {
        "has an IPv6 address without brackets: write http://[::1]:8460"
    } else if url.contains(['?', '#']) {
        "ends with a query: give the part before the ? or #"
    } else if reqwest::Url::parse(url).is_err() {
        "has an invalid host or port"
    } else if url.contains(is_invisible) {
        "has a space or an invisible character in it"
    } else {
        return Ok(url.to_owned());
    };
    Err(format!("the base URL {fault}"))
}

/// A name that is not in use.
pub fn unique() -> String {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let now = SystemTime::now().duration_since(UNIX_EPOCH).expect("after 1970").as_nanos();
    format!("{now:x}-{:x}-{:x}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed))
}
