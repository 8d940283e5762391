//! Chromium without a window, through its debugging pipe: messages in JSON, each ended by a zero byte.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

/// Longer than anything takes on a busy computer.
const PATIENCE: Duration = Duration::from_secs(90);

pub struct Browser {
    process: Child,
    input: ChildStdin,
    messages: Receiver<Value>,
    session: Option<String>,
    count: u64,
    /// Its profile, and what it downloads.
    folder: PathBuf,
    /// What went wrong on the page without being caught.
    exceptions: Vec<String>,
}

impl Browser {
    /// Opens the page. `script` runs there before the page's own scripts.
    pub fn open(name: &str, script: &str) -> Self {
        let page = std::env::var("SCANCSG_PAGE").expect("SCANCSG_PAGE is the page's path");
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).unwrap();
        // The debugging pipe is file descriptors 3 and 4.
        let mut process = Command::new("sh")
            .args(["-c", "exec chromium \"$@\" 3<&0 4>&1 0</dev/null 1>&2", "sh"])
            .args(["--headless", "--remote-debugging-pipe", "--no-sandbox", "--disable-gpu"])
            .args(["--no-first-run", "--disable-background-networking", "--disable-sync"])
            .args(["--disable-component-update", "--disable-quic", "--disable-dev-shm-usage"])
            .arg(format!("--user-data-dir={}", folder.join("profile").display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(std::fs::File::create(folder.join("chromium.log")).unwrap())
            .spawn()
            .unwrap();
        let (input, output) = (process.stdin.take().unwrap(), process.stdout.take().unwrap());
        let (sender, messages) = channel();
        thread::spawn(move || {
            let texts = BufReader::new(output).split(0);
            for text in texts.map_while(Result::ok) {
                let Ok(message) = serde_json::from_slice(&text) else { continue };
                if sender.send(message).is_err() {
                    break;
                }
            }
        });
        let exceptions = Vec::new();
        let mut browser =
            Self { process, input, messages, session: None, count: 0, folder, exceptions };
        let target = browser.call("Target.createTarget", json!({ "url": "about:blank" }));
        let attach = json!({ "targetId": target["targetId"], "flatten": true });
        let session = browser.call("Target.attachToTarget", attach);
        browser.session = Some(session["sessionId"].as_str().unwrap().to_owned());
        browser.call("Runtime.enable", json!({}));
        browser.call("Page.enable", json!({}));
        browser.call("Page.addScriptToEvaluateOnNewDocument", json!({ "source": script }));
        browser.call("Page.navigate", json!({ "url": format!("file://{page}") }));
        browser.wait("document.querySelector('#scene')?.options.length > 0");
        browser
    }

    /// Where the test and the browser may write.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Calls a method of the debugging protocol.
    pub fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.count += 1;
        let mut message = json!({ "id": self.count, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            message["sessionId"] = json!(session);
        }
        write!(self.input, "{message}\0").unwrap();
        self.input.flush().unwrap();
        let start = Instant::now();
        loop {
            let left = PATIENCE.saturating_sub(start.elapsed());
            let message = self.messages.recv_timeout(left);
            let message = message.unwrap_or_else(|error| panic!("{method}: {error}"));
            if message["method"] == "Runtime.exceptionThrown" {
                self.exceptions.push(message["params"].to_string());
            }
            if message["id"] == self.count {
                assert!(message["error"].is_null(), "{method}: {message}");
                return message["result"].clone();
            }
        }
    }

    /// The value of an expression on the page.
    pub fn value(&mut self, expression: &str) -> Value {
        let parameters = json!({
            "expression": expression, "awaitPromise": true, "returnByValue": true, "userGesture": true
        });
        let result = self.call("Runtime.evaluate", parameters);
        assert!(result["exceptionDetails"].is_null(), "{expression}: {result}");
        result["result"]["value"].clone()
    }

    /// Waits until an expression on the page is true.
    pub fn wait(&mut self, expression: &str) {
        let start = Instant::now();
        while self.value(expression) != json!(true) {
            if start.elapsed() > PATIENCE {
                let seen = self.value("document.body.innerText");
                panic!("waited in vain for `{expression}`; the page says {seen}");
            }
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// The size and the pixels of the canvas.
    pub fn canvas(&mut self) -> ([u16; 2], Vec<u8>) {
        let value = self.value(
            "(() => {
                const canvas = document.querySelector('#canvas'), { width, height } = canvas;
                const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);
                let text = '';
                for (const byte of data) text += byte.toString(16).padStart(2, '0');
                return [width, height, text];
            })()",
        );
        let side = |index: usize| value[index].as_u64().unwrap() as u16;
        let text = value[2].as_str().unwrap().as_bytes();
        let digit = |digit: u8| (digit as char).to_digit(16).unwrap() as u8;
        let pixels = text.chunks(2).map(|pair| digit(pair[0]) << 4 | digit(pair[1])).collect();
        ([side(0), side(1)], pixels)
    }

    /// Nothing went wrong that the page did not expect.
    pub fn close(mut self) {
        self.value("0");
        assert_eq!(self.exceptions, [""; 0]);
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
