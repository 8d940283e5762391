// A funnel with a hook: cones, a revolved wall, part of a ring.
$fn = 56;
rotate_extrude() polygon([[3, 0], [4, 0], [5, 20], [24, 40], [24, 44], [22.6, 44], [22.6, 40.4], [3.8, 20.6]]);
difference() {
    translate([0, 0, 8]) cylinder(r1 = 5, r2 = 9, h = 8);
    translate([0, 0, 7]) cylinder(r1 = 4.05, r2 = 4.6, h = 10);
    for (a = [0:60:300]) rotate([0, 0, a]) translate([8.5, 0, 12]) cylinder(r = 1.6, h = 9, center = true);
}
translate([26, 0, 42]) rotate([90, 0, 0]) rotate_extrude(angle = 250) translate([5, 0]) circle(r = 1.5);
translate([-26, 0, 42]) rotate([90, 0, 180]) rotate_extrude(angle = 100) translate([3, -2]) square([3, 4]);
