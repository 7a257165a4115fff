"""Tests that the report of `run` has the numbers of the JSON answers and of the listings."""
import re
import unittest

from cli import SOURCE, Run


class Report(unittest.TestCase):
    def test_the_report_has_the_continuous_peak_to_peak_of_both_flanks(self):
        """Regression: the picture and the row of the non-working flanks had the value at the computed positions."""
        spec = (SOURCE / "examples/loaded_pair.toml").read_text().split("[load]")[0]
        of = lambda text: Run("contact", text, "--json").json["contact"]["continuous_peak_to_peak_arcsec"]
        working, other = of(spec), of(spec + "\n[contact]\ndriver = 2\n")
        run = Run("run", spec, "--only", "report", "--out", "out")
        text = re.sub("<[^>]*>", " ", (run.folder / "out/report.html").read_text())
        row = re.search(r"Transmission error, peak to peak\s+″\s+([0-9.]+)\s+([0-9.]+)", text)
        self.assertEqual(row[1], f"{working:.6f}")
        self.assertAlmostEqual(float(row[2]), other, delta=1e-6)
        self.assertEqual(re.findall(r"peak to peak ([0-9.]+)″", text)[:2], [row[1], row[2]])

    def test_listing_and_report_have_the_correlations_of_a_scatter(self):
        spec = (SOURCE / "examples/scattered_pair.toml").read_text().split("[scatter.groups]")[0]
        spec = spec.replace("indices = true", "").replace("worst_case = true", "").replace("samples = 256", "samples = 16")
        spec += ('[[scatter.correlations]]\nbetween = ["errors.crossing_deg", "errors.intersecting_deg"]\n'
                 "value = 0.25\n")
        self.assertRegex(Run("scatter", spec).out,
                         r"Correlations of the inputs\n +ρ\n +errors.crossing_deg, errors.intersecting_deg +0.25\n")
        run = Run("run", spec, "--only", "report", "--out", "out")
        text = re.sub("<[^>]*>", " ", (run.folder / "out/report.html").read_text())
        self.assertRegex(text, r"Correlations of the inputs[^.]* ρ\s+errors.crossing_deg, errors.intersecting_deg\s+0.25")


if __name__ == "__main__":
    unittest.main()
