"""Calibrated cameras in files: those of OpenCV, Bouguet's toolbox, Kalibr, and plain JSON.

All forms count pixels from (0, 0), the middle of the first pixel, as the course does. (MATLAB's own
`cameraParameters`, unlike Bouguet's files, counts from 1.)
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_intrinsics, check_size
from course_lib.distortion.forms import bouguet_from_opencv, opencv_from_bouguet
from course_lib.distortion.model import check_coefficients

#: Names of the forms, and the ending of a file by default.
FORMS = {"opencv": ".yml", "matlab": ".m", "kalibr": ".yaml", "json": ".json"}


@dataclass(frozen=True, eq=False)
class StoredCamera:
    """What all forms have in common.

    Attributes
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    coefficients : ndarray
        Distortion as in `course_lib.distortion.distort`.
    image_size : tuple of int
        Width and height, px.
    rms : float
        Root mean square of the reprojection error, px; NaN if it is not known.
    sigma : dict of str to float
        Standard deviations of numbers of the camera, by their names, as far as they are known.

    Raises
    ------
    TypeError, ValueError
        If the numbers are not those of a camera.
    """

    K: Array
    coefficients: Array
    image_size: tuple[int, int]
    rms: float = float("nan")
    sigma: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "K", check_intrinsics(self.K))
        check_coefficients(self.coefficients)
        object.__setattr__(self, "coefficients", np.array(self.coefficients, float))
        width, height = check_size(self.image_size, "image_size")
        object.__setattr__(self, "image_size", (int(width), int(height)))


def write_camera(path: str | Path, camera: StoredCamera, form: str = "") -> Path:
    """Write a camera to a file.

    Parameters
    ----------
    path : str or Path
        The file; it is overwritten.
    camera : StoredCamera
        The camera.
    form : str
        ``"opencv"``, ``"matlab"``, ``"kalibr"`` or ``"json"``; by the ending unless given: .yml,
        .m, .yaml or .json.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ValueError
        If there is no such form, or it cannot hold this camera; the message says why.
    OSError
        If the file cannot be written.
    """
    path = Path(path)
    endings = {ending: name for name, ending in FORMS.items()}
    form = form or endings.get(path.suffix.lower(), "")
    if form not in FORMS:
        raise ValueError(f"form must be one of {', '.join(FORMS)}, got {form or path.name!r}")
    text = _WRITERS[form](camera)
    path.write_text(text, encoding="utf-8")
    return path


def read_camera(path: str | Path) -> StoredCamera:
    """Return the camera in a file, whichever of the forms it has.

    Parameters
    ----------
    path : str or Path
        The file. Of several cameras of Kalibr's, the first is read.

    Returns
    -------
    StoredCamera
        The camera.

    Raises
    ------
    ValueError
        If the file has none of the forms, or something is missing in it.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise ValueError(f"{path.name} is no text: {_WANTED}") from error
    try:
        return _reader(path, text)(text)
    except KeyError as error:
        raise ValueError(f"{path.name} has no {error.args[0]}: {_WANTED}") from error


_WANTED = "a calibration of OpenCV, Bouguet's toolbox, Kalibr or of this course is wanted"


def _reader(path: Path, text: str) -> Callable[[str], StoredCamera]:
    """Return the function that reads this text."""
    if text.startswith("%YAML") and "camera_matrix" in text:
        return _from_opencv
    if path.suffix.lower() == ".m" or re.search(r"(?m)^fc\s*=", text):
        return _from_matlab
    if re.search(r"(?m)^cam\d+\s*:", text):
        return _from_kalibr
    if text.lstrip().startswith("{"):
        return _from_json
    raise ValueError(f"{path.name} has none of the known forms: {_WANTED}")


def _to_opencv(camera: StoredCamera) -> str:
    import cv2

    file = cv2.FileStorage(".yml", cv2.FILE_STORAGE_WRITE | cv2.FILE_STORAGE_MEMORY)
    file.write("image_width", camera.image_size[0])
    file.write("image_height", camera.image_size[1])
    file.write("camera_matrix", camera.K)
    file.write("distortion_coefficients", camera.coefficients[:, None])
    if np.isfinite(camera.rms):
        file.write("avg_reprojection_error", float(camera.rms))
    for name, sigma in camera.sigma.items():
        file.write(f"sigma_{name}", float(sigma))
    return str(file.releaseAndGetString())


def _from_opencv(text: str) -> StoredCamera:
    import cv2

    file = cv2.FileStorage(text, cv2.FILE_STORAGE_READ | cv2.FILE_STORAGE_MEMORY)

    def get(name: str) -> Any:
        node = file.getNode(name)
        if node.empty():
            raise KeyError(name)
        return node.mat() if node.isMap() else node.real()

    K, k = get("camera_matrix"), np.ravel(get("distortion_coefficients"))
    size = int(get("image_width")), int(get("image_height"))
    rms = get("avg_reprojection_error") if "avg_reprojection_error" in text else float("nan")
    names = re.findall(r"(?m)^sigma_(\w+):", text)
    return StoredCamera(K, k, size, rms, {name: get(f"sigma_{name}") for name in names})


def _row(values: ArrayLike) -> str:
    return "[ " + " ; ".join(f"{value:.15g}" for value in np.ravel(values)) + " ]"


def _to_matlab(camera: StoredCamera) -> str:
    fc, cc, alpha_c, kc = bouguet_from_opencv(camera.K, camera.coefficients)
    sigma = {name: 3 * value for name, value in camera.sigma.items()}  # the toolbox gives three
    errors = [[sigma.get(name, 0.0) for name in names.split()] for names in ("fx fy", "cx cy")]
    kc_error = [sigma.get(name, 0.0) for name in ["k1", "k2", "p1", "p2", "k3"]]
    lines = [
        "% Camera in the form of the Camera Calibration Toolbox for MATLAB (J.-Y. Bouguet).",
        "% Pixels are counted from (0, 0); uncertainties are three standard deviations.",
        f"fc = {_row(fc)};",
        f"cc = {_row(cc)};",
        f"alpha_c = {alpha_c:.15g};",
        f"kc = {_row(kc)};",
        f"fc_error = {_row(errors[0])};",
        f"cc_error = {_row(errors[1])};",
        f"kc_error = {_row(kc_error)};",
        f"nx = {camera.image_size[0]};",
        f"ny = {camera.image_size[1]};",
    ]
    return "\n".join(lines) + "\n"


def _from_matlab(text: str) -> StoredCamera:
    found = re.findall(r"(?m)^\s*(\w+)\s*=\s*\[?([^\];]*(?:;[^\]=;]*)*)\]?\s*;", text)
    values = {name: np.array(re.findall(r"[-+.\deE]+", row), float) for name, row in found}
    size = int(values["nx"][0]), int(values["ny"][0])
    alpha_c = float(values["alpha_c"][0]) if "alpha_c" in values else 0.0
    K, k = opencv_from_bouguet(values["fc"], values["cc"], alpha_c, values["kc"])
    sigma: dict[str, float] = {}
    named = {"fc_error": "fx fy", "cc_error": "cx cy", "kc_error": "k1 k2 p1 p2 k3"}
    for entry, names in named.items():
        given = zip(names.split(), values.get(entry, np.empty(0)) / 3, strict=False)
        sigma |= {name: float(value) for name, value in given if value}
    return StoredCamera(K, k, size, sigma=sigma)


def _to_kalibr(camera: StoredCamera) -> str:
    k = camera.coefficients
    if camera.K[0, 1] or k[4:].any():
        raise ValueError(
            "Kalibr's pinhole-radtan camera has k1, k2, p1 and p2 only: calibrate with these four, "
            "without skew"
        )
    four = np.pad(k, (0, 4))[:4].tolist()
    intrinsics = camera.K[[0, 1, 0, 1], [0, 1, 2, 2]].tolist()
    return (
        "cam0:\n  cam_overlaps: []\n  camera_model: pinhole\n"
        f"  distortion_coeffs: {four}\n  distortion_model: radtan\n"
        f"  intrinsics: {intrinsics}\n  resolution: {list(camera.image_size)}\n"
        "  rostopic: /cam0/image_raw\n"
    )


def _from_kalibr(text: str) -> StoredCamera:
    import yaml  # type: ignore[import-untyped]

    try:
        content = yaml.safe_load(text.removeprefix("%YAML:1.0"))
    except yaml.YAMLError as error:
        raise ValueError(f"the YAML is broken: {error}") from error
    entry = content[min(name for name in content if name.startswith("cam"))]
    model = entry["camera_model"], entry["distortion_model"]
    if model != ("pinhole", "radtan"):
        raise ValueError(f"only pinhole cameras with radtan distortion can be read, got {model}")
    fx, fy, cx, cy = entry["intrinsics"]
    K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]], float)
    return StoredCamera(K, np.array(entry["distortion_coeffs"]), tuple(entry["resolution"]))


def _to_json(camera: StoredCamera) -> str:
    content: dict[str, Any] = {
        "image_size": list(camera.image_size),
        "K": camera.K.tolist(),
        "distortion": camera.coefficients.tolist(),
        "distortion_order": "k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4",
        "pixels": "(0, 0) is the middle of the upper left pixel",
        "rms": camera.rms if np.isfinite(camera.rms) else None,
        "sigma": camera.sigma,
    }
    return json.dumps(content, indent=2) + "\n"


def _from_json(text: str) -> StoredCamera:
    try:
        content = json.loads(text)
    except json.JSONDecodeError as error:
        raise ValueError(f"the JSON is broken: {error}") from error
    rms = content.get("rms")
    return StoredCamera(
        np.array(content["K"], float),
        np.array(content["distortion"], float),
        tuple(content["image_size"]),
        float("nan") if rms is None else rms,
        dict(content.get("sigma", {})),
    )


_WRITERS = {"opencv": _to_opencv, "matlab": _to_matlab, "kalibr": _to_kalibr, "json": _to_json}
