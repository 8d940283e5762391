// An x-end of a printer: a bearing tower, a nut trap for the screw, two rods that are clamped at a slant.
$fn = 48;
module rod(y) translate([-1, y, 0]) rotate([0, 90, 0]) cylinder(r = 4.1, h = 62);
difference() {
    union() {
        cube([17, 39, 58]);
        translate([0, -14, 0]) cube([28, 26, 8]);
        translate([17, 6, 0]) cube([42, 20, 18]);
        translate([22, 16, 58]) rotate([0, 0, 30]) translate([-8, -4, -6]) cube([16, 8, 6]);
        translate([8, -6, 8]) cylinder(r1 = 11, r2 = 8, h = 10);
    }
    translate([8.5, 19.5, -1]) cylinder(r = 7.6, h = 60);
    translate([8, -6, -1]) cylinder(r = 4.2, h = 30);
    translate([8, -6, 3]) cylinder(r = 7.2, h = 16, $fn = 6);
    for (z = [0, 30]) translate([0, 0, z + 9]) rod(10 + z / 3);
    translate([-1, 18, 10]) cube([19, 3, 60]);
    for (z = [12, 46]) translate([8, 50, z]) rotate([90, 0, 0]) { cylinder(r = 1.7, h = 60); cylinder(r1 = 3.5, r2 = 1.7, h = 14); }
    translate([59, 16, 9]) rotate([0, 45, 0]) cube([6, 30, 6], center = true);
}
