//! Pages that carom writes, opened from files in a headless Chromium.
//!
//! Chromium is found where it is usually installed, or named by `CHROME`.

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use headless_chrome::protocol::cdp::types::Event;
use headless_chrome::protocol::cdp::{Emulation, Network};
use headless_chrome::{Browser, LaunchOptions, Tab};
use serde_json::Value;
use tempfile::TempDir;

/// How long a page may take for what is expected of it.
const PATIENCE: Duration = Duration::from_secs(60);

/// Where carom is.
fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// A scene of the gallery.
pub fn scene(name: &str) -> String {
    root().join("scenes").join(name).display().to_string()
}

/// What carom prints.
pub fn carom(arguments: &[&str]) -> String {
    let manifest = root().join("Cargo.toml");
    let mut command = Command::new(env!("CARGO"));
    command.args(["run", "--release", "--quiet", "--manifest-path"]);
    command.arg(manifest).arg("--").args(arguments);
    let output = command.output().expect("cargo runs");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {complaint}");
    String::from_utf8(output.stdout).expect("text")
}

/// A page in a browser of its own.
pub struct Page {
    tab: Arc<Tab>,
    complaints: Arc<Mutex<Vec<String>>>,
    requests: Arc<Mutex<Vec<String>>>,
    _browser: Browser,
    _directory: TempDir,
}

impl Page {
    /// Opens what carom writes to the file that is the last argument.
    pub fn of(arguments: &[&str], size: [u32; 2]) -> Self {
        let directory = tempfile::tempdir().expect("a directory");
        let file = directory.path().join("page.html");
        let html = carom(&[arguments, &["-"]].concat());
        fs::write(&file, html).expect("a file");
        let options = LaunchOptions {
            sandbox: false,
            idle_browser_timeout: PATIENCE * 5,
            ..LaunchOptions::default()
        };
        let browser = Browser::new(options).expect("Chromium is installed");
        let tab = browser.new_tab().expect("a tab");
        tab.set_default_timeout(PATIENCE);
        let page = Self {
            complaints: Arc::default(),
            requests: Arc::default(),
            tab,
            _browser: browser,
            _directory: directory,
        };
        page.listen();
        page.tab.call_method(screen(size)).expect("a size");
        let address = format!("file://{}", file.display());
        page.tab.navigate_to(&address).expect("it loads");
        page.tab.wait_until_navigated().expect("it has loaded");
        page.until("document.readyState === 'complete'");
        page
    }

    /// Notes errors and requests.
    fn listen(&self) {
        self.tab.enable_runtime().expect("events");
        self.tab.enable_log().expect("events");
        self.tab.call_method(network()).expect("events");
        let (complaints, requests) = (self.complaints.clone(), self.requests.clone());
        let listener = move |event: &Event| match event {
            Event::RuntimeExceptionThrown(thrown) => note(&complaints, format!("{thrown:?}")),
            Event::LogEntryAdded(added) => note(&complaints, format!("{added:?}")),
            Event::NetworkRequestWillBeSent(sent) => {
                note(&requests, sent.params.request.url.clone());
            }
            _ => {}
        };
        let listener = self.tab.add_event_listener(Arc::new(listener));
        listener.expect("a listener");
    }

    /// The value of an expression in the page.
    pub fn value(&self, expression: &str) -> Value {
        let result = self.tab.evaluate(expression, true);
        let result = result.unwrap_or_else(|error| panic!("{expression}: {error}"));
        result.value.unwrap_or(Value::Null)
    }

    /// The number that an expression is.
    pub fn number(&self, expression: &str) -> f64 {
        let value = self.value(expression);
        value
            .as_f64()
            .unwrap_or_else(|| panic!("{expression}: {value}"))
    }

    /// The places of discs in a pane, as x and y.
    pub fn places(&self, pane: usize) -> Vec<[f64; 2]> {
        let json = self.value(&format!("JSON.stringify(replays[0].positions({pane}))"));
        serde_json::from_str(json.as_str().expect("a text")).expect("points")
    }

    /// Waits for an expression to be true.
    pub fn until(&self, expression: &str) {
        let begun = Instant::now();
        while self.value(expression) != Value::Bool(true) {
            assert!(begun.elapsed() < PATIENCE, "{expression} never is");
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// Moves a slider, as a hand does.
    pub fn slide(&self, selector: &str, value: f64) {
        self.value(&format!(
            "{{ const slider = document.querySelector('{selector}'); slider.value = {value};
               slider.dispatchEvent(new Event('input', {{ bubbles: true }})); null }}"
        ));
    }

    pub fn click(&self, selector: &str) {
        let element = self.tab.find_element(selector).expect(selector);
        element.click().expect(selector);
    }

    pub fn press(&self, key: &str) {
        self.tab.press_key(key).expect(key);
    }

    /// Lets the user prefer the dark.
    pub fn darken(&self) {
        let feature = Emulation::MediaFeature {
            name: String::from("prefers-color-scheme"),
            value: String::from("dark"),
        };
        let media = Emulation::SetEmulatedMedia {
            media: None,
            features: Some(vec![feature]),
        };
        self.tab.call_method(media).expect("a preference");
    }

    /// What the page has complained of, and what it has asked for besides itself.
    pub fn troubles(&self) -> Vec<String> {
        let complaints = self.complaints.lock().expect("a list").clone();
        let requests = self.requests.lock().expect("a list").clone();
        let own = self.tab.get_url();
        let others = requests.into_iter().filter(|address| *address != own);
        complaints.into_iter().chain(others).collect()
    }
}

fn note(list: &Mutex<Vec<String>>, line: String) {
    list.lock().expect("a list").push(line);
}

/// A screen, which may be smaller than any window.
fn screen([width, height]: [u32; 2]) -> Emulation::SetDeviceMetricsOverride {
    Emulation::SetDeviceMetricsOverride {
        width,
        height,
        device_scale_factor: 1.0,
        mobile: true,
        scale: None,
        screen_width: None,
        screen_height: None,
        position_x: None,
        position_y: None,
        dont_set_visible_size: None,
        screen_orientation: None,
        viewport: None,
        display_feature: None,
        device_posture: None,
    }
}

/// Asks for events of the network.
fn network() -> Network::Enable {
    Network::Enable {
        max_total_buffer_size: None,
        max_resource_buffer_size: None,
        max_post_data_size: None,
        report_direct_socket_traffic: None,
        enable_durable_messages: None,
    }
}
