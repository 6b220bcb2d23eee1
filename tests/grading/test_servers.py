import socket
import threading

import numpy as np
import pytest

from course_lib.grading.servers import MOST_OUTPUT, Conversation
from course_lib.sandbox import wire


def heard(messages):
    """Return a conversation that has listened to messages, and how many were taken."""
    mine, its = socket.socketpair()
    taken = 0

    def say():
        nonlocal taken
        try:
            for message in messages:
                wire.send(its, message)
                taken += 1
        except wire.Closed:
            pass
        its.close()

    with mine:
        conversation = Conversation(mine, mine, [], 60.0)
        speaker = threading.Thread(target=say)
        speaker.start()
        conversation.listen(20)
    speaker.join()
    return conversation, taken


def test_outputs_are_kept_until_the_last_cell_has_run():
    said = {"cell": 3, "outputs": [{"output_type": "stream", "text": "4"}], "count": 1}
    conversation, _ = heard([said, {"check": 0}, "done"])
    assert (conversation.finished, conversation.reason) == (True, "")
    assert (conversation.outputs, conversation.reached) == ({3: said}, {0})


BIG = np.zeros(MOST_OUTPUT // 80)


@pytest.mark.parametrize(
    "flood", [{"outputs": [BIG]}, {"outputs": [], "more": BIG}, {"outputs": "x" * BIG.nbytes}]
)
def test_whatever_a_submission_says_it_fills_no_memory(flood):
    conversation, taken = heard({"cell": cell, **flood} for cell in range(40))
    assert conversation.reason == "output"
    assert taken < 14


@pytest.mark.parametrize(
    "forged", [np.array(["done", "done"]), 3, [], {"cell": "x"}, {"check": {}}]
)
def test_what_is_no_message_ends_it(forged):
    assert heard([forged])[0].reason == "confused"
