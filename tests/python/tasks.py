"""Random tasks in three forms: numbers for twin.cpp, keywords for kempe.Spec, and the text of a spec's file."""
import random


class Task:
    def __init__(self, number):
        rng = random.Random(number)
        self.scale, self.rotation = rng.uniform(0.4, 2.5), rng.choice([90.0, rng.uniform(30, 150)])
        self.x, self.width = rng.uniform(60, 120), rng.uniform(5, 25)
        self.y, self.height = -0.5 * self.width, self.width
        self.link_width, self.pin = 6.0, rng.uniform(2, 4)
        self.clearance, self.transmission = rng.uniform(0.2, 1), rng.uniform(15, 35)
        self.layers = rng.choice([2, 3])
        self.has_area, self.has_obstacle = rng.random() < 0.15, rng.random() < 0.25
        self.is_steep = rng.random() < 0.2 and not self.has_area

    def line(self):
        numbers = (self.scale, self.rotation, self.x, self.y, self.width, self.height, self.link_width, self.pin,
                   self.clearance, self.transmission, self.layers, self.has_area, self.has_obstacle, self.is_steep)
        return " ".join(repr(number if isinstance(number, float) else int(number)) for number in numbers)

    def keywords(self):
        tables = {"copy": {"scale": self.scale, "rotation_deg": self.rotation},
                  "region": {"rectangle_mm": [self.x, self.y, self.width, self.height]},
                  "links": {"width_mm": self.link_width, "pin_diameter_mm": self.pin, "layers": self.layers},
                  "limits": {"clearance_mm": self.clearance, "transmission_deg": self.transmission}}
        if self.has_area:
            tables["pole"] = {"within_mm": [(-10, -10), (10, -10), (10, 10), (-10, 10)]}
        if self.has_obstacle:
            tables["obstacles"] = [{"name": "vice", "rectangle_mm": {"at": (20, -160), "size": (40, 20)}}]
        if self.is_steep:
            tables["objective"] = "transmission"
        return tables

    def toml(self):
        text = (f"[copy]\nscale = {self.scale!r}\nrotation_deg = {self.rotation!r}\n[region]\n"
                f"rectangle_mm = {{at = [{self.x!r}, {self.y!r}], size = [{self.width!r}, {self.height!r}]}}\n[links]\n"
                f"width_mm = {self.link_width!r}\npin_diameter_mm = {self.pin!r}\nlayers = {self.layers}\n[limits]\n"
                f"clearance_mm = {self.clearance!r}\ntransmission_deg = {self.transmission!r}\n")
        if self.has_area:
            text += "[pole]\nwithin_mm = [[-10, -10], [10, -10], [10, 10], [-10, 10]]\n"
        if self.has_obstacle:
            text += "[[obstacles]]\nname = 'vice'\npolygon_mm = [[20, -160], [60, -160], [60, -140], [20, -140]]\n"
        if self.is_steep:
            text += "[objective]\nmaximize = \"transmission\"\n"
        return text
