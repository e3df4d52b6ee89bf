# SPDX-License-Identifier: MIT
"""The same 1,000 shots simulated by pooltool and by bankshot: how far apart the balls come to rest, time a shot; CSV.

    PYTHONPATH=build/release/bindings/python python3 tests/bench/pooltool_shots.py

Needs `import pooltool` (0.6, github.com/ekiefl/pooltool); without it this says so and ends with 1. Debian cannot install
it: panda3d, which draws, is in no package, and numba and numpy are older than it asks. results/pooltool.csv was made with
Debian's numba 0.56.4, pooltool's sources, and empty stand-ins for what draws.

One ball on a table of 2.84 m by 1.42 m without pockets, sliding, rolling and spinning, cushions after Han 2005 in both.
pooltool moves the ball 1e-6 m off a cushion at each bounce, so they agree no better than to some 1e-5 m. Its time is that
of `pooltool.simulate`, compiled before and without building the system; ours is all from a dict to the place of rest.
"""
import sys
import time

import numpy as np

import bankshot

try:
    import pooltool as pt
    from pooltool.evolution import SimulationEngine
    from pooltool.physics.resolve import Resolver
    from pooltool.physics.resolve.ball_cushion.han_2005 import Han2005Circular, Han2005Linear
except ImportError as missing:
    sys.exit(f"there is no pooltool to compare with: {missing}")

count, seed, length, width = 1000, 1, 2.84, 1.42
mass, radius, height = 0.21, 0.03075, 0.037
sliding, rolling, spinning, restitution, friction, g = 0.2, 0.01, 4 / 9, 0.85, 0.15, 9.81

scene = {
    "table": {"length": length, "width": width},
    "physics": {
        "model": "spin", "sliding_friction": sliding, "rolling_friction": rolling, "spinning_friction": spinning * radius,
        "g": g, "cushion": {"model": "han2005", "restitution": restitution, "friction": friction, "height": height},
    },
    "ball": {"at": [1.0, 0.5], "radius": radius, "mass": mass},
}


def drawn():
    """Speeds, angles and spins: half of them without side spin."""
    random = np.random.default_rng(seed)
    spins = np.zeros((count, 3))
    spins[:, 0] = random.uniform(-0.5, 1, count)
    spins[::2, 1] = random.uniform(-0.5, 0.5, count // 2)
    return random.uniform(0.5, 5, count), random.uniform(0, 360, count), spins


def of_pooltool(engine, speed, angle, spin):
    table = pt.Table.from_table_specs(pt.objects.BilliardTableSpecs(l=length, w=width, cushion_height=height))
    ball = pt.Ball.create("cue", xy=(width - scene["ball"]["at"][1], scene["ball"]["at"][0]), m=mass, R=radius,
                          u_s=sliding, u_r=rolling, u_sp_proportionality=spinning, e_c=restitution, f_c=friction, g=g)
    # pooltool's tables stand upright, a quarter turn from ours.
    aim = np.radians(angle + 90)
    forward, left = np.array([np.cos(aim), np.sin(aim), 0]), np.array([-np.sin(aim), np.cos(aim), 0])
    ball.state.rvw[1] = speed * forward
    ball.state.rvw[2] = speed / radius * (spin[0] * left + spin[2] * forward + spin[1] * np.array([0, 0, 1]))
    ball.state.s = pt.constants.sliding
    system = pt.System(cue=pt.Cue(cue_ball_id="cue"), table=table, balls={"cue": ball})
    begin = time.process_time()
    pt.simulate(system, engine=engine, inplace=True)
    took = time.process_time() - begin
    x, y, _ = system.balls["cue"].state.rvw[0]
    return took, (y, width - x)


def main():
    resolver = Resolver.default()
    resolver.ball_linear_cushion, resolver.ball_circular_cushion = Han2005Linear(), Han2005Circular()
    engine = SimulationEngine(resolver=resolver)
    speeds, angles, spins = drawn()
    of_pooltool(engine, speeds[0], angles[0], spins[0])  # compiles it
    theirs = [of_pooltool(engine, *each) for each in zip(speeds, angles, spins)]
    begin = time.process_time()
    ours = [bankshot.simulate({**scene, "shot": {"speed": v, "angle": a, "spin": dict(zip(("top", "side", "masse"), s))}}).end["at"]
            for v, a, s in zip(speeds, angles, spins)]
    one_by_one = (time.process_time() - begin) / count
    begin = time.process_time()
    ends = bankshot.simulate_many(scene, speeds, angles, spins, threads=1)
    many = (time.process_time() - begin) / count
    apart = np.hypot(*(np.array(ours) - np.array([at for _, at in theirs])).T)
    np.testing.assert_array_equal(np.array(ours), np.stack([ends["x"], ends["y"]], axis=1))
    print("simulator,shots,us_each,median_apart_m,p99_apart_m,most_apart_m")
    print(f"pooltool {pt.__version__},{count},{1e6 * np.median([t for t, _ in theirs]):.1f},,,")
    print(f"bankshot.simulate,{count},{1e6 * one_by_one:.1f},{np.median(apart):.2g},{np.percentile(apart, 99):.2g},{apart.max():.2g}")
    print(f"bankshot.simulate_many,{count},{1e6 * many:.1f},{np.median(apart):.2g},{np.percentile(apart, 99):.2g},{apart.max():.2g}")


if __name__ == "__main__":
    main()
