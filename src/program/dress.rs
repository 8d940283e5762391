//! Colours and poses of a program's parts.

use super::build::{NO_POSE, Place, Program, ProgramError};
use crate::geom::Pose;
use crate::solid::Rgb;
use crate::span::Shape;

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
{
    /// Gives a part a colour, or takes it away. Faces of a part that have one of their own keep that.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::program::Program;
    /// use scancsg::solid::{Rgb, Solid, Sphere};
    /// use scancsg::span::Face;
    ///
    /// let mut red = Program::<_, 1>::new(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?);
    /// red.paint(0, Some(Rgb::new(255, 0, 0)))?;
    /// assert_eq!(red.color(Face(0)), Some(Rgb::new(255, 0, 0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ProgramError::NoPart`].
    pub const fn paint(&mut self, part: usize, color: Option<Rgb>) -> Result<(), ProgramError> {
        if let Err(error) = self.check(part) {
            return Err(error);
        }
        let place = &mut self.places[part];
        match color {
            Some(color) => (place.color, place.is) = (color, place.is | Place::PAINTED),
            None => place.is &= !Place::PAINTED,
        }
        Ok(())
    }

    /// Adds a frame that parts can stand in, and returns its index.
    ///
    /// # Errors
    /// [`ProgramError::Poses`].
    pub const fn add_pose(&mut self, pose: Pose<L::Scalar>) -> Result<usize, ProgramError> {
        let index = self.pose_count as usize;
        if index >= POSES {
            return Err(ProgramError::Poses);
        }
        self.poses[index] = pose;
        self.pose_count += 1;
        Ok(index)
    }

    /// Moves a frame, and all parts that stand in it.
    ///
    /// ```
    /// use scancsg::geom::{Pose, Ray, vec3};
    /// use scancsg::program::Program;
    /// use scancsg::solid::Sphere;
    /// use scancsg::span::SpanList;
    ///
    /// let ball = |x| Sphere::<f32>::new(vec3(x, 0.0, 0.0), 1.0);
    /// let mut arm = Program::<_, 2, 1>::new(ball(0.0)?);
    /// let hand = arm.push(ball(3.0)?)?;
    /// let elbow = arm.add_pose(Pose::IDENTITY)?;
    /// arm.place(hand, Some(elbow))?;
    /// arm.set_pose(elbow, Pose::<f32>::translation(vec3(2.0, 0.0, 0.0))?)?;
    ///
    /// let ray = Ray::new(vec3(9.0, 0.0, 0.0), vec3(-1.0, 0.0, 0.0))?;
    /// let hit = arm.hit(&ray, &mut SpanList::<_, 32>::new())?.ok_or("a miss")?;
    /// assert_eq!((hit.t, hit.face.0), (3.0, 1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ProgramError::NoPose`].
    pub const fn set_pose(&mut self, pose: usize, to: Pose<L::Scalar>) -> Result<(), ProgramError> {
        if pose >= self.pose_count as usize || pose >= POSES {
            return Err(ProgramError::NoPose);
        }
        self.poses[pose] = to;
        Ok(())
    }

    /// Puts a part into a frame, or back into the scene's.
    ///
    /// # Errors
    /// [`ProgramError::NoPart`], [`ProgramError::NoPose`].
    pub const fn place(&mut self, part: usize, pose: Option<usize>) -> Result<(), ProgramError> {
        if let Err(error) = self.check(part) {
            return Err(error);
        }
        self.places[part].pose = match pose {
            Some(pose) if pose >= self.pose_count as usize => return Err(ProgramError::NoPose),
            Some(pose) => pose as u8,
            None => NO_POSE,
        };
        Ok(())
    }
}
