// Round about one axis: hulls of discs and balls, a rounded disc, shapes of the plane made larger and smaller.
$fn = 48;
difference() {
    union() {
        hull() { cylinder(r = 12, h = 2); translate([0, 0, 6]) cylinder(r = 9, h = 1); }
        hull() { translate([0, 0, 8]) sphere(r = 7); translate([0, 0, 24]) sphere(r = 3); }
        translate([0, 0, 26]) minkowski() { cylinder(r = 6, h = 2); sphere(r = 1.5); }
    }
    translate([0, 0, 4]) cylinder(r = 2, h = 40);
    translate([0, 0, -1]) linear_extrude(height = 3) offset(r = -1) union() { square([16, 6], center = true); square([6, 16], center = true); }
}
translate([22, 0, 0]) linear_extrude(height = 6) difference() {
    offset(r = 3) polygon([[0, 0], [14, 0], [14, 5], [5, 5], [5, 16], [0, 16]]);
    polygon([[0, 0], [14, 0], [14, 5], [5, 5], [5, 16], [0, 16]]);
}
translate([-26, -6, 0]) rotate_extrude(angle = -140) { translate([8, 0]) square([3, 5]); translate([9.5, 5]) circle(r = 1.5); }
