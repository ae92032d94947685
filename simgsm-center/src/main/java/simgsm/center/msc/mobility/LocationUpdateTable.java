package simgsm.center.msc.mobility;

import static simgsm.center.msc.mobility.LocationUpdateTable.LocationUpdateAction.*;
import static simgsm.center.msc.mobility.LocationUpdateTable.LocationUpdateEvent.*;
import static simgsm.center.msc.mobility.LocationUpdateTable.LocationUpdateState.*;

import java.util.EnumSet;
import java.util.Optional;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.state.StateTable;

/** Location updating on the network side (TS 24.008, 4.4.4), with identification (4.3.3) and authentication (4.3.2). */
public final class LocationUpdateTable {
    public enum LocationUpdateState {
        IDLE,
        AWAITING_IMSI(NetworkTimer.T3270),
        /** T3260 runs in {@link CardAuthentication}. */
        AUTHENTICATING,
        AWAITING_IMEI(NetworkTimer.T3270),
        AWAITING_TMSI_COMPLETE(NetworkTimer.T3250),
        ENDED;

        private final NetworkTimer guard;

        LocationUpdateState() {
            this(null);
        }

        LocationUpdateState(NetworkTimer guard) {
            this.guard = guard;
        }

        /** The timer of this state. */
        Optional<NetworkTimer> guard() {
            return Optional.ofNullable(guard);
        }
    }

    public enum LocationUpdateEvent {
        /** The identity is a TMSI that is not assigned. */
        TMSI_UNKNOWN,
        /** The identity is known and needs no authentication. */
        IDENTIFIED,
        /** The identity is known and its card has a key. */
        IDENTIFIED_WITH_KEY,
        AUTHENTICATED,
        /** The card did not have its key, and was identified by a TMSI, possibly another card's. */
        TMSI_WRONG,
        /** The card does not have its key. */
        CARD_REFUSED,
        /** Subscriber and equipment are admitted. */
        ADMITTED,
        TMSI_COMPLETE,
        /** Refused with a reject cause. */
        REFUSED,
        TIMER_EXPIRED,
        /** The radio connection is lost, or a new update begins. */
        CANCELLED
    }

    public enum LocationUpdateAction {
        REQUEST_IMSI,
        REQUEST_AUTHENTICATION,
        REQUEST_IMEI,
        SEND_ACCEPT,
        CONFIRM_TMSI,
        SEND_MM_INFORMATION,
        SEND_REJECT,
        SEND_AUTHENTICATION_REJECT,
        DETACH,
        RELEASE_CHANNEL
    }

    public static final StateTable<LocationUpdateState, LocationUpdateEvent, LocationUpdateAction> ROWS =
            new StateTable<LocationUpdateState, LocationUpdateEvent, LocationUpdateAction>("location update", IDLE)
                    .on(IDLE, TMSI_UNKNOWN, AWAITING_IMSI, REQUEST_IMSI)
                    .on(EnumSet.of(IDLE, AWAITING_IMSI), IDENTIFIED, AWAITING_IMEI, REQUEST_IMEI)
                    .on(EnumSet.of(IDLE, AWAITING_IMSI), IDENTIFIED_WITH_KEY, AUTHENTICATING, REQUEST_AUTHENTICATION)
                    .on(AUTHENTICATING, AUTHENTICATED, AWAITING_IMEI, REQUEST_IMEI)
                    .on(AUTHENTICATING, TMSI_WRONG, AWAITING_IMSI, REQUEST_IMSI)
                    .on(
                            EnumSet.of(AWAITING_IMSI, AUTHENTICATING),
                            CARD_REFUSED,
                            ENDED,
                            SEND_AUTHENTICATION_REJECT,
                            DETACH,
                            RELEASE_CHANNEL)
                    .on(AWAITING_IMEI, ADMITTED, AWAITING_TMSI_COMPLETE, SEND_ACCEPT)
                    .on(
                            AWAITING_TMSI_COMPLETE,
                            TMSI_COMPLETE,
                            ENDED,
                            CONFIRM_TMSI,
                            SEND_MM_INFORMATION,
                            RELEASE_CHANNEL)
                    .on(
                            EnumSet.of(IDLE, AWAITING_IMSI, AUTHENTICATING, AWAITING_IMEI),
                            REFUSED,
                            ENDED,
                            SEND_REJECT,
                            RELEASE_CHANNEL)
                    .on(
                            EnumSet.of(AWAITING_IMSI, AWAITING_IMEI, AWAITING_TMSI_COMPLETE),
                            TIMER_EXPIRED,
                            ENDED,
                            RELEASE_CHANNEL)
                    .on(EnumSet.complementOf(EnumSet.of(ENDED)), CANCELLED, ENDED);

    private LocationUpdateTable() {}
}
