// What isn't upright: a shear, a mirror, stretched solids, a convex polyhedron, a frustum, a hull of balls.
$fn = 48;
multmatrix([[1, 0.3, 0.2, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) difference() {
    cube([20, 14, 10]);
    translate([10, 7, -1]) cylinder(r = 4, h = 12);
}
translate([40, 8, 6]) scale([1.6, 1, 0.7]) difference() { sphere(r = 8); rotate([20, 0, 0]) cylinder(r = 3, h = 20, center = true); }
mirror([1, 1, 0]) translate([-4, 14, 0]) rotate([0, 25, 10]) { cylinder(r1 = 6, r2 = 2, h = 14); cube([3, 9, 12]); }
translate([-16, -24, 0]) polyhedron(points = [[0, 0, 0], [14, 0, 0], [14, 10, 0], [0, 10, 0], [4, 5, 12], [10, 5, 12]],
    faces = [[0, 1, 2, 3], [1, 0, 4, 5], [2, 1, 5], [3, 2, 5, 4], [0, 3, 4]]);
translate([14, -16, 0]) linear_extrude(height = 12, scale = 0.4) square([16, 10], center = true);
translate([40, -16, 4]) hull() { sphere(r = 4); translate([12, 0, 0]) sphere(r = 4); translate([6, 9, 5]) sphere(r = 4); }
translate([-20, 14, 0]) rotate([0, 0, 33]) scale([1, 0.5, 1]) cylinder(r = 7, h = 9);
