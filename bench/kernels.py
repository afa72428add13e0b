"""The kernels, one by one."""
from measure import Row, google_benchmarks, shown


def rows(context):
    seconds, rounds = (0.1, 2) if context.quick else (0.5, 5)
    times = google_benchmarks(context.program("kernels"), "^(pose$|pose_batch/10000$|newton|general|contact|load|map|search)", seconds,
                              rounds)
    batch = times["pose_batch/10000"] / 10000
    yield Row("closed-form pose of all joints, in columns", "plagiograph, 10^4 poses", shown(batch), "", "", "50 ns", batch < 50e-9)
    yield Row("closed-form pose, one by one", "plagiograph", shown(times["pose"] / 1000))
    general = times["general_solver_pose/plagiograph"]
    yield Row("general solver, certified step and Newton to rounding", "plagiograph, a degree a pose", shown(general), "", "",
              "20 us", general < 20e-6)
    for name in ("plagiograph", "peaucellier"):
        yield Row("Newton step: residual, Jacobian, solution", name, shown(times[f"newton_step/{name}"]))
    yield Row("contact-free openings of all parts", "plagiograph, 2 layers", shown(times["contact_interval"]))
    load = times["load_error"]
    yield Row("load error over a region, worst and least", "plagiograph", shown(load), "", "", "20 us", load < 20e-6)
    yield Row("map", "no obstacle", shown(times["map/0"]))
    target = times["map/50"]
    yield Row("map", "50 obstacles of 20 corners", shown(target), "", "", "2 s", target < 2)
    yield Row("search (without map and files)", "plagiograph, pole fixed", shown(times["search/plagiograph"]))
    yield Row("search (without map and files)", "nameplate, pole free", shown(times["search/nameplate"]))
    plain, loaded = times["search/nameplate"], times["search_with_load"]
    yield Row("search with a limit on the load error", "nameplate, pole free", shown(loaded), "search without", f"{loaded / plain:.2f}", "1.5",
              loaded < 1.5 * plain)
