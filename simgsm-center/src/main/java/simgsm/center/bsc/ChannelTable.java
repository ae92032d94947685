package simgsm.center.bsc;

import static simgsm.center.bsc.ChannelTable.ChannelAction.*;
import static simgsm.center.bsc.ChannelTable.ChannelEvent.*;
import static simgsm.center.bsc.ChannelTable.ChannelState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** A dedicated channel of a tower, from activation to release (TS 48.058, 4). An event without a row is ignored. */
public final class ChannelTable {
    /** States of a channel. */
    public enum ChannelState {
        FREE,
        /** CHANNEL ACTIVATION is sent. */
        ACTIVATING,
        /** A mobile uses the channel, or is moving to it. */
        ACTIVE,
        /** SACCH and SAPI 3 are being closed. */
        CLOSING,
        /** The mobile leaves the channel. */
        LEAVING,
        /** RF CHANNEL RELEASE is sent. */
        FREEING,
        /** The tower has not answered, or has refused; the channel is unused until it answers. */
        BROKEN
    }

    /** Events of a channel. */
    public enum ChannelEvent {
        ACTIVATE,
        ACTIVATED,
        REFUSED,
        /** The mobile has moved to another channel or is lost: the channel ends at once. */
        ABANDON,
        /** The radio connection ends in order. */
        RELEASE,
        LINKS_CLOSED,
        T3109_EXPIRED,
        T3111_EXPIRED,
        /** The time of the state has expired without an answer of the tower. */
        UNANSWERED,
        FREED
    }

    /** Actions of a channel. */
    public enum ChannelAction {
        SEND_ACTIVATION,
        SEND_DEACTIVATE_SACCH,
        /** Local end of SAPI 3, if it is open. */
        SEND_RELEASE_REQUEST,
        START_T3111,
        SEND_RF_RELEASE,
        TELL_ACTIVE,
        TELL_FAILED,
        TELL_FREE
    }

    public static final StateTable<ChannelState, ChannelEvent, ChannelAction> ROWS =
            new StateTable<>("dedicated channel", FREE);

    static {
        ROWS.on(FREE, ACTIVATE, ACTIVATING, SEND_ACTIVATION)
                .on(ACTIVATING, ACTIVATED, ACTIVE, TELL_ACTIVE)
                .on(EnumSet.of(ACTIVATING), EnumSet.of(REFUSED, UNANSWERED), BROKEN, TELL_FAILED)
                .on(ACTIVATING, ABANDON, FREEING, SEND_RF_RELEASE)
                .on(ACTIVE, ABANDON, FREEING, SEND_DEACTIVATE_SACCH, SEND_RF_RELEASE)
                .on(ACTIVE, RELEASE, CLOSING, SEND_DEACTIVATE_SACCH, SEND_RELEASE_REQUEST)
                .on(EnumSet.of(CLOSING), EnumSet.of(LINKS_CLOSED, T3109_EXPIRED), LEAVING, START_T3111)
                .on(LEAVING, T3111_EXPIRED, FREEING, SEND_RF_RELEASE)
                .on(FREEING, FREED, FREE, TELL_FREE)
                .on(FREEING, UNANSWERED, BROKEN)
                // A late answer repairs the channel.
                .on(BROKEN, ACTIVATED, FREEING, SEND_RF_RELEASE)
                .on(BROKEN, FREED, FREE, TELL_FREE);
    }

    private ChannelTable() {}
}
