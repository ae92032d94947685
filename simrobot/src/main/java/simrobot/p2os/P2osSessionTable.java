package simrobot.p2os;

import static simrobot.p2os.P2osSessionTable.Action.*;
import static simrobot.p2os.P2osSessionTable.P2osEvent.*;
import static simrobot.p2os.P2osSessionTable.State.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/**
 * A P2OS session from the client's connection to its end: SYNC0, SYNC1 and SYNC2, which are the commands PULSE, OPEN and
 * CLOSE and are echoed, the last with the robot's names; then OPEN begins and CLOSE ends the control of the robot.
 *
 * <p>A client that has repeated SYNC0 before a late answer reads one answer behind from then on, and shows it by a SYNC0
 * after SYNC1. That is answered as out of order by 255, at which ARIA empties its line, and the SYNC0 sent meanwhile is not
 * answered: so the next answer is the one that the client waits for.
 */
public final class P2osSessionTable {
    /** The states of a session. */
    public enum State {
        /** The client is connected, or SYNC0 is answered. */
        SYNCHRONISING,
        /** SYNC1 is answered. */
        SYNCHRONISED,
        /** SYNC0 followed SYNC1 and is answered by 255; the next one is not answered. */
        OUT_OF_ORDER,
        /** SYNC2 is answered; the client may open. */
        INTRODUCED,
        /** The client controls the robot. */
        OPEN,
        ENDED
    }

    /** Commands of the handshake, and the ends of a session. */
    public enum P2osEvent {
        PULSE_RECEIVED,
        OPEN_RECEIVED,
        CLOSE_RECEIVED,
        /** The connection is closed. */
        CONNECTION_LOST,
        /** The robot is switched off, or the session has failed. */
        ABORTED
    }

    /** Action of a transition. */
    public enum Action {
        ECHO_PULSE,
        ECHO_OPEN,
        SEND_OUT_OF_ORDER,
        SEND_NAMES,
        BEGIN_CONTROL,
        SEND_INFORMATION,
        END_CONTROL,
        CLOSE_CONNECTION
    }

    private static final EnumSet<State> HANDSHAKE = EnumSet.range(SYNCHRONISING, INTRODUCED);

    public static final StateTable<State, P2osEvent, Action> ROWS = new StateTable<State, P2osEvent, Action>(
                    "P2OS session", SYNCHRONISING)
            .on(EnumSet.of(SYNCHRONISING, INTRODUCED), PULSE_RECEIVED, SYNCHRONISING, ECHO_PULSE)
            .on(SYNCHRONISED, PULSE_RECEIVED, OUT_OF_ORDER, SEND_OUT_OF_ORDER)
            .on(OUT_OF_ORDER, PULSE_RECEIVED, SYNCHRONISING)
            .on(EnumSet.range(SYNCHRONISING, OUT_OF_ORDER), OPEN_RECEIVED, SYNCHRONISED, ECHO_OPEN)
            .on(INTRODUCED, OPEN_RECEIVED, OPEN, BEGIN_CONTROL, SEND_INFORMATION)
            .on(HANDSHAKE, CLOSE_RECEIVED, INTRODUCED, SEND_NAMES)
            .on(OPEN, CLOSE_RECEIVED, ENDED, END_CONTROL, CLOSE_CONNECTION)
            .on(HANDSHAKE, CONNECTION_LOST, ENDED)
            .on(OPEN, CONNECTION_LOST, ENDED, END_CONTROL)
            .on(HANDSHAKE, ABORTED, ENDED, CLOSE_CONNECTION)
            .on(OPEN, ABORTED, ENDED, END_CONTROL, CLOSE_CONNECTION);

    private P2osSessionTable() {}
}
