// The plate of drilled-plate.prm: 200 x 150 mm with a hole of 40 mm diameter.
// gmsh -2 drilled-plate.geo -o drilled-plate.msh
SetFactory("OpenCASCADE");
Rectangle(1) = {-0.1, -0.075, 0, 0.2, 0.15};
Disk(2) = {0.04, 0.015, 0, 0.02};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
around[] = Boundary { Surface{3}; };
hole[] = Curve In BoundingBox {0.01, -0.01, -1, 0.07, 0.04, 1};
around[] -= hole[];
Physical Surface("plate") = {3};
Physical Curve("rim") = {around[]};
Physical Curve("hole") = {hole[]};
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = 3; // quadrilaterals alone
Mesh.MeshSizeMax = 0.025;
Mesh.MeshSizeMin = 0.025;
Mesh.MeshSizeFromCurvature = 12;
