"""On a Dask cluster one worker is killed while it works: the same bytes as in one process."""

import os
import signal
import threading
import time

import pytest
from written_files import files

import simpter_hybrid as sh
from simpter_hybrid.cli import main

pytest.importorskip("llvmlite")
distributed = pytest.importorskip("distributed", reason="needs the extra 'dask'")
pytestmark = pytest.mark.slow  # starting a cluster takes seconds
NAME = "regulation-30hz-gain-0.25"
GAINS = "controller.stages.2.gain=0:0.2 V/(lbf*in):300"


@pytest.fixture
def cluster():
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster:
        yield cluster


def test_a_worker_is_killed(tmp_path, cluster, capsys):
    out = tmp_path / "dask"
    with distributed.Client(cluster) as client:
        workers = client.run(os.getpid)

        def kill():
            while len(list(out.glob("cases/*.json"))) < 40:
                time.sleep(0.005)
            os.kill(next(iter(workers.values())), signal.SIGKILL)

        killer = threading.Thread(target=kill, daemon=True)
        killer.start()
        words = ["sweep", NAME, "--vary", GAINS, "--chunk", "4", "--no-pictures"]
        assert main([*words, "--dask", cluster.scheduler_address, "--out", str(out)]) == 0
        assert not killer.is_alive()
        assert set(workers.values()) - set(client.run(os.getpid).values())
    sh.sweep(NAME, [GAINS], tmp_path / "alone")
    assert files(out) == files(tmp_path / "alone")


def test_an_address_where_nobody_answers(tmp_path, capsys):
    words = ["sweep", NAME, "--vary", GAINS, "--out", str(tmp_path / "s")]
    assert main([*words, "--dask", "tcp://127.0.0.1:9"]) == 2
    assert "--dask: no scheduler answers" in capsys.readouterr().err
