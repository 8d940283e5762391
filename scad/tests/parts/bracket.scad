// A plate with rounded corners and slots, from shapes of the plane, and two ribs.
$fn = 40;
linear_extrude(height = 5) difference() {
    hull() for (x = [0, 50], y = [0, 30]) translate([x, y]) circle(r = 6 - x / 25);
    for (x = [4, 30]) translate([x, 8]) hull() { circle(d = 4.4); translate([0, 14]) circle(d = 4.4); }
    translate([44, 15]) circle(d = 11);
    translate([17, 15]) offset(r = 2) square([6, 14], center = true);
    translate([17, -4]) offset(delta = 1) polygon([[-3, 0], [3, 0], [0, 4]]);
}
for (x = [11, 21]) translate([x, 0, 5]) rotate([90, 0, 90]) linear_extrude(height = 3)
    polygon([[-4, 0], [34, 0], [34, 4], [20, 4], [10, 18], [-4, 18]]);
translate([0, 33, 0]) hull() { translate([13, 0, 0]) cube([10, 3, 14]); translate([18, 3, 20]) rotate([90, 0, 0]) cylinder(r = 5, h = 3); }
