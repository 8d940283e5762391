// A toothed wheel: a polygon that isn't convex with a hole in it, and spokes left between cut-outs.
$fn = 60;
teeth = 15;
points = [for (i = [0:teeth - 1], j = [0:3]) let(a = (i + [0, 0.2, 0.5, 0.7][j]) * 360 / teeth, r = [20, 23, 23, 20][j]) [r * cos(a), r * sin(a)]];
linear_extrude(height = 4, convexity = 4) difference() {
    polygon(points);
    for (i = [0:4]) rotate(72 * i) intersection() {
        difference() { circle(r = 16.5); circle(r = 8); }
        polygon([[0, 0], [30, 14], [30, -14]]);
    }
}
difference() {
    cylinder(r = 8, h = 11);
    translate([0, 0, -1]) cylinder(r = 2.55, h = 13);
    translate([0, 0, 7.5]) rotate([0, 90, 0]) cylinder(r = 1.6, h = 10);
    translate([4, -2.8, 4.5]) cube([2.4, 5.6, 8]);
}
difference() { translate([0, 0, 4]) cylinder(r1 = 19, r2 = 18, h = 1); translate([0, 0, 3]) cylinder(r = 17, h = 3); }
