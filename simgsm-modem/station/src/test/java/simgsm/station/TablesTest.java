package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Queue;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simgsm.state.StateTable;
import simgsm.station.call.KeySignallingTable;
import simgsm.station.call.KeySignallingTable.KeySignallingEvent;
import simgsm.station.call.KeySignallingTable.KeySignallingState;
import simgsm.station.call.MobileCallTable;
import simgsm.station.call.MobileCallTable.MobileCallAction;
import simgsm.station.call.MobileCallTable.MobileCallEvent;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.mobility.MobileRegistrationTable;
import simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationEvent;
import simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationState;
import simgsm.station.sms.OutgoingMessageTable;
import simgsm.station.sms.OutgoingMessageTable.OutgoingMessageAction;
import simgsm.station.sms.OutgoingMessageTable.OutgoingMessageEvent;
import simgsm.station.sms.OutgoingMessageTable.OutgoingMessageState;

/** Walks all states of each machine with all events. */
class TablesTest {
    private static final Set<MobileCallState> RELEASE_REPORTED = EnumSet.of(
            MobileCallState.NULL,
            MobileCallState.DISCONNECT_REQUEST,
            MobileCallState.DISCONNECT_INDICATION,
            MobileCallState.RELEASE_REQUEST);

    @Test
    void theEndOfACallIsReportedExactlyOnceOnEveryWay() {
        forAllCallRows((state, event, row) -> {
            boolean begins = !RELEASE_REPORTED.contains(state)
                    && RELEASE_REPORTED.contains(row.next())
                    && event != MobileCallEvent.CALL_HELD;
            int told = Collections.frequency(row.actions(), MobileCallAction.REPORT_RELEASED);
            assertEquals(begins ? 1 : 0, told, state + " " + event);
        });
    }

    @Test
    void everyWayIntoNullStopsTheTimersThatMayRun() {
        forAllCallRows((state, event, row) -> {
            boolean timerItself = event == MobileCallEvent.T308_EXPIRED_AGAIN;
            if (row.next() == MobileCallState.NULL && state != MobileCallState.NULL && !timerItself) {
                assertTrue(row.actions().contains(MobileCallAction.STOP_TIMERS), state + " " + event);
            }
        });
    }

    @Test
    void everyWayIntoNullGivesTheRadioBackUnlessItIsGone() {
        forAllCallRows((state, event, row) -> {
            boolean neverAsked = state == MobileCallState.MM_CONNECTION_PENDING && event == MobileCallEvent.RADIO_LOST;
            boolean goesOn = event == MobileCallEvent.CALL_HELD;
            if (row.next() == MobileCallState.NULL && state != MobileCallState.NULL && !neverAsked && !goesOn) {
                assertTrue(row.actions().contains(MobileCallAction.RELEASE_CONNECTION), state + " " + event);
            }
        });
    }

    @Test
    void speechRunsInStateActiveOnly() {
        forAllCallRows((state, event, row) -> {
            boolean starts = state != MobileCallState.ACTIVE && row.next() == MobileCallState.ACTIVE;
            boolean stops = state == MobileCallState.ACTIVE && row.next() != MobileCallState.ACTIVE;
            assertEquals(starts, row.actions().contains(MobileCallAction.START_SPEECH), state + " " + event);
            assertTrue(!stops || row.actions().contains(MobileCallAction.STOP_SPEECH), state + " " + event);
        });
    }

    @Test
    void everyStateButNullCanLoseTheRadioAndThePower() {
        for (MobileCallState state : MobileCallState.values()) {
            assertEquals(
                    MobileCallState.NULL,
                    MobileCallTable.TABLE
                            .row(state, MobileCallEvent.RADIO_LOST)
                            .orElseThrow()
                            .next());
            assertEquals(
                    MobileCallState.NULL,
                    MobileCallTable.TABLE
                            .row(state, MobileCallEvent.POWER_OFF)
                            .orElseThrow()
                            .next());
        }
    }

    @Test
    void everyCallStateCanBeReached() {
        assertEquals(
                EnumSet.allOf(MobileCallState.class),
                reachable(
                        MobileCallTable.TABLE, MobileCallState.NULL, MobileCallState.class, MobileCallEvent.values()));
    }

    @Test
    void everyRegistrationStateCanBeReached() {
        assertEquals(
                EnumSet.allOf(MobileRegistrationState.class),
                reachable(
                        MobileRegistrationTable.TABLE,
                        MobileRegistrationState.NULL,
                        MobileRegistrationState.class,
                        MobileRegistrationEvent.values()));
    }

    @Test
    void everyOutgoingStateCanBeReached() {
        assertEquals(
                EnumSet.allOf(OutgoingMessageState.class),
                reachable(
                        OutgoingMessageTable.TABLE,
                        OutgoingMessageState.IDLE,
                        OutgoingMessageState.class,
                        OutgoingMessageEvent.values()));
    }

    @Test
    void everyKeyStateCanBeReachedAndLeftByTheEndOfTheCall() {
        assertEquals(
                EnumSet.allOf(KeySignallingState.class),
                reachable(
                        KeySignallingTable.TABLE,
                        KeySignallingState.IDLE,
                        KeySignallingState.class,
                        KeySignallingEvent.values()));
        for (KeySignallingState state : KeySignallingState.values()) {
            assertEquals(
                    KeySignallingState.IDLE,
                    KeySignallingTable.TABLE
                            .row(state, KeySignallingEvent.CALL_ENDED)
                            .orElseThrow()
                            .next());
        }
    }

    @Test
    void everyEndOfAMessageIsReportedExactlyOnce() {
        for (OutgoingMessageState state : OutgoingMessageState.values()) {
            for (OutgoingMessageEvent event : OutgoingMessageEvent.values()) {
                OutgoingMessageTable.TABLE.row(state, event).ifPresent(row -> {
                    boolean ends = state != OutgoingMessageState.IDLE && row.next() == OutgoingMessageState.IDLE;
                    long told = row.actions().stream()
                            .filter(
                                    EnumSet.of(OutgoingMessageAction.REPORT_SENT, OutgoingMessageAction.REPORT_FAILED)
                                            ::contains)
                            .count();
                    assertEquals(ends ? 1 : 0, told, state + " " + event);
                });
            }
        }
    }

    @Test
    void everyRegistrationStateCanLoseTheLink() {
        for (MobileRegistrationState state : MobileRegistrationState.values()) {
            assertTrue(
                    MobileRegistrationTable.TABLE
                            .row(state, MobileRegistrationEvent.LINK_LOST)
                            .isPresent(),
                    state.name());
        }
    }

    @Test
    void theNumbersOfTheStandardsTable() {
        assertEquals(11, MobileCallState.DISCONNECT_REQUEST.code());
    }

    private interface RowCheck {
        void check(
                MobileCallState state,
                MobileCallEvent event,
                StateTable.Row<MobileCallState, MobileCallEvent, MobileCallAction> row);
    }

    private static void forAllCallRows(RowCheck check) {
        for (MobileCallState state : MobileCallState.values()) {
            for (MobileCallEvent event : MobileCallEvent.values()) {
                MobileCallTable.TABLE.row(state, event).ifPresent(row -> check.check(state, event, row));
            }
        }
    }

    private static <S extends Enum<S>, E extends Enum<E>, A extends Enum<A>> Set<S> reachable(
            StateTable<S, E, A> table, S start, Class<S> states, E[] events) {
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
