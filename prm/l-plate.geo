// The plate of l-plate.prm: 240 x 240 mm without a quarter of 120 x 120 mm.
// gmsh -2 l-plate.geo -o l-plate.msh
a = 0.12;
Point(1) = {0, 0, 0};
Point(2) = {2 * a, 0, 0};
Point(3) = {2 * a, a, 0};
Point(4) = {a, a, 0};
Point(5) = {a, 2 * a, 0};
Point(6) = {0, 2 * a, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1 ... 6};
Plane Surface(1) = {1};
Physical Surface("plate") = {1};
Physical Curve("outer") = {1, 2, 5, 6};
Physical Curve("inner") = {3, 4};
Transfinite Curve {1, 6} = 7;
Transfinite Curve {2, 3, 4, 5} = 4;
Mesh.RecombineAll = 1;
Mesh.Algorithm = 6;
