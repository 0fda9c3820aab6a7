# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A machine that has a service."""

import pytest

import rivulet


def test_a_program_is_streamed(service):
    report = rivulet.stream("part.mpf", "service:" + service, feed=1500, points=7)
    assert (report.outcome, report.executed) == ("completed", 30)


def test_a_run_is_held_and_goes_on(service):
    with rivulet.Service(service) as run:
        run.load("part.mpf", feed=120)
        run.start()
        while run.executed < 2:
            assert run.state in ("armed", "running"), run.show()
        run.hold()
        while run.state != "holding":
            assert run.state == "running", run.show()
        run.override(120)
        run.resume()
        assert run.wait().executed == 30
    assert run.late >= 0


def test_an_exception_stops_the_run(service):
    with pytest.raises(ZeroDivisionError):
        with rivulet.Service(service) as run:
            run.load("part.mpf", feed=120)
            run.start()
            while run.executed < 2:
                assert run.state in ("armed", "running"), run.show()
            print(1 / 0)
    assert run.state in ("stopping", "holding", "left", "loaded")
    assert run.executed < 30


def test_what_a_service_refuses(service):
    with rivulet.Service(service) as run:
        with pytest.raises(rivulet.BadInput, match="folder|file|program"):
            run.load("../part.mpf")
        with pytest.raises(rivulet.BadInput):
            run.start()


def test_no_service(monkeypatch):
    with pytest.raises(rivulet.ConnectionFailed):
        rivulet.Service("opc.tcp://127.0.0.1:1").show()
    monkeypatch.setenv("RIVULET_SERVICE", "/nowhere/rivulet-service")
    with pytest.raises(rivulet.NotFound, match="RIVULET_SERVICE"):
        rivulet.Service("opc.tcp://127.0.0.1:1").show()
