package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.msc.ActiveCall.CALLED_TRANSACTION;
import static simgsm.center.msc.TestMobile.OUR_CALL;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Layer3Message;
import simgsm.center.msc.call.CallProgress;

/** At every step of a call: either side vanishes, or says anything at all; nothing may stay behind. */
class LinkLossTest {
    private static final int STEPS = 9;

    private final TestNetwork network = new TestNetwork();
    private final TestMobile caller = network.attach("5550100");
    private final TestMobile called = network.attach("5550200");

    /** Plays a call as far as this step; every step leaves at least one leg in another state than the one before. */
    private void playTo(int step) {
        List<Runnable> script = new ArrayList<>();
        script.add(() -> caller.dial("5550200"));
        script.add(called::takeSetup);
        script.add(() -> called.tell(new CallControl.CallConfirmed(CALLED_TRANSACTION)));
        script.add(() -> called.tell(new CallControl.Alerting(CALLED_TRANSACTION)));
        script.add(() -> called.tell(new CallControl.Connect(CALLED_TRANSACTION)));
        script.add(() -> caller.tell(new CallControl.ConnectAcknowledge(OUR_CALL)));
        script.add(() -> caller.tell(new CallControl.Disconnect(OUR_CALL, Cause.NORMAL_CALL_CLEARING)));
        script.add(() -> caller.tell(new CallControl.ReleaseComplete(OUR_CALL, Optional.empty())));
        script.add(() -> called.tell(new CallControl.Release(CALLED_TRANSACTION, Optional.empty())));
        assertEquals(STEPS, script.size());
        script.subList(0, step).forEach(Runnable::run);
    }

    private void assertNothingIsLeft() {
        network.passSeconds(400);
        assertTrue(network.exchange.calls().isEmpty());
        assertEquals(
                network.callStates().stream()
                        .filter(CallProgress.INITIATED::equals)
                        .count(),
                network.callStates().stream()
                        .filter(CallProgress.RELEASED::equals)
                        .count());
        caller.vanish();
        called.vanish();
        assertTrue(network.exchange.nextDeadlineNanos().isEmpty());
        assertEquals(0, network.exchange.linkCount());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9})
    void aVanishedCallerLeavesNothingBehind(int step) {
        playTo(step);
        caller.vanish();
        assertTrue(network.exchange.calls().isEmpty());
        assertNothingIsLeft();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9})
    void aVanishedCalledPartyLeavesNothingBehind(int step) {
        playTo(step);
        called.vanish();
        assertTrue(network.exchange.calls().isEmpty());
        assertNothingIsLeft();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9})
    void twoSilentMobilesLeaveNothingBehind(int step) {
        playTo(step);
        caller.answersPings = false;
        called.answersPings = false;
        assertNothingIsLeft();
    }

    @ParameterizedTest
    @CsvSource({
        "true, 1", "true, 2", "true, 3", "true, 4", "true, 5", "true, 6", "true, 7", "true, 8", "true, 9",
        "false, 1", "false, 2", "false, 3", "false, 4", "false, 5", "false, 6", "false, 7", "false, 8", "false, 9"
    })
    void anyMessageInAnyStateLeavesNothingBehind(boolean byCaller, int step) {
        TestMobile speaker = byCaller ? caller : called;
        var transaction = byCaller ? OUR_CALL : CALLED_TRANSACTION;
        List<Layer3Message> all = List.of(
                new CallControl.CallConfirmed(transaction),
                new CallControl.Alerting(transaction),
                new CallControl.ConnectAcknowledge(transaction),
                new CallControl.Connect(transaction),
                new CallControl.StatusEnquiry(transaction),
                new CallControl.Status(transaction, Cause.NORMAL_UNSPECIFIED, 10),
                new CallControl.StopDtmf(transaction),
                new CallControl.Setup(transaction, Optional.empty(), TestNetwork.number("5550100")),
                new CallControl.Disconnect(transaction, Cause.NORMAL_CALL_CLEARING),
                new CallControl.Release(transaction, Optional.empty()),
                new CallControl.ReleaseComplete(transaction, Optional.empty()));
        playTo(step);
        all.forEach(speaker::tell);
        assertNothingIsLeft();
    }
}
