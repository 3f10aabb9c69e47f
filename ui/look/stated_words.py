"""Words that results and files state as they are in documents; the window translates them where it displays them."""

from __future__ import annotations

from ui.look.language.words import later

SAMPLE_PARTS = (later("Gypsum"), later("Impeller"), later("Gear"), later("Sphere plate"), later("Flat"))  # named after their folders
SAMPLE_NAME = "Sample: {name}"
DEMO_NAMES = (
    "Demo: {name}, {resolution} resolution, {count} views, seed {seed}",
    "Demo: {name}, {resolution} resolution, {count} views, seed {seed}, {world} rig",
)
IN_DEMO_NAMES = (
    *(later("impeller"), later("gypsum"), later("gear"), later("sphere_plate")),  # not "flat", which features are named, too
    *(later("full"), later("half"), later("quarter")),
    *(later("good"), later("usual"), later("usable"), later("bad")),
)
SAMPLE_PROGRAMS = (
    "Gypsum cross: a, b, c, d",
    "Impeller: diameters and blades",
    "Impeller: blades",
    "Gear: diameters and boss",
    "Gear: form, orientation, location and run-out",
    "Sphere plate: diameters and centre distances",
    "Flat: flatness of the top",
)
BODIES = (later("part"), later("board"), later("robot"), later("guide"), later("table"))  # of the cell, in sentences about collisions
METHODS = (
    "Joint calibration of the rig",
    "Joint refinement",
    "Weighted least squares",
    "Zhang, then bundle adjustment of all cameras",
    "Zhang, then bundle adjustment of all cameras and of the board's marks",
    "Inverse camera in the bundle adjustment of all cameras",
)
STAGES = (
    "Calibration images",
    later("Calibration"),
    "Scan with storing and clouds",
    later("Clouds"),
    later("Stitching"),
    later("Surroundings"),
    later("Storing"),
    later("Checks"),
    later("Inspection"),
    later("Surface"),
    later("Saving"),
    later("Joining"),
    later("Report"),
    later("Total"),
)
REASONS = (  # of pixels without a phase, or without a point
    *(later("Saturated"), "Weak modulation", later("Shadow"), "Order conflict", "Out of range", later("Edge"), later("Blooming")),
    *(later("Unmatched"), later("Ambiguous"), later("Contradicted"), later("Uncertain"), later("Outlier")),
)
CONTRIBUTIONS = (later("Systematic"), later("Set-ups"), later("Unexplained"), later("Certificate"), later("Edges"))
CHECKS = (later("brightness"), later("time"))  # of the error model, whose other names are several words
NEEDED = ("one feature", "two features", "is not a blade_section", "is a blade_section", "or nothing for no verdict")
DRIVERS = (  # as they name themselves
    "Axes on Modbus: TOYO, IAI, Oriental Motor, SMC",
    "Basler camera (pylon)",
    "Camera of recorded images",
    "GenICam camera (GigE Vision, USB3 Vision)",
    "TI LightCrafter 4500 (DLPC350)",
    "Projector as a second screen",
    "ABB robot (Robot Web Services)",
    "Robot with the MeasureApp line protocol",
    "Rotary tables on a serial line: Newport, OWIS, Sigma-Koki",
    "Virtual rig",
)
FIXED = (later("location"), later("orientation"))  # by datums, in sentences about those that do not
PLACES = (later("position"), later("positions"))  # of board, guide or table, counted in what a calibration still needs
KINDS = (  # of dimensions, as their properties state them; those of tolerance zones stand in their editor
    *(later("Thickness"), "Slot width", "Slot length", later("Chord"), later("Camber"), "Max thickness", "Max thickness place"),
    *("Leading radius", "Trailing radius", later("Stagger"), later("Twist"), later("Pitch"), "Blade form", "Blade profile"),
)
DIRECTIONS = (later("vertical"), later("horizontal"))  # of fringes, in sentences
HOLES = (  # why a place of the surface is not measured
    *("touches the support", "no viewpoint sees it", later("saturated"), "too dark"),
    *("visible, but its pixels have no point", "standard deviation above the required one"),
)
PROPOSALS = ("For {area} mm²: {cause}.", "Other exposures, for {area} mm²: {cause}.")  # of viewpoints, and what they are for
UNITS = (later("millimetres"), later("inches"), later("metres"), later("centimetres"), later("micrometres"))  # of lengths in files
COUNTS = (later("one"), later("two"), later("three"), later("four"), later("five"), later("six"))
LENS = ("Distortion {name}",)  # of a lens, beside those that are several words
LISTED = ("{n} rejected",)  # after the number of points of each feature of a value
ALTERNATIVES = (later(" or "),)  # between the last two of a list
REPORT_TITLE = "Measurement report"  # of the built-in template
TEMPLATE = later("built-in")  # name of the shipped template of reports
SUBJECTS = ("the program", "the alignment", "the alignment {name}", "dimension {name}")  # of refused changes
