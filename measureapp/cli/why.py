"""`why`: explanation of holes in a pixel, region or view."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.decode import BloomingOption, NoiseOption, PerFrequencyOption, ResponseOption, RuleOption, decode_settings
from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.pipeline.why import ExplainedView, Number, PixelAnswer, RegionAnswer
    from measureapp.pipeline.why_pictures import Kind, Picture

Decoding = tuple[str, bool, Path | None, Path | None, str]  # rule, per frequency, noise, response, blooming: the options of `decode`
DEFAULT_DECODING: Decoding = ("combined", False, None, None, "0")
STAGES = {
    "decode": "lost in decoding",
    "match": "lost in matching the cameras",
    "clean": "rejected by outlier filters",
}


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def why(
        source: Annotated[Path, typer.Argument(help="Project folder, or MANIFEST.toml of recorded images.")],
        view: Annotated[str | None, typer.Option("--view", help="View of the project.")] = None,
        cameras: Annotated[Path | None, typer.Option("--cameras", help="cameras.json of the cameras that took recorded images.")] = None,
        camera: Annotated[
            str | None, typer.Option("--camera", help="Camera to explain; default: all, or the reference camera for a pixel or region.")
        ] = None,
        pixel: Annotated[str | None, typer.Option("--pixel", help="ROW,COLUMN of the pixel to explain.")] = None,
        region: Annotated[str | None, typer.Option("--region", help="ROW,COLUMN,ROW,COLUMN of a region, its end not included.")] = None,
        maps: Annotated[
            list[str] | None,
            typer.Option("--map", help="OUT.png, or KIND=OUT.png with the kind reasons, exposure or snr; may be given several times."),
        ] = None,
        rule: RuleOption = "combined",
        per_frequency: PerFrequencyOption = False,
        noise: NoiseOption = None,
        response: ResponseOption = None,
        blooming_px: BloomingOption = "0",
        as_json: JsonOption = False,
    ) -> None:
        """Explain a hole: the stage, the reason, the values with their limits, and what to do.

        Without --pixel or --region the fractions of all reasons are listed for every camera; those of a camera sum to 1. The images
        are decoded and reconstructed again; the project is not changed. --map draws every camera, or only --camera.
        Images of a single camera are explained with the projector of --cameras, or without it up to their phase. For recorded
        images give the options they were decoded with.
        """
        from measureapp.errors import InputError

        if pixel is not None and region is not None:
            raise InputError("--pixel and --region exclude each other.", "Give one of them.")
        pictures = dict(_kind_and_file(value) for value in maps or [])
        wanted = _numbers("--pixel", pixel, 2), _numbers("--region", region, 4)
        explained = _explain(source, view, cameras, (rule, per_frequency, noise, response, blooming_px))
        document, lines = _answer(explained, _require_camera(explained, camera), *wanted)
        drawn = {kind: _draw(explained, camera, kind, file) for kind, file in pictures.items()}
        if drawn:
            document["maps"] = {kind: {"file": pictures[kind], "legend": legend} for kind, legend in drawn.items()}
            lines += [f"{kind} → {pictures[kind]}" for kind in drawn]
        reply(document, "\n".join(lines), as_json)


def _kind_and_file(value: str) -> tuple[Kind, Path]:
    """Parse [KIND=]FILE; raises InputError."""
    from measureapp.errors import InputError
    from measureapp.pipeline.why_pictures import KINDS

    kind, equals, file = value.partition("=")
    if not equals:
        kind, file = "reasons", value
    for known in KINDS:
        if known == kind and file.lower().endswith(".png"):
            return known, Path(file)
    raise InputError(f"--map {value} cannot be drawn.", f"Give OUT.png, or KIND=OUT.png with one of the kinds {', '.join(KINDS)}.")


def _numbers(option: str, value: str | None, count: int) -> tuple[int, ...] | None:
    """Parse whole numbers separated by commas; raises InputError."""
    from measureapp.errors import InputError

    if value is None:
        return None
    try:
        numbers = tuple(int(part) for part in value.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != count:
        raise InputError(
            f"{option} {value} is not a {'pixel' if count == 2 else 'region'}.", f"Give {','.join(['ROW,COLUMN'] * (count // 2))}."
        )
    return numbers


def _explain(source: Path, view: str | None, cameras: Path | None, decoding: Decoding) -> ExplainedView:
    """Decode and reconstruct the requested images; raises InputError when the options do not identify them."""
    from measureapp.errors import InputError
    from measureapp.pipeline.why import explain_stack, explain_view
    from measureapp.project.calibration.camera_file import read_cameras
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.fringes.manifest import read_manifest

    if source.is_dir():
        project = ProjectFolder.open(source)
        if cameras is not None or decoding != DEFAULT_DECODING:
            raise InputError("A project is explained with its own settings.", "Omit --cameras and the options of decoding.")
        if view is None:
            stored = project.stored_viewpoints()
            hint = f"Add --view with one of: {', '.join(stored)}." if stored else "Scan the part first: measureapp scan."
            raise InputError(f"--view is missing for the project {source}.", hint)
        return explain_view(project, view, TerminalProgress())
    if view is not None:
        raise InputError(f"{source} is not a project, so it has no view {view!r}.", "Omit --view, or name a project folder.")
    stack = read_manifest(source)
    if cameras is None and len(stack.images) > 1:
        raise InputError(f"Recorded images ({source}) need the calibration of their cameras.", "Add --cameras cameras.json.")
    calibration = None if cameras is None else read_cameras(cameras)
    return explain_stack(stack, calibration, decode_settings(stack, *decoding), TerminalProgress())


def _require_camera(explained: ExplainedView, camera: str | None) -> str | None:
    """Return the camera; raises InputError when the view has no such camera."""
    from measureapp.errors import InputError

    if camera is not None and camera not in explained.cameras:
        raise InputError(f"The view {explained.viewpoint_id} has no camera {camera!r}.", f"Name one of: {', '.join(explained.cameras)}.")
    return camera


def _answer(
    explained: ExplainedView, camera: str | None, pixel: tuple[int, ...] | None, region: tuple[int, ...] | None
) -> tuple[dict[str, Any], list[str]]:
    """Return the document and the lines of the requested explanation."""
    document: dict[str, Any] = {"view": explained.viewpoint_id}
    chosen = camera or explained.cameras[0]
    if pixel is not None:
        answer = explained.pixel(chosen, *pixel)
        return document | {"pixel": _pixel_document(answer)}, _pixel_lines(answer)
    if region is not None:
        top, left, bottom, right = region
        box = explained.region(chosen, (top, left, bottom, right))
        example = None if box.example is None else _pixel_document(box.example)
        return document | {"region": asdict(box) | {"example": example}}, _region_lines(box)
    shares = {name: found for name, found in explained.shares().items() if camera in (None, name)}
    return document | {"cameras": {name: {"shares": found} for name, found in shares.items()}}, _share_lines(shares)


def _pixel_document(answer: PixelAnswer) -> dict[str, Any]:
    return {
        "camera": answer.camera,
        "row": answer.row,
        "column": answer.column,
        **asdict(answer.found),
        "numbers": {number.what: {key: value for key, value in asdict(number).items() if key != "what"} for number in answer.numbers},
    }


def _pixel_lines(answer: PixelAnswer) -> list[str]:
    from measureapp.pipeline.why import NO_HOLES

    found = answer.found
    stage = found.reason if found.reason in NO_HOLES else f"{STAGES[found.stage]}, {found.reason}"
    return [
        f"Camera {answer.camera}, row {answer.row}, column {answer.column}: {stage}.",
        f"  {found.sentence}",
        "  " + "; ".join(_number_words(number) for number in answer.numbers) + ".",
    ]


def _number_words(number: Number) -> str:
    unit = f" {number.unit}" if number.unit else ""
    if number.least is not None:
        return f"{number.what} {number.value:.4g}{unit} (at least {number.least:.4g}{unit})"
    if number.most is not None:
        return f"{number.what} {number.value:.4g}{unit} (at most {number.most:.4g}{unit})"
    return f"{number.what} {number.value:.0f}{unit}" if number.unit == "µs" else f"{number.what} {number.value:.4g}{unit}"


def _region_lines(box: RegionAnswer) -> list[str]:
    top, left, bottom, right = box.box
    lines = [f"Camera {box.camera}, rows {top} to {bottom - 1}, columns {left} to {right - 1}, {box.pixels} pixels:", *_table(box.shares)]
    return lines if box.example is None else [*lines, "The most frequent loss, for example:", *_pixel_lines(box.example)]


def _share_lines(shares: dict[str, dict[str, float]]) -> list[str]:
    return [line for name, found in shares.items() for line in (f"{name}:", *_table(found))]


def _table(shares: Any) -> list[str]:
    from measureapp.pipeline.why_pictures import share_words

    return [f"  {reason:<16} {share_words(share):>9}" for reason, share in shares.items()]


def _draw(explained: ExplainedView, camera: str | None, kind: Kind, file: Path) -> dict[str, Any]:
    """Write the picture; return its legends by camera."""
    from measureapp.pipeline.why_pictures import picture, with_legends, write_picture

    drawn: dict[str, Picture] = {name: picture(explained, name, kind) for name in explained.cameras if camera in (None, name)}
    write_picture(file, with_legends(drawn))
    return {name: [asdict(entry) for entry in one.legend] for name, one in drawn.items()}
