//! Lanes: lists of steps, each list beside the others. While a step of one lane waits for an emulator, a link or
//! a browser, another lane has the processor.

use super::Step;
use crate::paths::root;
use std::fs::{self, File};
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

/// After so long without news, a line says what is being done.
const SILENCE: Duration = Duration::from_secs(60);

enum News {
    Begins(&'static str),
    /// The step's output, as an error if it failed.
    Ends(&'static str, Result<String, String>),
}

/// Does the steps of each lane in order, and the lanes beside each other. `work` does a step, and returns its output.
/// After a failure each lane ends with the step that it is at.
pub fn run(
    lanes: &[&'static [Step]],
    work: impl Fn(&Step) -> Result<String, String> + Sync,
) -> Result<(), String> {
    let is_over = AtomicBool::new(false);
    let (sender, news) = channel();
    thread::scope(|scope| {
        for lane in lanes {
            let (sender, is_over, work) = (sender.clone(), &is_over, &work);
            scope.spawn(move || follow(lane, work, is_over, &sender));
        }
        // The last lane that ends closes the channel.
        drop(sender);
        tell(&news)
    })
}

/// Goes along a lane.
fn follow(
    lane: &'static [Step],
    work: impl Fn(&Step) -> Result<String, String>,
    is_over: &AtomicBool,
    news: &Sender<News>,
) {
    for step in lane {
        if is_over.load(Ordering::Relaxed) {
            return;
        }
        // Nobody stops listening before all lanes have ended.
        let _ = news.send(News::Begins(step.name));
        let output = work(step);
        if output.is_err() {
            is_over.store(true, Ordering::Relaxed);
        }
        let _ = news.send(News::Ends(step.name, output));
    }
}

/// Prints each step's output in one piece, when the step ends; meanwhile, what is being done.
fn tell(news: &Receiver<News>) -> Result<(), String> {
    let start = Instant::now();
    let mut running = Vec::new();
    let mut failed = Vec::new();
    loop {
        match news.recv_timeout(SILENCE) {
            Ok(News::Begins(name)) => {
                println!("... {name} begins");
                running.push(name);
            }
            Ok(News::Ends(name, output)) => {
                running.retain(|other| *other != name);
                if output.is_err() {
                    failed.push(name);
                }
                let (Ok(text) | Err(text)) = output;
                println!("\n{}", text.trim());
                if !failed.is_empty() {
                    let rest = running.iter().map(|name| format!("; {name} goes to its end"));
                    println!("=== failed: {}{}", failed.join(", "), rest.collect::<String>());
                }
            }
            Err(RecvTimeoutError::Timeout) => {
                println!("... {:.0} s: {}", start.elapsed().as_secs_f32(), running.join(", "));
            }
            Err(RecvTimeoutError::Disconnected) => break,
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(format!("failed: {}", failed.join(", "))) }
}

/// Does a step in a process of its own. Its output grows in `target/ci`, and is returned at the end.
pub fn apart(program: &Path, step: &Step) -> Result<String, String> {
    let path = root().join("target/ci").join(step.name).with_extension("txt");
    let wrong = |error: io::Error| format!("{}: {error}", path.display());
    fs::create_dir_all(path.parent().unwrap_or(&path)).map_err(wrong)?;
    let file = File::create(&path).map_err(wrong)?;
    let mut command = Command::new(program);
    command.args(["ci", step.name]).stdin(Stdio::null());
    command.stdout(file.try_clone().map_err(wrong)?).stderr(file);
    let status = command.status().map_err(|error| format!("{command:?}: {error}"))?;
    let text = String::from_utf8_lossy(&fs::read(&path).map_err(wrong)?).into_owned();
    if status.success() { Ok(text) } else { Err(format!("{text}{}: {status}", step.name)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::{Barrier, Mutex};

    const fn step(name: &'static str) -> Step {
        Step { name, what: "", run: || Ok(()) }
    }

    static LEFT: [Step; 3] = [step("a"), step("b"), step("c")];
    static RIGHT: [Step; 3] = [step("d"), step("e"), step("f")];

    /// The steps that were done, by name, if some fail; and what came of it. Both lanes reach their second step
    /// before either ends it.
    fn done(failing: &[&str]) -> (Vec<&'static str>, Result<(), String>) {
        let names = Mutex::new(Vec::new());
        let both = Barrier::new(2);
        let result = run(&[&LEFT, &RIGHT], |step| {
            names.lock().unwrap().push(step.name);
            if ["b", "e"].contains(&step.name) {
                both.wait();
            }
            if failing.contains(&step.name) { Err("problem".to_owned()) } else { Ok(String::new()) }
        });
        (names.into_inner().unwrap(), result)
    }

    #[test]
    fn every_step_is_done_and_each_lane_in_order() {
        let (names, result) = done(&[]);
        assert_eq!(result, Ok(()));
        let of = |lane: &str| names.iter().copied().filter(|name| lane.contains(name)).collect();
        let (left, right): (String, String) = (of("abc"), of("def"));
        assert_eq!((left.as_str(), right.as_str()), ("abc", "def"));
    }

    #[test]
    fn a_failure_is_named() {
        for name in ["c", "f"] {
            assert_eq!(done(&[name]).1, Err(format!("failed: {name}")));
        }
    }

    #[test]
    fn after_failures_no_lane_goes_on() {
        let (mut names, result) = done(&["b", "e"]);
        names.sort_unstable();
        assert_eq!(names, ["a", "b", "d", "e"]);
        assert!(result.is_err_and(|text| text.contains('b') && text.contains('e')));
    }
}
