"""Creatures at every limit of their format: any genes give a verdict within a short time."""

import itertools
import json
import math
import unittest

from program import ProgramTest

CONSTANT = {"kind": "const"}
VERDICTS = ["completed", "rejected", "diverged", "cheated", "over-budget"]
NODES, EDGES, NEURONS = 16, 6, 8
SIZES = {"smallest": (0.08, 0.08), "longest": (1.6, 0.96), "needles": (1.6, 0.08),
         "slabs": (0.08, 0.96)}


def source(kind, number):
    """Returns a reference of that kind with the largest indices."""
    fields = {"const": {}, "localNeuron": {"k": 15}, "localSensor": {"ch": 255},
              "parentNeuron": {"k": 15}, "parentSensor": {"ch": 255},
              "childNeuron": {"e": 15, "k": 15}, "childSensor": {"e": 15, "ch": 255},
              "brainNeuron": {"k": number % 16}}
    return {"kind": kind, **fields[kind]}


def neuron(function, inputs, number):
    kinds = ["localNeuron", "childNeuron", "parentNeuron", "brainNeuron", "localSensor",
             "childSensor", "parentSensor"]
    return {"fn": function, "in": [{"from": source(kinds[(number + i) % len(kinds)], number),
                                    "w": 4.0 if (number + i) % 2 else -4.0}
                                   for i in range(inputs)]}


def edge(number, targets):
    return {"target": targets(number), "pos": number * 0.61803398875 % 1.0,
            "angle": 1.4 if number % 2 else -1.4, "scale": 1.5 if number % 3 else 0.4,
            "reflect": number % 2 == 0, "terminalOnly": number % 5 == 0}


def creature(functions, size, joint, targets):
    """Returns the largest creature: most nodes, edges, neurons and recursion, all mirrored."""
    length, width = SIZES[size]
    names = itertools.cycle(functions.items())
    nodes = []
    for node in range(NODES):
        neurons = [neuron(*next(names), node * NEURONS + i) for i in range(NEURONS)]
        nodes.append({
            "length": length, "width": width, "joint": joint, "limits": [-2.6, 2.6],
            "recursionLimit": 6, "symmetric": True,
            "mirrorAxis": "along" if node % 2 else "across",
            "effector": {"source": {"kind": "localNeuron", "k": node % NEURONS},
                         "weight": 4.0 if node % 2 else -4.0},
            "neurons": neurons,
            "edges": [edge(node * EDGES + i, targets) for i in range(EDGES)]})
    brain = []
    return {"format": "cambrian-creature", "version": 1, "nodes": nodes, "brain": brain}


# The targets of a creature's edges.
GRAPHS = {"everything to itself": lambda number: number // EDGES,
          "a ring": lambda number: (number // EDGES + 1) % NODES,
          "everything to everything": lambda number: number * 7 % NODES}


class HostileCreatures(ProgramTest):
    def setUp(self):
        super().setUp()
        schema = json.loads(self.run_well("schema").stdout)["$defs"]
        self.functions = {}
        for rules in schema["partNeuron"]["oneOf"]:
            for function in rules["properties"]["fn"]["enum"]:
                self.functions[function] = rules["properties"]["in"]["minItems"]
        self.joints = schema["node"]["properties"]["joint"]["enum"]

    def judge(self, document, *arguments):
        """Returns the report of a creature's trial, which must end within a limit of work."""
        self.write("a.creature.json", json.dumps(document))
        report = json.loads(self.run_well("simulate", "a.creature.json", "--json",
                                          *arguments).stdout)
        self.assertIn(report["outcome"], VERDICTS)
        self.assertTrue(math.isfinite(report["fitness"]))
        self.assertLessEqual(report["parts"], 32)
        return report

    def test_the_largest_genomes_come_to_a_verdict(self):
        for graph, targets in GRAPHS.items():
            for size in SIZES:
                with self.subTest(graph=graph, size=size):
                    self.judge(creature(self.functions, size, "rotary", targets),
                               "--seconds", 2)

    def test_every_joint_and_function_at_its_extremes_comes_to_a_verdict(self):
        for joint in self.joints:
            self.judge(creature(self.functions, "needles", joint, GRAPHS["a ring"]),
                       "--seconds", 2)
        for function, inputs in self.functions.items():
            self.judge(creature({function: inputs}, "smallest", "rotary", GRAPHS["a ring"]),
                       "--seconds", 1)

    def test_a_world_at_its_extremes_does_not_let_a_hostile_creature_run_away(self):
        self.write("hard.toml", "[environment]\ngravity = 1000\nfriction = 100\nelasticity = 1\n"
                                "viscosity-linear = 10000\ndensity = 0.001\n"
                                "[simulation]\ntolerance = 1e-8\ncontact-step = 1e-4\n"
                                "muscle-strength = 10000\nmotor-frequency = 200\n"
                                "[body]\nmax-parts = 32\nmax-depth = 32\nmax-neurons = 4096\n"
                                "[trial]\nduration = 1\n")
        for targets in GRAPHS.values():
            self.judge(creature(self.functions, "longest", "rotary", targets),
                       "--environment", "hard.toml")


if __name__ == "__main__":
    unittest.main(verbosity=2)
