package simrobot.p2os;

import static simrobot.p2os.P2osSessionTable.Action.*;
import static simrobot.p2os.P2osSessionTable.P2osEvent.*;
import static simrobot.p2os.P2osSessionTable.State.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/**
 * A P2OS session from the client's connection to its end: SYNC0, SYNC1 and SYNC2, which are the commands PULSE, OPEN and
 * CLOSE and are echoed, the last with the robot's names; then OPEN begins and CLOSE ends the control of the robot.
 */
public final class P2osSessionTable {
    /** The states of a session. */
    public enum State {
        /** The client is connected; SYNC0 and SYNC1 are answered. */
        SYNCHRONISING,
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

    /** What a transition does. */
    public enum Action {
        ECHO_PULSE,
        ECHO_OPEN,
        SEND_NAMES,
        BEGIN_CONTROL,
        SEND_INFORMATION,
        END_CONTROL,
        CLOSE_CONNECTION
    }

    public static final StateTable<State, P2osEvent, Action> ROWS = new StateTable<State, P2osEvent, Action>(
                    "P2OS session", SYNCHRONISING)
            .on(EnumSet.of(SYNCHRONISING, INTRODUCED), PULSE_RECEIVED, SYNCHRONISING, ECHO_PULSE)
            .on(SYNCHRONISING, OPEN_RECEIVED, SYNCHRONISING, ECHO_OPEN)
            .on(INTRODUCED, OPEN_RECEIVED, OPEN, BEGIN_CONTROL, SEND_INFORMATION)
            .on(EnumSet.of(SYNCHRONISING, INTRODUCED), CLOSE_RECEIVED, INTRODUCED, SEND_NAMES)
            .on(OPEN, CLOSE_RECEIVED, ENDED, END_CONTROL, CLOSE_CONNECTION)
            .on(EnumSet.of(SYNCHRONISING, INTRODUCED), CONNECTION_LOST, ENDED)
            .on(OPEN, CONNECTION_LOST, ENDED, END_CONTROL)
            .on(EnumSet.of(SYNCHRONISING, INTRODUCED), ABORTED, ENDED, CLOSE_CONNECTION)
            .on(OPEN, ABORTED, ENDED, END_CONTROL, CLOSE_CONNECTION);

    private P2osSessionTable() {}
}
