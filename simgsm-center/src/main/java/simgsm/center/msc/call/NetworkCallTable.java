package simgsm.center.msc.call;

import static simgsm.center.msc.call.NetworkCallTable.NetworkCallAction.*;
import static simgsm.center.msc.call.NetworkCallTable.NetworkCallEvent.*;
import static simgsm.center.msc.call.NetworkCallTable.NetworkCallState.*;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.state.StateTable;

/**
 * Call control of the network (TS 24.008, 5.2 and 5.4). A message without a row is answered with STATUS, any other event
 * without a row is ignored.
 */
public final class NetworkCallTable {
    /**
     * States of a call leg on the network side (TS 24.008, 5.1.1.2). N8 (connect request) and N11 (disconnect request) do not
     * occur, because CONNECT and DISCONNECT are answered at once.
     */
    public enum NetworkCallState {
        /** N0: no call. */
        NULL(0),
        /** N0.1: the called mobile is being paged. */
        MM_CONNECTION_PENDING(2),
        /** N1: the mobile has sent SETUP. */
        CALL_INITIATED(1),
        /** N3: CALL PROCEEDING is sent. */
        CALL_PROCEEDING(3),
        /** N4: ALERTING is sent to the caller. */
        CALL_DELIVERED(4),
        /** N6: SETUP is sent to the called mobile. */
        CALL_PRESENT(6, NetworkTimer.T303),
        /** N7: the called mobile alerts. */
        CALL_RECEIVED(7, NetworkTimer.T301),
        /** N9: the called mobile has confirmed SETUP. */
        CALL_CONFIRMED(9, NetworkTimer.T310),
        /** N10: connected. */
        ACTIVE(10),
        /** N12: DISCONNECT is sent. */
        DISCONNECT_INDICATION(12, NetworkTimer.T305),
        /** N19: RELEASE is sent. */
        RELEASE_REQUEST(19, NetworkTimer.T308),
        /** N28: CONNECT is sent to the caller. */
        CONNECT_INDICATION(28, NetworkTimer.T313);

        private final int code;
        private final NetworkTimer guard;

        NetworkCallState(int code) {
            this(code, null);
        }

        NetworkCallState(int code, NetworkTimer guard) {
            this.code = code;
            this.guard = guard;
        }

        /** The call state of STATUS (TS 24.008, 10.5.4.6). */
        public int code() {
            return code;
        }

        /**
         * The timer of this state.
         *
         * @param withTone true if the network plays a tone to the mobile in it
         */
        Optional<NetworkTimer> guard(boolean withTone) {
            return Optional.ofNullable(withTone && this == DISCONNECT_INDICATION ? NetworkTimer.T306 : guard);
        }

        /** True if speech passes: from CONNECT on, so that none is lost before its acknowledgement. */
        boolean speaks() {
            return this == ACTIVE || this == CONNECT_INDICATION;
        }

        /**
         * True if a tower gives the mobile a traffic channel: from CALL PROCEEDING or CALL CONFIRMED on, so that it is
         * ready when the called party answers.
         */
        boolean needsSpeechPath() {
            return this == CALL_PROCEEDING || this == CALL_CONFIRMED || mayHear();
        }

        /** True if the mobile may hear something: from alerting to the end of clearing. */
        boolean mayHear() {
            return this == CALL_DELIVERED || this == CALL_RECEIVED || this == DISCONNECT_INDICATION || speaks();
        }

        boolean isClearing() {
            return this == NULL || this == DISCONNECT_INDICATION || this == RELEASE_REQUEST;
        }
    }

    /** Events of a call leg on the network side. */
    public enum NetworkCallEvent {
        // From the mobile.
        SETUP_RECEIVED,
        CALL_CONFIRMED_RECEIVED,
        ALERTING_RECEIVED,
        CONNECT_RECEIVED,
        CONNECT_ACKNOWLEDGE_RECEIVED,
        DISCONNECT_RECEIVED,
        RELEASE_RECEIVED,
        RELEASE_COMPLETE_RECEIVED,
        /** STATUS with call state 0: the mobile has no such call (TS 24.008, 8.4). */
        STATUS_NULL_RECEIVED,

        // From the call.
        PAGE,
        PROCEED,
        ALERT,
        ANSWER,
        CLEAR,

        // From the link.
        RADIO_CONNECTED,
        PAGING_FAILED,
        LINK_LOST,

        T301_EXPIRED(NetworkTimer.T301),
        T303_EXPIRED(NetworkTimer.T303),
        T305_EXPIRED(NetworkTimer.T305),
        T306_EXPIRED(NetworkTimer.T306),
        T308_EXPIRED(NetworkTimer.T308),
        /** T308 after the repeated RELEASE. */
        T308_EXPIRED_AGAIN,
        T310_EXPIRED(NetworkTimer.T310),
        T313_EXPIRED(NetworkTimer.T313);

        private final NetworkTimer timer;

        NetworkCallEvent() {
            this(null);
        }

        NetworkCallEvent(NetworkTimer timer) {
            this.timer = timer;
        }

        /** The expiry of a call control timer. */
        static NetworkCallEvent expiryOf(NetworkTimer timer) {
            return Arrays.stream(values())
                    .filter(event -> event.timer == timer)
                    .findFirst()
                    .orElseThrow();
        }
    }

    /** Actions of a call leg on the network side. */
    public enum NetworkCallAction {
        SEND_SETUP,
        SEND_CALL_PROCEEDING,
        SEND_ALERTING,
        SEND_CONNECT,
        SEND_CONNECT_ACKNOWLEDGE,
        SEND_DISCONNECT,
        SEND_RELEASE,
        SEND_RELEASE_COMPLETE,
        /** Restarts the timer of the state, which remains. */
        START_T308,
        /** Plays the network's tone if the last message has announced one. */
        PLAY_TONE,
        // Reports to the call, and through it to the other leg.
        TELL_OFFERED,
        TELL_ALERTING,
        TELL_ANSWERED,
        TELL_ACTIVE,
        TELL_CLEARED
    }

    /** From the first message over the air to the clearing. */
    private static final Set<NetworkCallState> LIVE = EnumSet.of(
            CALL_INITIATED,
            CALL_PROCEEDING,
            CALL_DELIVERED,
            CALL_PRESENT,
            CALL_RECEIVED,
            CALL_CONFIRMED,
            ACTIVE,
            CONNECT_INDICATION);

    private static final Set<NetworkCallState> CLEARING = EnumSet.of(DISCONNECT_INDICATION, RELEASE_REQUEST);

    public static final StateTable<NetworkCallState, NetworkCallEvent, NetworkCallAction> ROWS =
            new StateTable<>("network call", NULL);

    static {
        originating();
        terminating();
        clearingByTheMobile();
        clearingByTheNetwork();
        timersAndLink();
    }

    private NetworkCallTable() {}

    /** 5.2.1. */
    private static void originating() {
        ROWS.on(NULL, SETUP_RECEIVED, CALL_INITIATED, TELL_OFFERED)
                .on(CALL_INITIATED, PROCEED, CALL_PROCEEDING, SEND_CALL_PROCEEDING)
                .on(CALL_PROCEEDING, ALERT, CALL_DELIVERED, SEND_ALERTING, PLAY_TONE)
                .on(EnumSet.of(CALL_PROCEEDING, CALL_DELIVERED), ANSWER, CONNECT_INDICATION, SEND_CONNECT)
                .on(CONNECT_INDICATION, CONNECT_ACKNOWLEDGE_RECEIVED, ACTIVE, TELL_ACTIVE);
    }

    /** 5.2.2. */
    private static void terminating() {
        ROWS.on(NULL, PAGE, MM_CONNECTION_PENDING)
                .on(MM_CONNECTION_PENDING, RADIO_CONNECTED, CALL_PRESENT, SEND_SETUP)
                .on(MM_CONNECTION_PENDING, PAGING_FAILED, NULL, TELL_CLEARED)
                .on(MM_CONNECTION_PENDING, CLEAR, NULL)
                .on(CALL_PRESENT, CALL_CONFIRMED_RECEIVED, CALL_CONFIRMED)
                .on(CALL_CONFIRMED, ALERTING_RECEIVED, CALL_RECEIVED, TELL_ALERTING)
                .on(
                        EnumSet.of(CALL_CONFIRMED, CALL_RECEIVED),
                        CONNECT_RECEIVED,
                        ACTIVE,
                        SEND_CONNECT_ACKNOWLEDGE,
                        TELL_ANSWERED);
    }

    /** 5.4.3. */
    private static void clearingByTheMobile() {
        ROWS.on(LIVE, DISCONNECT_RECEIVED, RELEASE_REQUEST, SEND_RELEASE, TELL_CLEARED)
                .on(LIVE, RELEASE_RECEIVED, NULL, SEND_RELEASE_COMPLETE, TELL_CLEARED)
                .on(LIVE, EnumSet.of(RELEASE_COMPLETE_RECEIVED, STATUS_NULL_RECEIVED), NULL, TELL_CLEARED);
    }

    /** 5.4.4; a call that is not yet accepted is rejected (5.4.2). */
    private static void clearingByTheNetwork() {
        Set<NetworkCallState> accepted = EnumSet.copyOf(LIVE);
        accepted.remove(CALL_INITIATED);
        ROWS.on(accepted, CLEAR, DISCONNECT_INDICATION, SEND_DISCONNECT, PLAY_TONE)
                .on(CALL_INITIATED, CLEAR, NULL, SEND_RELEASE_COMPLETE)
                .on(
                        EnumSet.of(DISCONNECT_INDICATION),
                        EnumSet.of(DISCONNECT_RECEIVED, T305_EXPIRED, T306_EXPIRED),
                        RELEASE_REQUEST,
                        SEND_RELEASE)
                .on(DISCONNECT_INDICATION, RELEASE_RECEIVED, NULL, SEND_RELEASE_COMPLETE)
                .on(EnumSet.of(RELEASE_REQUEST), EnumSet.of(RELEASE_RECEIVED, T308_EXPIRED_AGAIN), NULL)
                .on(RELEASE_REQUEST, T308_EXPIRED, RELEASE_REQUEST, START_T308, SEND_RELEASE)
                .on(CLEARING, EnumSet.of(RELEASE_COMPLETE_RECEIVED, STATUS_NULL_RECEIVED, LINK_LOST), NULL)
                // messages that crossed the network's clearing message
                .stay(CLEARING, CALL_CONFIRMED_RECEIVED)
                .stay(CLEARING, ALERTING_RECEIVED)
                .stay(CLEARING, CONNECT_RECEIVED)
                .stay(CLEARING, CONNECT_ACKNOWLEDGE_RECEIVED)
                .stay(EnumSet.of(RELEASE_REQUEST), DISCONNECT_RECEIVED);
    }

    private static void timersAndLink() {
        expiry(CALL_PRESENT, T303_EXPIRED);
        expiry(CALL_CONFIRMED, T310_EXPIRED);
        expiry(CALL_RECEIVED, T301_EXPIRED);
        expiry(CONNECT_INDICATION, T313_EXPIRED);
        ROWS.on(LIVE, LINK_LOST, NULL, TELL_CLEARED).on(MM_CONNECTION_PENDING, LINK_LOST, NULL, TELL_CLEARED);
    }

    private static void expiry(NetworkCallState state, NetworkCallEvent event) {
        ROWS.on(state, event, DISCONNECT_INDICATION, SEND_DISCONNECT, TELL_CLEARED);
    }
}
