//! The Python package: installed as users do it, and received with.

use crate::command::done;
use crate::paths::root;
use std::process::Command;

/// Installs the package into `target/python`, and tests it at the other end of this crate's sender.
pub fn check() -> Result<(), String> {
    let site = root().join("target/python");
    let python = |arguments: &str| {
        let mut command = Command::new("python3");
        command.args(arguments.split(' ')).current_dir(root()).env("PYTHONPATH", &site);
        command
    };
    done(
        python("-m pip install --quiet --upgrade --disable-pip-version-check")
            .args(["--root-user-action=ignore", "./python", "--target"])
            .arg(&site),
    )?;
    done(&mut python("-m unittest discover --start-directory python/tests"))?;
    let test = "test --package scancsg-web --test python -- --include-ignored";
    done(
        Command::new("cargo")
            .args(test.split(' '))
            .current_dir(root())
            .env("SCANCSG_PYTHON", &site),
    )
}
