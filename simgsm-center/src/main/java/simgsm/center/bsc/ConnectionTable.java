package simgsm.center.bsc;

import static simgsm.center.bsc.ConnectionTable.ConnectionAction.*;
import static simgsm.center.bsc.ConnectionTable.ConnectionEvent.*;
import static simgsm.center.bsc.ConnectionTable.ConnectionState.*;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import simgsm.state.StateTable;

/**
 * A mobile's radio connection at the controller: access, assignment of a traffic channel, handover, release (TS 44.018, 3.3 and
 * 3.4). An event without a row is ignored.
 */
public final class ConnectionTable {
    /** States of a radio connection. */
    public enum ConnectionState {
        /** The first channel is being activated. */
        ACCESS,
        /** IMMEDIATE ASSIGNMENT is sent. */
        GRANTED(BscTimer.T3101, T3101_EXPIRED),
        /** The mobile is on its channel. */
        DEDICATED,
        /** Dedicated, waiting for a traffic channel; T11 runs from the first attempt. */
        QUEUED,
        /** CHANNEL MODE MODIFY is sent, for speech on a traffic channel that carries signalling. */
        CHANGING_MODE(BscTimer.MODE_OF_MOBILE, MODE_UNANSWERED),
        /** The mobile has acknowledged the mode; MODE MODIFY REQUEST is sent to the tower. */
        CHANGING_CHANNEL(BscTimer.MODE_OF_TOWER, MODE_UNANSWERED),
        /** The traffic channel is being activated. */
        PREPARING_ASSIGNMENT,
        /** ASSIGNMENT COMMAND is sent; layer 3 waits. */
        ASSIGNING(BscTimer.T10, T10_EXPIRED),
        /** The channel in the other cell is being activated. */
        PREPARING_HANDOVER,
        /** HANDOVER COMMAND is sent; layer 3 waits. */
        HANDING_OVER(BscTimer.T3103, T3103_EXPIRED),
        ENDED;

        /** The maximum time in a state, and the event at its end. */
        record Guard(BscTimer timer, ConnectionEvent expiry) {}

        private final Optional<Guard> guard;

        ConnectionState() {
            guard = Optional.empty();
        }

        ConnectionState(BscTimer timer, ConnectionEvent expiry) {
            guard = Optional.of(new Guard(timer, expiry));
        }

        /** The limit of the state; empty if the channels, the exchange or T11 limit it. */
        Optional<Guard> guard() {
            return guard;
        }
    }

    /** Events of a radio connection. */
    public enum ConnectionEvent {
        CHANNEL_ACTIVE,
        CHANNEL_FAILED,
        /** The first message has arrived, on the first channel. */
        MOBILE_ARRIVED,
        T3101_EXPIRED,
        ASSIGN,
        /** The current channel can carry speech. */
        MODIFY,
        MODE_ACCEPTED,
        /** The mobile or the tower does not support the mode, or does not answer. */
        MODE_REFUSED,
        MODE_UNANSWERED,
        QUEUE,
        T11_EXPIRED,
        /** No call needs a traffic channel any more. */
        SPEECH_UNUSED,
        HANDOVER,
        COMPLETED,
        /** The mobile has returned to the old channel. */
        RETURNED,
        T10_EXPIRED,
        T3103_EXPIRED,
        /** The mobile or its tower is lost. */
        LOST,
        RELEASE
    }

    /** Actions of a radio connection. */
    public enum ConnectionAction {
        GRANT_ACCESS,
        REJECT_ACCESS,
        TELL_ARRIVED,
        ACTIVATE_TARGET,
        COMMAND_ASSIGNMENT,
        COMMAND_HANDOVER,
        COMMAND_MODE,
        MODIFY_CHANNEL,
        CREATE_SPEECH,
        /** The target becomes the connection's channel. */
        SWITCH,
        SEND_WAITING,
        ABANDON_CHANNEL,
        ABANDON_TARGET,
        REFUSE_SPEECH,
        /** Searches again for a traffic channel, if a call still needs one. */
        SEEK_SPEECH,
        RELEASE_CHANNEL,
        TELL_LOST
    }

    /** The mobile is on its channel and layer 3 flows. */
    private static final Set<ConnectionState> FLOWING =
            EnumSet.of(DEDICATED, QUEUED, CHANGING_MODE, CHANGING_CHANNEL, PREPARING_ASSIGNMENT, PREPARING_HANDOVER);

    public static final StateTable<ConnectionState, ConnectionEvent, ConnectionAction> ROWS =
            new StateTable<>("radio connection", ACCESS);

    static {
        access();
        assignment();
        mode();
        handover();
        end();
    }

    private ConnectionTable() {}

    private static void access() {
        ROWS.on(ACCESS, CHANNEL_ACTIVE, GRANTED, GRANT_ACCESS)
                .on(ACCESS, CHANNEL_FAILED, ENDED, REJECT_ACCESS)
                .on(GRANTED, MOBILE_ARRIVED, DEDICATED, TELL_ARRIVED)
                .on(GRANTED, T3101_EXPIRED, ENDED, ABANDON_CHANNEL);
    }

    private static void assignment() {
        ROWS.on(EnumSet.of(DEDICATED, QUEUED), ASSIGN, PREPARING_ASSIGNMENT, ACTIVATE_TARGET)
                .on(DEDICATED, QUEUE, QUEUED)
                .on(QUEUED, T11_EXPIRED, DEDICATED, REFUSE_SPEECH)
                .on(QUEUED, SPEECH_UNUSED, DEDICATED)
                .on(PREPARING_ASSIGNMENT, CHANNEL_ACTIVE, ASSIGNING, COMMAND_ASSIGNMENT)
                .on(PREPARING_ASSIGNMENT, CHANNEL_FAILED, DEDICATED, SEEK_SPEECH)
                .on(ASSIGNING, COMPLETED, DEDICATED, SWITCH, SEND_WAITING)
                .on(ASSIGNING, RETURNED, DEDICATED, ABANDON_TARGET, SEND_WAITING, REFUSE_SPEECH)
                .on(ASSIGNING, T10_EXPIRED, ENDED, ABANDON_TARGET, ABANDON_CHANNEL, TELL_LOST);
    }

    /** TS 44.018, 3.4.6. */
    private static void mode() {
        ROWS.on(DEDICATED, MODIFY, CHANGING_MODE, COMMAND_MODE)
                .on(CHANGING_MODE, MODE_ACCEPTED, CHANGING_CHANNEL, MODIFY_CHANNEL)
                .on(CHANGING_CHANNEL, CHANNEL_ACTIVE, DEDICATED, CREATE_SPEECH)
                .on(
                        EnumSet.of(CHANGING_MODE, CHANGING_CHANNEL),
                        EnumSet.of(MODE_REFUSED, MODE_UNANSWERED),
                        DEDICATED,
                        REFUSE_SPEECH);
    }

    private static void handover() {
        ROWS.on(EnumSet.of(DEDICATED, QUEUED), HANDOVER, PREPARING_HANDOVER, ACTIVATE_TARGET)
                .on(PREPARING_HANDOVER, CHANNEL_ACTIVE, HANDING_OVER, COMMAND_HANDOVER)
                .on(PREPARING_HANDOVER, CHANNEL_FAILED, DEDICATED, SEEK_SPEECH)
                .on(HANDING_OVER, COMPLETED, DEDICATED, SWITCH, SEND_WAITING)
                .on(HANDING_OVER, RETURNED, DEDICATED, ABANDON_TARGET, SEND_WAITING, SEEK_SPEECH)
                .on(HANDING_OVER, T3103_EXPIRED, ENDED, ABANDON_TARGET, ABANDON_CHANNEL, TELL_LOST);
    }

    private static void end() {
        ROWS.on(EnumSet.of(DEDICATED, QUEUED, CHANGING_MODE, CHANGING_CHANNEL), RELEASE, ENDED, RELEASE_CHANNEL)
                .on(
                        EnumSet.of(PREPARING_ASSIGNMENT, PREPARING_HANDOVER),
                        RELEASE,
                        ENDED,
                        ABANDON_TARGET,
                        RELEASE_CHANNEL)
                .on(EnumSet.of(ACCESS, GRANTED), LOST, ENDED, ABANDON_CHANNEL)
                .on(EnumSet.of(ASSIGNING, HANDING_OVER), LOST, ENDED, ABANDON_TARGET, ABANDON_CHANNEL, TELL_LOST)
                .on(FLOWING, LOST, ENDED, ABANDON_TARGET, ABANDON_CHANNEL, TELL_LOST);
    }
}
