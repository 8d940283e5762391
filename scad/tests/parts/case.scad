// A case: rounded boxes, a lid's rim, feet, a grid of holes.
$fn = 32;
difference() {
    translate([3, 3, 3]) minkowski() { cube([54, 34, 24]); sphere(r = 3); }
    translate([5, 5, 3]) minkowski() { cube([50, 30, 40]); cylinder(r = 2, h = 1); }
    translate([-1, -1, 24]) cube([80, 60, 20]);
    for (x = [12:6:48], y = [12:8:28]) translate([x, y, -1]) cylinder(r = 1.4, h = 8);
    translate([-1, 12, 8]) cube([6, 12, 7]);
    translate([56, 14, 12]) rotate([0, 90, 0]) hull() { cylinder(r = 3, h = 10); translate([0, 10, 0]) cylinder(r = 3, h = 10); }
}
for (x = [8, 52], y = [8, 32]) translate([x, y, 2]) difference() { cylinder(r = 3.5, h = 12); translate([0, 0, 4]) cylinder(r = 1.3, h = 12); }
