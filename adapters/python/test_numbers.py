"""Numbers as written, against values that binary64 is known to have."""

import json
import unittest

from numbers_as_written import NotANumber, nearest


class Numbers(unittest.TestCase):
    def test_each_notation(self):
        table = [
            (3, 3.0),
            (0.1, 0.1),
            ("3", 3.0),
            ("+3", 3.0),
            ("007", 7.0),
            ("-3/4", -0.75),
            ("-1/3", -0.3333333333333333),
            ("0.5", 0.5),
            (".5", 0.5),
            ("5.", 5.0),
            ("1e-3", 0.001),
            ("25E-2", 0.25),
            ("1e-30", 1e-30),
            ("0x1.8p+1", 3.0),
            ("-0X.8", -0.5),
            ("0xff", 255.0),
            ("0x1p-1074", 5e-324),
            ("1e-999", 0.0),
            ("0e99999999", 0.0),
        ]
        for written, expected in table:
            with self.subTest(written=written):
                self.assertEqual(nearest(written), expected)

    def test_the_nearest_is_taken_once(self):
        # 1 + 2⁻⁵³ is half way, and even is 1; a little more is 1 + 2⁻⁵².
        half_way = f"{2**53 + 1}/{2**53}"
        self.assertEqual(nearest(half_way), 1.0)
        more = f"{(2**53 + 1) * 10**40 + 1}/{2**53 * 10**40}"
        self.assertEqual(nearest(more), 1.0 + 2.0**-52)
        self.assertEqual(nearest(2**53 + 1), 2.0**53)

    def test_long_texts(self):
        self.assertEqual(nearest("1" + "0" * 4500 + "/1" + "0" * 4500), 1.0)

    def test_what_is_no_number(self):
        bad = ["", "+", ".", "1/0", "1/", "/2", "1/-2", "0x", "0xg", "1e", "1e+", "nan", "inf"]
        bad += ["Infinity", " 1", "1 ", "1\n", "1_0", "١", "--1", "1.5/2", "0x1p", "1p3"]
        bad += ["9" * 20000]
        bad += ["1e400", "-1e400", "1e999999999999", "0x1p1024", 10**400, json.loads("1e400")]
        bad += [None, True, [], {}, float("nan")]
        for written in bad:
            with self.subTest(written=repr(written)[:30]), self.assertRaises(NotANumber):
                nearest(written)


if __name__ == "__main__":
    unittest.main()
