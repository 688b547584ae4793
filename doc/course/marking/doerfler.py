"""Doerfler's marking: refine the fewest cells that hold SHARE of the squared error."""
import json
import sys

SHARE = 0.7

with open(sys.argv[1]) as file:
    cells = json.load(file)["cells"]
squares = [cell["error_ratio"] ** 2 for cell in cells]
refine, marked = [], 0
for c in sorted(range(len(cells)), key=lambda c: -squares[c]):
    if marked >= SHARE * sum(squares):
        break
    refine.append(c)
    marked += squares[c]
print(json.dumps({"refine": refine}))
