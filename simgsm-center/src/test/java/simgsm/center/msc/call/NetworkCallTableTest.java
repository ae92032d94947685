package simgsm.center.msc.call;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallAction;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallEvent;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallState;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.state.StateTable;

class NetworkCallTableTest {
    private static final Set<NetworkCallAction> CLEARING_MESSAGES = EnumSet.of(
            NetworkCallAction.SEND_DISCONNECT, NetworkCallAction.SEND_RELEASE, NetworkCallAction.SEND_RELEASE_COMPLETE);

    private static final Set<NetworkTimer> CALL_TIMERS = EnumSet.range(NetworkTimer.T301, NetworkTimer.T313);

    @ParameterizedTest
    @EnumSource(NetworkCallState.class)
    void everyStateLeadsToNullWhenTheLinkIsLost(NetworkCallState state) {
        if (state != NetworkCallState.NULL) {
            assertEquals(
                    NetworkCallState.NULL,
                    NetworkCallTable.ROWS
                            .row(state, NetworkCallEvent.LINK_LOST)
                            .orElseThrow()
                            .next());
        }
    }

    @ParameterizedTest
    @EnumSource(NetworkCallState.class)
    void everyGuardTimerHasItsRowAndNoOtherTimerHasOne(NetworkCallState state) {
        for (NetworkTimer timer : CALL_TIMERS) {
            Optional<NetworkTimer> its = Optional.of(timer);
            assertEquals(
                    state.guard(false).equals(its) || state.guard(true).equals(its),
                    NetworkCallTable.ROWS
                            .row(state, NetworkCallEvent.expiryOf(timer))
                            .isPresent(),
                    state + " " + timer);
        }
    }

    @ParameterizedTest
    @EnumSource(NetworkCallState.class)
    void everyWayIntoClearingTellsTheMobileOrWasTheMobilesOwnOrLosesIt(NetworkCallState state) {
        for (NetworkCallEvent event : NetworkCallEvent.values()) {
            NetworkCallTable.ROWS
                    .row(state, event)
                    .filter(row -> row.next().isClearing() && row.next() != state)
                    .ifPresent(row -> assertTrue(tellsOrNeedNot(state, event, row), state + " " + event));
        }
    }

    private static boolean tellsOrNeedNot(
            NetworkCallState state,
            NetworkCallEvent event,
            StateTable.Row<NetworkCallState, NetworkCallEvent, NetworkCallAction> row) {
        boolean neverReached = state == NetworkCallState.MM_CONNECTION_PENDING;
        boolean mobileKnows = event == NetworkCallEvent.RELEASE_COMPLETE_RECEIVED
                || event == NetworkCallEvent.STATUS_NULL_RECEIVED
                || event == NetworkCallEvent.LINK_LOST
                || state == NetworkCallState.RELEASE_REQUEST;
        return neverReached || mobileKnows || row.actions().stream().anyMatch(CLEARING_MESSAGES::contains);
    }

    @ParameterizedTest
    @EnumSource(NetworkCallState.class)
    void theCallIsNotifiedExactlyWhenALiveLegIsClearedByOthersThanTheCall(NetworkCallState state) {
        for (NetworkCallEvent event : NetworkCallEvent.values()) {
            NetworkCallTable.ROWS.row(state, event).ifPresent(row -> {
                boolean ends = !state.isClearing() && row.next().isClearing();
                boolean told = row.actions().contains(NetworkCallAction.TELL_CLEARED);
                assertEquals(ends && event != NetworkCallEvent.CLEAR, told, state + " " + event);
            });
        }
    }

    @Test
    void everyStateButTheTransientOnesCanBeReachedFromNull() {
        Set<NetworkCallState> reached = EnumSet.of(NetworkCallState.NULL);
        for (int size = 0; size != reached.size(); ) {
            size = reached.size();
            Set<NetworkCallState> more = reached.stream()
                    .flatMap(state -> Arrays.stream(NetworkCallEvent.values())
                            .flatMap(event -> NetworkCallTable.ROWS.row(state, event).stream()))
                    .map(StateTable.Row::next)
                    .collect(Collectors.toCollection(() -> EnumSet.noneOf(NetworkCallState.class)));
            reached.addAll(more);
        }
        assertEquals(EnumSet.allOf(NetworkCallState.class), reached);
    }

    @Test
    void everyEventIsUsedSomewhere() {
        for (NetworkCallEvent event : NetworkCallEvent.values()) {
            assertTrue(
                    Arrays.stream(NetworkCallState.values())
                            .anyMatch(state ->
                                    NetworkCallTable.ROWS.row(state, event).isPresent()),
                    event.name());
        }
    }

    @Test
    void aMobileCannotConnectACallItWasNotOffered() {
        assertFalse(NetworkCallTable.ROWS
                .row(NetworkCallState.CALL_PROCEEDING, NetworkCallEvent.CONNECT_RECEIVED)
                .isPresent());
        assertFalse(NetworkCallTable.ROWS
                .row(NetworkCallState.CALL_PRESENT, NetworkCallEvent.CONNECT_RECEIVED)
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
