// A corner that joins three square tubes, with screw holes, and its edges cut at 45 degrees.
$fn = 40;
module tube(axis) rotate(axis) difference() {
    translate([-10, -10, 0]) cube([20, 20, 50]);
    translate([-7.5, -7.5, 14]) cube([15, 15, 37]);
    for (z = [22, 40]) {
        translate([0, 0, z]) rotate([90, 0, 0]) cylinder(d = 3.2, h = 30, center = true);
        translate([0, 0, z + 4]) rotate([0, 90, 0]) cylinder(d = 3.2, h = 30, center = true);
    }
}
difference() {
    union() {
        tube([0, 0, 0]);
        tube([90, 0, 0]);
        tube([0, 90, 0]);
        translate([-10, -10, -10]) cube(20);
    }
    translate([-10, 0, -10]) rotate([0, 45, 0]) cube([6, 200, 6], center = true);
    translate([10, 10, 0]) rotate([0, 0, 45]) cube([5, 5, 300], center = true);
}
