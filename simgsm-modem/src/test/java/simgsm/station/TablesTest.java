package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Queue;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Walks all states of each machine with all events. */
class TablesTest {
    private static final Set<CallState> TOLD_OF_RELEASE = EnumSet.of(
            CallState.NULL, CallState.DISCONNECT_REQUEST, CallState.DISCONNECT_INDICATION, CallState.RELEASE_REQUEST);

    @Test
    void theEndOfACallIsToldExactlyOnceOnEveryWay() {
        forAllCallRows((state, event, row) -> {
            boolean begins = !TOLD_OF_RELEASE.contains(state) && TOLD_OF_RELEASE.contains(row.next());
            int told = Collections.frequency(row.actions(), CallAction.TELL_RELEASED);
            assertEquals(begins ? 1 : 0, told, state + " " + event);
        });
    }

    @Test
    void everyWayIntoNullStopsTheTimersThatMayRun() {
        forAllCallRows((state, event, row) -> {
            boolean timerItself = event == CallEvent.T308_EXPIRED_AGAIN;
            if (row.next() == CallState.NULL && state != CallState.NULL && !timerItself) {
                assertTrue(row.actions().contains(CallAction.STOP_TIMERS), state + " " + event);
            }
        });
    }

    @Test
    void everyWayIntoNullGivesTheRadioBackUnlessItIsGone() {
        forAllCallRows((state, event, row) -> {
            boolean neverAsked = state == CallState.MM_CONNECTION_PENDING && event == CallEvent.RADIO_LOST;
            if (row.next() == CallState.NULL && state != CallState.NULL && !neverAsked) {
                assertTrue(row.actions().contains(CallAction.RELEASE_CONNECTION), state + " " + event);
            }
        });
    }

    @Test
    void speechRunsInStateActiveOnly() {
        forAllCallRows((state, event, row) -> {
            boolean starts = state != CallState.ACTIVE && row.next() == CallState.ACTIVE;
            boolean stops = state == CallState.ACTIVE && row.next() != CallState.ACTIVE;
            assertEquals(starts, row.actions().contains(CallAction.START_SPEECH), state + " " + event);
            assertTrue(!stops || row.actions().contains(CallAction.STOP_SPEECH), state + " " + event);
        });
    }

    @Test
    void everyStateButNullCanLoseTheRadioAndThePower() {
        for (CallState state : CallState.values()) {
            assertEquals(
                    CallState.NULL,
                    CallTable.ROWS
                            .row(state, CallEvent.RADIO_LOST)
                            .orElseThrow()
                            .next());
            assertEquals(
                    CallState.NULL,
                    CallTable.ROWS.row(state, CallEvent.POWER_OFF).orElseThrow().next());
        }
    }

    @Test
    void everyCallStateCanBeReached() {
        assertEquals(
                EnumSet.allOf(CallState.class),
                reachable(CallTable.ROWS, CallState.NULL, CallState.class, CallEvent.values()));
    }

    @Test
    void everyRegistrationStateCanBeReached() {
        assertEquals(
                EnumSet.allOf(RegistrationState.class),
                reachable(
                        RegistrationTable.ROWS,
                        RegistrationState.NO_CELL_AVAILABLE,
                        RegistrationState.class,
                        RegistrationEvent.values()));
    }

    @Test
    void everyOutgoingStateCanBeReached() {
        assertEquals(
                EnumSet.allOf(OutgoingState.class),
                reachable(OutgoingTable.ROWS, OutgoingState.IDLE, OutgoingState.class, OutgoingEvent.values()));
    }

    @Test
    void everyKeyStateCanBeReachedAndLeftByTheEndOfTheCall() {
        assertEquals(
                EnumSet.allOf(KeyState.class),
                reachable(KeyTable.ROWS, KeyState.IDLE, KeyState.class, KeyEvent.values()));
        for (KeyState state : KeyState.values()) {
            assertEquals(
                    KeyState.IDLE,
                    KeyTable.ROWS.row(state, KeyEvent.CALL_ENDED).orElseThrow().next());
        }
    }

    @Test
    void everyEndOfAMessageIsToldExactlyOnce() {
        for (OutgoingState state : OutgoingState.values()) {
            for (OutgoingEvent event : OutgoingEvent.values()) {
                OutgoingTable.ROWS.row(state, event).ifPresent(row -> {
                    boolean ends = state != OutgoingState.IDLE && row.next() == OutgoingState.IDLE;
                    long told = row.actions().stream()
                            .filter(EnumSet.of(OutgoingAction.TELL_SENT, OutgoingAction.TELL_FAILED)::contains)
                            .count();
                    assertEquals(ends ? 1 : 0, told, state + " " + event);
                });
            }
        }
    }

    @Test
    void everyRegistrationStateCanLoseTheLink() {
        for (RegistrationState state : RegistrationState.values()) {
            assertTrue(
                    RegistrationTable.ROWS
                            .row(state, RegistrationEvent.LINK_LOST)
                            .isPresent(),
                    state.name());
        }
    }

    @Test
    void theNumbersOfTheStandardsTable() {
        assertEquals("U11", CallState.DISCONNECT_REQUEST.shortName());
        assertEquals(11, CallState.DISCONNECT_REQUEST.code());
        Arrays.stream(CallState.values())
                .filter(state -> state != CallState.MM_CONNECTION_PENDING)
                .forEach(state -> assertEquals("U" + state.code(), state.shortName()));
    }

    @Test
    void twoRowsForOneStateAndEventAreRefused() {
        var table = new TransitionTable<CallState, CallEvent, CallAction>()
                .on(EnumSet.of(CallState.NULL), CallEvent.DIAL, CallState.ACTIVE);
        assertThrows(
                IllegalArgumentException.class,
                () -> table.stay(EnumSet.of(CallState.NULL), CallEvent.DIAL, CallAction.SEND_SETUP));
    }

    private interface RowCheck {
        void check(CallState state, CallEvent event, TransitionTable.Row<CallState, CallAction> row);
    }

    private static void forAllCallRows(RowCheck check) {
        for (CallState state : CallState.values()) {
            for (CallEvent event : CallEvent.values()) {
                CallTable.ROWS.row(state, event).ifPresent(row -> check.check(state, event, row));
            }
        }
    }

    private static <S extends Enum<S>, E extends Enum<E>, A extends Enum<A>> Set<S> reachable(
            TransitionTable<S, E, A> table, S start, Class<S> states, E[] events) {
        Set<S> reached = EnumSet.of(start);
        Queue<S> next = new ArrayDeque<>(reached);
        for (S state = next.poll(); state != null; state = next.poll()) {
            for (E event : events) {
                table.row(state, event).filter(row -> reached.add(row.next())).ifPresent(row -> next.add(row.next()));
            }
        }
        return states.isInstance(start) ? reached : EnumSet.noneOf(states);
    }
}
