// A die: a cube that balls and cylinders round off, with drilled pips; that of the one is a ball's.
$fn = 50;
s = 9;
module pips(list) for (p = list) translate([p[0] * 5, p[1] * 5, s - 0.8]) cylinder(r1 = 1.2, r2 = 2, h = 2);
difference() {
    intersection() {
        cube(2 * s, center = true);
        sphere(r = 1.42 * s);
        union() {
            cylinder(r = 1.32 * s, h = 40, center = true);
            rotate([90, 0, 0]) cylinder(r = 1.2 * s, h = 40, center = true);
        }
    }
    translate([0, 0, s + 1.2]) sphere(r = 2.5);
    rotate([180, 0, 0]) pips([[-1, -1], [-1, 0], [-1, 1], [1, -1], [1, 0], [1, 1]]);
    rotate([90, 0, 0]) pips([[-1, -1], [1, 1]]);
    rotate([-90, 0, 0]) pips([[-1, -1], [-1, 1], [0, 0], [1, -1], [1, 1]]);
    rotate([0, 90, 0]) pips([[-1, -1], [0, 0], [1, 1]]);
    rotate([0, -90, 0]) pips([[-1, -1], [-1, 1], [1, -1], [1, 1]]);
}
