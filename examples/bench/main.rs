//! How many instructions the parts take on a board, counted by the emulator: exact, and the same in
//! every run. Of rays made ready and of splines the loop around them is taken off, by counting it around
//! nothing; a call and its return belong to them. On a host everything runs once, so that it stays good;
//! for times there, see `cargo bench --package bench --bench parts` and `--bench render`.

#![cfg_attr(target_os = "none", no_std, no_main)]

mod benign;
#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
mod coding;
mod frames;
mod parts;
mod points;
mod programs;
#[path = "../scene/mod.rs"]
mod scene;

#[cfg(target_os = "none")]
#[board::entry]
fn main() -> ! {
    use board::{Counter, say, say_number};
    if let Some(every) = option_env!("SCANCSG_EVERY").and_then(|every| every.parse().ok()) {
        // For `cargo xtask profile --every`.
        for frame in frames::FRAMES {
            (frame.frame)(every);
        }
        loop {
            board::finish(true);
        }
    }
    let counter = Counter::start();
    let report = |name: [&str; 2], count: u32| {
        name.into_iter().for_each(say);
        say(" ");
        say_number(count);
        say("\n");
    };
    for parts::Part { name, inputs, work, idle } in parts::PARTS {
        // The difference leaves out what is done once.
        let all = |work| {
            let few = counter.instructions(work, 4);
            counter.instructions(work, 4 + inputs).saturating_sub(few)
        };
        report([name, ""], all(*work).saturating_sub(all(*idle)) / inputs);
    }
    for frames::Frame { name, view, row, frame, naive } in frames::FRAMES {
        // Row by row, because the counters of some boards don't reach far enough for a frame.
        let view = counter.instructions(*view, 0);
        let of_row = |y: u16| counter.instructions(*row, y.into()).saturating_sub(view);
        report([name, ": view"], view);
        report([name, ": middle row"], of_row(frames::HEIGHT / 2));
        let once = counter.instructions(*naive, u32::MAX);
        let of_pixel = |x: u16| counter.instructions(*naive, x.into()).saturating_sub(once);
        report([name, ": naive middle row"], (0..frames::WIDTH).map(of_pixel).sum());
        let all = (0..frames::HEIGHT).map(of_row).fold(view, u32::saturating_add);
        let pixels = u32::from(frames::WIDTH) * u32::from(frames::HEIGHT);
        report([name, ": frame, a pixel"], all / pixels);
        // For `cargo xtask profile`.
        frame(0);
    }
    let coded: u32 = (0..coding::PACKETS.into())
        .map(|packet| {
            let rendered = counter.instructions(coding::rendered, packet);
            counter.instructions(coding::coded, packet).saturating_sub(rendered)
        })
        .sum();
    let pixels = u32::from(frames::WIDTH) * u32::from(frames::HEIGHT);
    report(["code a frame by prediction, a pixel", ""], coded / pixels);
    for programs::Built { name, program, view, row, frame } in programs::PROGRAMS {
        let built = counter.instructions(*program, 0);
        let of_view = counter.instructions(*view, 0);
        let of_row = |y: u16| counter.instructions(*row, y.into()).saturating_sub(of_view);
        report([name, ": program"], built);
        report([name, ": view and first row"], of_view.saturating_sub(built) + of_row(0));
        report([name, ": middle row"], of_row(frames::HEIGHT / 2));
        let all = (0..frames::HEIGHT).map(of_row).fold(of_view - built, u32::saturating_add);
        let pixels = u32::from(frames::WIDTH) * u32::from(frames::HEIGHT);
        report([name, ": frame, a pixel"], all / pixels);
        // For `cargo xtask profile`.
        frame(0);
    }
    report(["points", ""], parts::digest());
    loop {
        board::finish(counter.error() <= 1);
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    for part in parts::PARTS {
        (part.work)(part.inputs);
        (part.idle)(part.inputs);
        println!("{} ran", part.name);
    }
    for packet in 0..coding::PACKETS.into() {
        coding::rendered(packet);
        coding::coded(packet);
    }
    println!("code a frame by prediction: ran");
    println!("points {}", parts::digest());
    for frame in frames::FRAMES {
        (frame.view)(0);
        (frame.row)(0);
        (frame.frame)(0);
        (frame.naive)(0);
        println!("{} frame, {} pixels wide: ran", frame.name, frames::WIDTH);
    }
    for built in programs::PROGRAMS {
        (built.program)(0);
        (built.view)(0);
        (built.row)(0);
        (built.frame)(0);
        println!("{}: ran", built.name);
    }
}
