package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.center.msc.CallTransitions.Transition;

class CallTransitionsTest {
    private static final Set<CallAction> CLEARING_MESSAGES =
            EnumSet.of(CallAction.SEND_DISCONNECT, CallAction.SEND_RELEASE, CallAction.SEND_RELEASE_COMPLETE);

    @ParameterizedTest
    @EnumSource(NetworkCallState.class)
    void everyStateLeadsToNullWhenTheLinkIsLost(NetworkCallState state) {
        if (state != NetworkCallState.NULL) {
            assertEquals(
                    NetworkCallState.NULL,
                    CallTransitions.of(state, CallEvent.LINK_LOST).orElseThrow().next());
        }
    }

    @ParameterizedTest
    @EnumSource(NetworkCallState.class)
    void everyGuardTimerHasItsRowAndNoOtherTimerHasOne(NetworkCallState state) {
        for (CallTimer timer : CallTimer.values()) {
            java.util.Optional<CallTimer> its = java.util.Optional.of(timer);
            assertEquals(
                    state.guard(false).equals(its) || state.guard(true).equals(its),
                    CallTransitions.of(state, timer.expiry()).isPresent(),
                    state + " " + timer);
        }
    }

    @ParameterizedTest
    @EnumSource(NetworkCallState.class)
    void everyWayIntoClearingTellsTheMobileOrWasTheMobilesOwnOrLosesIt(NetworkCallState state) {
        for (CallEvent event : CallEvent.values()) {
            CallTransitions.of(state, event)
                    .filter(row -> row.next().isClearing() && row.next() != state)
                    .ifPresent(row -> assertTrue(tellsOrNeedNot(state, event, row), state + " " + event));
        }
    }

    private static boolean tellsOrNeedNot(NetworkCallState state, CallEvent event, Transition row) {
        boolean neverReached = state == NetworkCallState.MM_CONNECTION_PENDING;
        boolean mobileKnows = event == CallEvent.RELEASE_COMPLETE_RECEIVED
                || event == CallEvent.STATUS_NULL_RECEIVED
                || event == CallEvent.LINK_LOST
                || state == NetworkCallState.RELEASE_REQUEST;
        return neverReached || mobileKnows || row.actions().stream().anyMatch(CLEARING_MESSAGES::contains);
    }

    @ParameterizedTest
    @EnumSource(NetworkCallState.class)
    void theCallIsToldExactlyWhenALiveLegIsClearedByOthersThanTheCall(NetworkCallState state) {
        for (CallEvent event : CallEvent.values()) {
            CallTransitions.of(state, event).ifPresent(row -> {
                boolean ends = !state.isClearing() && row.next().isClearing();
                boolean told = row.actions().contains(CallAction.TELL_CLEARED);
                assertEquals(ends && event != CallEvent.CLEAR, told, state + " " + event);
            });
        }
    }

    @Test
    void everyStateButTheTransientOnesCanBeReachedFromNull() {
        Set<NetworkCallState> reached = EnumSet.of(NetworkCallState.NULL);
        for (int size = 0; size != reached.size(); ) {
            size = reached.size();
            Set<NetworkCallState> more = reached.stream()
                    .flatMap(state -> Arrays.stream(CallEvent.values())
                            .flatMap(event -> CallTransitions.of(state, event).stream()))
                    .map(Transition::next)
                    .collect(Collectors.toCollection(() -> EnumSet.noneOf(NetworkCallState.class)));
            reached.addAll(more);
        }
        assertEquals(EnumSet.allOf(NetworkCallState.class), reached);
    }

    @Test
    void everyEventIsUsedSomewhere() {
        for (CallEvent event : CallEvent.values()) {
            assertTrue(
                    Arrays.stream(NetworkCallState.values())
                            .anyMatch(state -> CallTransitions.of(state, event).isPresent()),
                    event.name());
        }
    }

    @Test
    void aMobileCannotConnectACallItWasNotOffered() {
        assertFalse(CallTransitions.of(NetworkCallState.CALL_PROCEEDING, CallEvent.CONNECT_RECEIVED)
                .isPresent());
        assertFalse(CallTransitions.of(NetworkCallState.CALL_PRESENT, CallEvent.CONNECT_RECEIVED)
                .isPresent());
    }

    @Test
    void stateCodesAreThoseOfTheStandardAndDistinct() {
        assertEquals(
                NetworkCallState.values().length,
                Arrays.stream(NetworkCallState.values())
                        .map(NetworkCallState::code)
                        .distinct()
                        .count());
        assertEquals(28, NetworkCallState.CONNECT_INDICATION.code());
        assertEquals(10, NetworkCallState.ACTIVE.code());
    }
}
