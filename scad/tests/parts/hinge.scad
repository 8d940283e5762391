// A hinge with nut traps, coloured leaves, and nodes that are no operands.
$fn = 30;
module leaf(n) {
    difference() {
        union() {
            translate([4, 0, 0]) cube([24, 40, 4]);
            for (y = [n * 8:16:39]) translate([0, y, 4]) rotate([-90, 0, 0]) cylinder(r = 4, h = 7.6);
            for (y = [n * 8:16:39]) translate([0, y, 0]) cube([8, 7.6, 4]);
        }
        translate([0, -1, 4]) rotate([-90, 0, 0]) cylinder(r = 1.6, h = 42);
        for (y = [8, 32]) translate([19, y, -1]) { cylinder(r = 1.7, h = 6); translate([0, 0, 3]) cylinder(r = 3.3, h = 3, $fn = 6); }
        for (y = [(1 - n) * 8:16:39]) translate([-5, y - 0.2, -1]) cube([9.5, 8, 10]);
    }
}
color("red") leaf(0);
color([0.2, 0.4, 1]) mirror([1, 0, 0]) leaf(1);
%translate([0, 0, 30]) cube(50);
*sphere(r = 90);
color("green") translate([0, -2, 4]) rotate([-90, 0, 0]) { cylinder(r = 1.4, h = 44); cylinder(r = 3, h = 2, $fn = 8); }
