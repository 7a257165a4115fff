"""Tests the listing of `contact`: errors in the words of the catalogue, and values with their units."""
import unittest

from cli import PAIR, Run


class ContactListing(unittest.TestCase):
    def test_the_listing_has_words_and_units(self):
        rest = ('[errors]\ncrossing_deg = 0.02\naxial_mm = 0.5\nhelix_slope1_um = 4\n[contact]\npositions = 8\n[contact.map]\n'
                'x = "crossing_deg"\nx_range = [-0.05, 0.05]\ny = "center_distance_mm"\ny_range = [0, 0.2]\npoints = [3, 3]')
        out = Run("contact", PAIR + rest).out
        self.assertRegex(out, r"  Error, out-of-plane shaft deviation  +0\.02°, which is ")
        self.assertRegex(out, r"  Error, axial position of gear 1  +0\.5 mm\n")
        self.assertRegex(out, r"  Error, helix slope of gear 1  +4(\.0)? µm\n")
        self.assertRegex(out, r"  Harmonics 1 to 5, amplitudes  +[0-9., ]+ ″\n")
        self.assertRegex(out, r"  Peak to peak over the map of errors  +[0-9.]+ to [0-9.]+ ″\n")
        for word in ("_deg", "_mm", "_um", "arcsec"):
            self.assertNotIn(word, out.split("Verdict")[0])


if __name__ == "__main__":
    unittest.main()
