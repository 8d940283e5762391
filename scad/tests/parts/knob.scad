// A knob: a revolved profile, a ring of grooves, a flattened bore.
$fn = 64;
difference() {
    rotate_extrude() polygon([[0, 0], [14, 0], [15, 1], [15, 9], [12, 12], [9, 16], [9, 20], [7, 22], [0, 22]]);
    for (i = [0:11]) rotate([0, 0, 30 * i]) translate([15.6, 0, -1]) cylinder(r = 1.5, h = 11.5);
    difference() {
        translate([0, 0, -1]) cylinder(r = 3.1, h = 15);
        translate([1.6, -5, -2]) cube([5, 10, 20]);
    }
    rotate([90, 0, 20]) translate([0, 5, 0]) cylinder(r = 1.4, h = 20);
    translate([0, 0, 21.2]) rotate_extrude() translate([4.5, 0]) circle(r = 1);
    translate([-0.6, -16, 12]) cube([1.2, 32, 11]);
}
