//! Scenes: programs in the caller's memory.

use crate::border::{self, Kept};
use crate::capacity::{PART_WORDS, PARTS, POSES};
use crate::part::Program;
use crate::status::Status;
use crate::table::{self, Motion, Step};

/// The memory of a scene: a variable of this type, or an allocation of its size, is all that a scene needs.
/// Its contents are the library's own. It may be moved while no picture of it is
/// used.
#[repr(C)]
pub struct Scene {
    words: [u64; SCENE_WORDS],
}

/// The size of a scene, in words of eight bytes. It is another one for other options, so that a header that
/// doesn't fit the library is found out.
pub const SCENE_WORDS: usize = PARTS * 8 + POSES * 6 + PART_WORDS;

/// What is in a scene's memory.
#[repr(C)]
pub(crate) struct KeptScene {
    mark: u32,
    /// How often it was changed since it was built.
    pub(crate) edits: u32,
    pub(crate) program: Program,
}

// SAFETY: the mark is the first field, and always `MARK`; a program owns nothing. `place` compares sizes.
unsafe impl Kept for KeptScene {
    type Storage = Scene;
    const MARK: u32 = 0x5363_4E01;
}

impl KeptScene {
    fn new(program: Program) -> Self {
        Self { mark: Self::MARK, edits: 0, program }
    }
}

/// Builds a scene from a table. `size` is `sizeof *scene`. The memory of a scene need not be set before.
/// Pictures of what was built there before must be made again, too: rows of old ones are wrong, without a code.
///
/// `poses` are what `pose` of a step counts. They may be null if there are none. Operands that nothing combines
/// are united.
///
/// Unless the status is `SCANCSG_STATUS_OK`, the scene isn't built. The index of the step that failed is then in
/// `failed`, if that isn't null: 0 if it was none of them.
///
/// # Safety
/// `scene` has `size` bytes, `steps` and `poses` as many elements as their counts say.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_scene_from_table(
    scene: *mut Scene,
    size: usize,
    steps: *const Step,
    step_count: usize,
    poses: *const Motion,
    pose_count: usize,
    failed: *mut usize,
) -> Status {
    let mut at = 0;
    let mut build = || {
        let place = border::place::<KeptScene>(scene, size)?;
        // SAFETY: the caller has lent the scene, and says how many steps and poses there are.
        let (steps, poses) = unsafe {
            border::clear(place);
            (border::slice(steps, step_count)?, border::slice(poses, pose_count)?)
        };
        let program = table::begin(steps, poses)?;
        // SAFETY: the place is aligned and large enough.
        unsafe { place.write(KeptScene::new(program)) };
        // SAFETY: it was written just now, and the caller has lent it.
        let kept = unsafe { &mut *place };
        for step in steps.iter().skip(1) {
            at += 1;
            if let Err(status) = table::go_on(&mut kept.program, step) {
                // SAFETY: as above; nobody uses the scene any more.
                unsafe { border::clear(place) };
                return Err(status);
            }
        }
        Ok(())
    };
    let status = Status::of(build());
    if status != Status::Ok && !failed.is_null() {
        // SAFETY: the caller has lent it.
        return unsafe { border::write(failed, at) }.err().unwrap_or(status);
    }
    status
}

/// Builds a scene from the bytes of a program: the repository's `docs/program.md` has their format. `size` is
/// `sizeof *scene`.
/// Pictures of what was built there before must be made again, too: rows of old ones are wrong, without a code.
///
/// Unless the status is `SCANCSG_STATUS_OK`, the scene isn't built.
///
/// # Safety
/// `scene` has `size` bytes, `bytes` has `length`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_scene_from_bytes(
    scene: *mut Scene,
    size: usize,
    bytes: *const u8,
    length: usize,
) -> Status {
    let build = || {
        let place = border::place::<KeptScene>(scene, size)?;
        // SAFETY: the caller has lent the scene, and says how many bytes there are.
        let bytes = unsafe {
            border::clear(place);
            border::slice(bytes, length)?
        };
        let program = Program::from_bytes(bytes)?;
        // SAFETY: the place is aligned and large enough.
        unsafe { place.write(KeptScene::new(program)) };
        Ok(())
    };
    Status::of(build())
}

/// Writes a scene as the bytes of a program, and how many they are to `length`.
///
/// # Safety
/// `scene` is a scene's memory, `bytes` has `capacity` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_scene_to_bytes(
    scene: *const Scene,
    bytes: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> Status {
    let save = || {
        // SAFETY: the caller has lent all of them.
        let (scene, bytes) =
            unsafe { (border::kept::<KeptScene>(scene)?, border::room(bytes, capacity)?) };
        let written = scene.program.to_bytes(bytes).map_err(|_| Status::Length)?.len();
        // SAFETY: as above.
        unsafe { border::write(length, written) }
    };
    Status::of(save())
}

/// Moves all parts that stand in a pose. Pictures of the scene must be made again.
///
/// # Safety
/// `scene` is a scene's memory, `motion` points to one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_scene_move(
    scene: *mut Scene,
    pose: u8,
    motion: *const Motion,
) -> Status {
    let turn = || {
        // SAFETY: the caller has lent both.
        let (motion, scene) =
            unsafe { (border::read(motion)?, border::kept_mut::<KeptScene>(scene)?) };
        scene.program.set_pose(pose.into(), motion.pose()?)?;
        scene.edits = scene.edits.wrapping_add(1);
        Ok(())
    };
    Status::of(turn())
}
