import cv2
import numpy as np
import pytest
from real_data import fetched

from course_lib.calibration_files import FORMS, StoredCamera, read_camera, write_camera

K = np.array([[533.523, 0, 341.604], [0, 533.527, 235.193], [0, 0, 1]])
FIVE = np.array([-0.28838, 0.0971, 0.00109, -0.0003, -1 / 3])
SIGMA = {"fx": 0.31, "fy": 0.32, "cx": 0.5, "k1": 0.002}


def camera(coefficients=FIVE, skew=0.0, **more):
    skewed = K.copy()
    skewed[0, 1] = skew
    return StoredCamera(skewed, np.asarray(coefficients), (640, 480), **more)


class TestRoundTrip:
    @pytest.mark.parametrize("form", ["opencv", "matlab", "json"])
    @pytest.mark.parametrize("skew", [0, 0.7])
    def test_numbers(self, form, skew, tmp_path):
        before = camera(skew=skew, rms=0.158, sigma=SIGMA)
        after = read_camera(write_camera(tmp_path / f"camera{FORMS[form]}", before))
        np.testing.assert_allclose(after.K, before.K, rtol=1e-14)
        np.testing.assert_allclose(after.coefficients, FIVE, rtol=1e-14)
        assert after.image_size == (640, 480)
        assert after.sigma == pytest.approx(SIGMA)
        if form != "matlab":
            assert after.rms == 0.158

    def test_kalibr(self, tmp_path):
        before = camera(FIVE[:4])
        after = read_camera(write_camera(tmp_path / "chain.yaml", before))
        np.testing.assert_array_equal(after.K, before.K)
        np.testing.assert_array_equal(after.coefficients, FIVE[:4])
        assert after.image_size == (640, 480)

    def test_twelve_coefficients(self, tmp_path):
        twelve = np.arange(1, 13) / 70
        for name in ("c.yml", "c.json"):
            after = read_camera(write_camera(tmp_path / name, camera(twelve)))
            np.testing.assert_allclose(after.coefficients, twelve, rtol=1e-14)
        for name, said in (("c.m", "rational"), ("c.yaml", "k1, k2, p1 and p2 only")):
            with pytest.raises(ValueError, match=said):
                write_camera(tmp_path / name, camera(twelve))

    def test_kalibr_has_no_skew(self, tmp_path):
        with pytest.raises(ValueError, match="without skew"):
            write_camera(tmp_path / "c.yaml", camera(FIVE[:4], skew=1.0))


class TestOthersFiles:
    def test_opencv_reads_ours(self, tmp_path):
        path = write_camera(tmp_path / "camera.yml", camera(rms=0.2))
        file = cv2.FileStorage(str(path), cv2.FILE_STORAGE_READ)
        np.testing.assert_array_equal(file.getNode("camera_matrix").mat(), K)
        np.testing.assert_array_equal(file.getNode("distortion_coefficients").mat()[:, 0], FIVE)
        assert file.getNode("image_width").real() == 640
        assert file.getNode("avg_reprojection_error").real() == 0.2

    def test_we_read_opencvs(self):
        stored = read_camera(fetched("opencv_stereo/left_intrinsics.yml"))
        np.testing.assert_allclose(
            stored.K[[0, 0, 1], [0, 2, 2]], (535.91573, 342.28315, 235.57083), atol=1e-5
        )
        np.testing.assert_allclose(
            stored.coefficients, (-0.26637, -0.03859, 0.00178, -0.00028, 0.23839), atol=1e-5
        )
        assert stored.rms == pytest.approx(0.39259, abs=1e-5)

    def test_a_file_as_the_toolbox_writes_it(self, tmp_path):
        (tmp_path / "Calib_Results.m").write_text(
            "%-- Focal length:\nfc = [ 657.300000000000011 ; 657.700000000000045 ];\n\n"
            "%-- Skew coefficient:\nalpha_c = 0.001000000000000;\n\n"
            "cc = [ 302.9 ; 242.6 ];\nkc = [ -2.5e-01 ; 0.12 ; -0.0002 ; 0.00002 ; 0.0 ];\n"
            "fc_error = [ 0.3 ; 0.6 ];\nnx = 640;\nny = 480;\nn_ima = 20;\t% pictures\n"
            "omc_1 = [ 1.654766e+00 ; 1.651920e+00 ; -6.699498e-01 ];\n"
        )
        stored = read_camera(tmp_path / "Calib_Results.m")
        expected = [[657.3, 0.6573, 302.9], [0, 657.7, 242.6], [0, 0, 1]]
        np.testing.assert_allclose(stored.K, expected)
        np.testing.assert_allclose(stored.coefficients, (-0.25, 0.12, -0.0002, 0.00002, 0))
        assert stored.sigma == pytest.approx({"fx": 0.1, "fy": 0.2})

    def test_a_chain_as_kalibr_writes_it(self, tmp_path):
        (tmp_path / "camchain.yaml").write_text(
            "cam0:\n  cam_overlaps: [1]\n  camera_model: pinhole\n"
            "  distortion_coeffs: [-0.28, 0.07,\n    0.0002, 1.8e-05]\n  distortion_model: radtan\n"
            "  intrinsics: [458.7, 457.3, 367.2, 248.4]\n  resolution: [752, 480]\n"
            "cam1:\n  camera_model: omni\n  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, -0.11]\n"
        )
        stored = read_camera(tmp_path / "camchain.yaml")
        np.testing.assert_allclose(
            stored.K[[0, 1, 0, 1], [0, 1, 2, 2]], [458.7, 457.3, 367.2, 248.4]
        )
        np.testing.assert_allclose(stored.coefficients, [-0.28, 0.07, 0.0002, 1.8e-5])
        assert stored.image_size == (752, 480)


class TestErrors:
    def test_unknown_form(self, tmp_path):
        with pytest.raises(ValueError, match="form must be one of opencv, matlab"):
            write_camera(tmp_path / "camera.txt", camera())

    @pytest.mark.parametrize(
        ("name", "content", "said"),
        [
            ("c.yml", b"", "none of the known forms"),
            ("c.yml", b"\xff\xfe\x00", "is no text"),
            ("c.yml", b"%YAML:1.0\n---\ncamera_matrix_left: 3\n", "has no camera_matrix"),
            ("c.m", b"fc = [ 1 ; 2 ];\n", "has no nx"),
            ("c.json", b"{", "JSON is broken"),
            ("c.json", b'{"K": 1}', "has no distortion"),
            ("c.yaml", b"cam0:\n  camera_model: [", "YAML is broken"),
            ("c.yaml", b"cam0:\n  camera_model: omni\n  distortion_model: none\n", "only pinhole"),
        ],
    )
    def test_not_a_calibration(self, name, content, said, tmp_path):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(ValueError, match=said):
            read_camera(tmp_path / name)

    def test_no_camera(self):
        with pytest.raises(ValueError, match="K must be"):
            StoredCamera(np.eye(3) * 2, FIVE, (640, 480))
