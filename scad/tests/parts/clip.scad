// A clip for three cables on a rail.
$fn = 36;
difference() {
    union() {
        translate([0, -6, 0]) cube([54, 12, 4]);
        for (i = [0:2]) translate([9 + 18 * i, 0, 9]) rotate([90, 0, 0]) cylinder(r = 8, h = 12, center = true);
        translate([0, -6, -6]) cube([3, 12, 7]);
        translate([51, -6, -6]) cube([3, 12, 7]);
        translate([2, -6, -6]) cube([4, 12, 2]);
        translate([48, -6, -6]) cube([4, 12, 2]);
    }
    for (i = [0:2]) translate([9 + 18 * i, 0, 0]) {
        translate([0, 0, 9]) rotate([90, 0, 0]) cylinder(r = 6, h = 13, center = true);
        translate([-4, -7, 10]) cube([8, 14, 10]);
    }
    for (x = [18, 36]) translate([x, 0, -1]) { cylinder(r = 1.6, h = 9); translate([0, 0, 3]) cylinder(r1 = 1.6, r2 = 3.4, h = 2.2); }
}
